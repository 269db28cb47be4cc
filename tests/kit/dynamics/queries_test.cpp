// SPDX-License-Identifier: MIT
#include <plumb/dynamics/world.h>

#include "cases.h"
#include "catch.h"
#include "kit/dynamics/query_twin.h"

namespace plumb::test {

namespace {

struct Asked {
    const char* fault = nullptr;
    bool found = false;
};

Vec2 anywhere(Twin& twin) {
    return randomVec2(twin.random, 1.5 * twin.size);
}

Asked twinRay(Twin& twin) {
    const Filter filter = twin.anyFilter();
    Vec2 from = anywhere(twin), to = anywhere(twin);
    const int kind = twin.random.integer(0, 9);
    if (kind == 0) to = from;
    if (kind == 1) to = from + 1e5 * (to - from);
    if (kind == 2) to.y() = from.y();
    if (kind == 3) {  // along an edge, or through a corner
        const Known& shape =
            twin.shapes[static_cast<std::size_t>(twin.random.integer(0, static_cast<int>(twin.shapes.size()) - 1))];
        const std::vector<Point>& corners = shape.pieces[0].corners;
        const Vec2 first(corners[0].x, corners[0].y), last(corners.back().x, corners.back().y);
        to = last + (last - first);
        if (first != last) from = first + (first - last);
    }
    const Mover mover{{{pointOf(from)}, 0}, to - from};
    if (twin.random.integer(0, 1) == 0) {
        const std::optional<CastHit> hit = twin.world.castRay(from, to, filter);
        return {faultOfFirst(twin, mover, filter, hit), hit.has_value()};
    }
    const std::vector<CastHit> hits = twin.world.castRayAll(from, to, filter);
    return {faultOfAll(twin, mover, filter, hits), !hits.empty()};
}

Asked twinShape(Twin& twin) {
    const Filter filter = twin.anyFilter();
    const Shape shape = twin.anyShape();
    const Transform pose = twin.anyPose();
    const Vec2 shift = twin.random.integer(0, 9) ? anywhere(twin) : Vec2(0, 0);
    const Mover mover{outlineOf(shape, pose), shift};
    if (twin.random.integer(0, 1) == 0) {
        const std::optional<CastHit> hit = twin.world.castShape(shape, pose, shift, filter);
        return {faultOfFirst(twin, mover, filter, hit), hit.has_value()};
    }
    const std::vector<CastHit> hits = twin.world.castShapeAll(shape, pose, shift, filter);
    return {faultOfAll(twin, mover, filter, hits), !hits.empty()};
}

Asked twinOverlaps(Twin& twin) {
    const Filter filter = twin.anyFilter();
    const Vec2 corner = anywhere(twin);
    std::vector<ShapeId> found;
    Outline outline;
    switch (twin.random.integer(0, 3)) {
        case 0: {
            const Shape shape = twin.anyShape();
            const Transform pose = twin.anyPose();
            outline = outlineOf(shape, pose);
            found = twin.world.overlapShape(shape, pose, filter);
            break;
        }
        case 1: {
            outline.corners = {pointOf(corner)};
            found = twin.world.overlapPoint(corner, filter);
            break;
        }
        default: {
            Vec2 size = randomVec2(twin.random, 2).cwiseAbs();
            if (twin.random.integer(0, 5) == 0) size.x() = 0;
            if (twin.random.integer(0, 5) == 0) size.y() = 0;
            const Vec2 end = corner + size;
            outline.corners = {pointOf(corner), {end.x(), corner.y()}, pointOf(end), {corner.x(), end.y()}};
            found = twin.world.overlapBox({corner, end}, filter);
        }
    }
    return {faultOfOverlaps(twin, outline, filter, found), !found.empty()};
}

Asked twinNearest(Twin& twin) {
    const Filter filter = twin.anyFilter();
    const Vec2 point = anywhere(twin);
    const int kind = twin.random.integer(0, 5);
    double within = twin.random.uniform(0, 3);
    if (kind == 0) within = 0;
    if (kind == 1) within = std::numeric_limits<double>::infinity();
    const std::optional<Nearest> nearest = twin.world.nearest(point, within, filter);
    return {faultOfNearest(twin, point, within, filter, nearest), nearest.has_value()};
}

Asked twinDistance(Twin& twin) {
    const auto any = [&]() -> const Known& {
        return twin.shapes[static_cast<std::size_t>(twin.random.integer(0, static_cast<int>(twin.shapes.size()) - 1))];
    };
    const Known& a = any();
    const Known& b = any();
    double least = std::numeric_limits<double>::infinity();
    for (const Outline& piece : b.pieces) least = std::min(least, gapTo(a, piece));
    const Distance distance = twin.world.distance(a.id, b.id);
    const double tolerance = 30 * std::numeric_limits<double>::epsilon() / 2 * (a.number + b.number);
    return {std::fabs(distance.separation - least) > tolerance ? "not the gap" : nullptr, true};
}

struct Tally {
    int asked = 0, found = 0, faults = 0;
    std::string first;
};

Tally tallyOf(Asked (*ask)(Twin&), int worlds) {
    Tally tally;
    for (int w = 0; w < worlds; ++w) {
        Twin twin(static_cast<std::uint64_t>(w) + 1);
        for (int change = 0; change < 20; ++change) {
            twin.change();
            for (int i = 0; i < 50; ++i) {
                const Asked asked = ask(twin);
                ++tally.asked;
                tally.found += asked.found;
                if (!asked.fault || tally.faults++ > 0) continue;
                tally.first = asked.fault + (" in world " + std::to_string(w)) + ", change " + std::to_string(change) +
                              ", question " + std::to_string(i);
            }
        }
    }
    return tally;
}

/// 1,000 questions in each of so many worlds; in fewer of them under sanitizers.
void checkTwin(Asked (*ask)(Twin&), int worlds) {
    const Tally tally = tallyOf(ask, allCases(worlds));
    INFO(tally.faults << " faults, the first: " << tally.first);
    CHECK(tally.faults == 0);
    CHECK(tally.asked == 1000 * allCases(worlds));
    CHECK(tally.found > leastOf(100 * worlds));
}

}  // namespace

TEST_CASE("30,000 rays through worlds that are stepped and edited meet what the Minkowski twin says", "[dynamics]") {
    checkTwin(twinRay, 30);
}

TEST_CASE("10,000 shapes shifted through such worlds meet what the Minkowski twin says", "[dynamics]") {
    checkTwin(twinShape, 10);
}

TEST_CASE("35,000 boxes, shapes and points overlap what the Minkowski twin says", "[dynamics]") {
    checkTwin(twinOverlaps, 35);
}

TEST_CASE("the nearest shapes to 15,000 points are those of the Minkowski twin", "[dynamics]") {
    checkTwin(twinNearest, 15);
}

TEST_CASE("10,000 distances between shapes of a world are those of the Minkowski twin", "[dynamics]") {
    checkTwin(twinDistance, 10);
}

}  // namespace plumb::test
