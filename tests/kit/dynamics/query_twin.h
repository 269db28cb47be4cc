// SPDX-License-Identifier: MIT
// What does a world that is stepped and edited answer to queries? By a twin that knows each shape, and looks at all of
// them through the Minkowski difference.
#pragma once
#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include <plumb/dynamics/world.h>
#include <plumb/math/random.h>

#include "kit/collide/casts.h"
#include "kit/collide/placements.h"

namespace plumb::test {

using ::pointOf;
using casts::Case;
using minkowski::Outline;
using minkowski::Point;

/// What is there, as the test knows it: a shape by its pieces, where its body says that it is.
struct Known {
    ShapeId id;
    std::vector<Outline> pieces;
    Filter filter;
    bool sensor = false;
    Point middle;       ///< of a disc around all of it
    double reach = 0;   ///< its radius [m]
    double number = 0;  ///< largest coordinate [m]
};

inline bool letsThrough(const Filter& a, const Filter& b) {
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.category & b.mask) && (b.category & a.mask);
}

inline std::vector<Outline> piecesAt(const Shape& shape, const Transform& pose) {
    const auto* chain = std::get_if<Chain>(&shape);
    if (!chain) return {outlineOf(shape, pose)};
    std::vector<Outline> pieces;
    const std::size_t count = chain->points.size();
    for (std::size_t i = 0; i + (chain->closed ? 0 : 1) < count; ++i)
        pieces.push_back(outlineOf(Segment{chain->points[i], chain->points[(i + 1) % count]}, pose));
    return pieces;
}

inline Known knownOf(const ShapeId& id, const ShapeDef& def, const Transform& pose) {
    Known known{id, piecesAt(def.shape, pose), def.filter, def.sensor, {}, 0, 0};
    known.middle = known.pieces[0].corners[0];
    for (const Outline& piece : known.pieces) {
        for (const Point p : piece.corners) {
            known.reach = std::max(known.reach, length(p - known.middle) + piece.radius);
            known.number = std::max({known.number, std::fabs(p.x), std::fabs(p.y)});
        }
    }
    known.number += known.reach;
    return known;
}

struct Mover {
    Outline outline;
    Vec2 shift{0, 0};
};

/// The disc around a shape is farther from all that the mover comes by than it may be.
inline bool isOutOfReach(const Known& known, const Mover& mover) {
    const Point from = mover.outline.corners[0];
    double reach = known.reach + mover.outline.radius + 0.01;
    for (const Point p : mover.outline.corners) reach = std::max(reach, length(p - from) + known.reach + 0.01);
    return length(known.middle - minkowski::nearestOnSegment(known.middle, from, pointOf(mover.shift))) >
           reach + mover.outline.radius;
}

inline Case caseOf(const Outline& piece, const Known& known, const Mover& mover, double part = 1) {
    Case c{piece, mover.outline, pointOf(mover.shift) * part, known.number};
    double number = 0;
    for (const Point p : mover.outline.corners) number = std::max({number, std::fabs(p.x), std::fabs(p.y)});
    c.size += number + mover.outline.radius + mover.shift.cwiseAbs().maxCoeff();
    return c;
}

/// The gap's least value, over pieces, up to a part of the way: nowhere may it be less than nothing.
inline bool isMetBefore(const Known& known, const Mover& mover, double part) {
    if (isOutOfReach(known, mover)) return false;
    return std::any_of(known.pieces.begin(), known.pieces.end(),
                       [&](const Outline& piece) { return surelyMeet(caseOf(piece, known, mover, part)); });
}

inline bool isRightlyMet(const Known& known, const Mover& mover, const CastHit& hit) {
    return std::any_of(known.pieces.begin(), known.pieces.end(), [&](const Outline& piece) {
        return faultOf(caseOf(piece, known, mover), CastPoint{hit.point, hit.normal, hit.fraction}) == nullptr;
    });
}

/// A little world that is stepped and edited, and everything in it told to a twin.
class Twin {
public:
    explicit Twin(std::uint64_t seed)
        : random(seed),
          world({.gravity = {0, seed % 3 == 0 ? 0.0 : -9.81}, .solver = {.lanes = std::array{1, 4, 8, 16}[seed % 4]}}) {
        for (int i = 0; i < 30; ++i) add();
    }

    void change() {
        for (int i = random.integer(0, 3); i > 0; --i) add();
        for (int i = random.integer(0, 3); i > 0 && bodies_.size() > 10; --i) remove();
        for (int i = random.integer(0, 2); i > 0; --i) jump();
        if (random.integer(0, 4) > 0)
            for (int i = random.integer(1, 3); i > 0; --i) world.step(random.integer(0, 3) ? 1.0 / 60 : 0.1);
        if (random.integer(0, 3) == 0) jump();
        look();
    }

    Filter anyFilter() {
        if (random.integer(0, 2) > 0) return {};
        Filter filter;
        filter.category = std::uint64_t{1} << random.integer(0, 2);
        filter.mask = static_cast<std::uint64_t>(random.integer(1, 7));
        filter.group = random.integer(-2, 2);
        return filter;
    }
    Shape anyShape() {
        const Kind kind = randomKind(random);
        return randomShape(random, kind, random.uniform(0.2, 1));
    }
    Transform anyPose() {
        const Vec2 place = randomVec2(random, size);
        return {place, turnBy(random.integer(0, 3) ? random.uniform(-3, 3) : 0.0)};
    }

    static constexpr double size = 8;
    Random random;
    World world;
    std::vector<Known> shapes;

private:
    struct Body {
        BodyId id;
        std::vector<ShapeDef> shapes;
    };

    ShapeDef anyShapeDef(bool massive) {
        ShapeDef def{.shape = anyShape(), .material = {.restitution = random.uniform(0, 1)}, .filter = anyFilter()};
        if (!massive && random.integer(0, 4) == 0) {
            std::vector<Vec2> points;
            for (int i = 0; i < 5; ++i) points.push_back(randomVec2(random, 2));
            def.shape = Chain{points, random.integer(0, 1) == 0};
        }
        if (massive && std::holds_alternative<Segment>(def.shape)) def.shape = Circle{random.uniform(0.1, 0.5)};
        def.sensor = random.integer(0, 9) == 0;
        return def;
    }
    void add() {
        BodyDef def;
        def.type = static_cast<BodyType>(random.integer(0, 2));
        def.position = randomVec2(random, size);
        def.angle = random.integer(0, 3) ? random.uniform(-3, 3) : 0;
        if (def.type != BodyType::Static) def.velocity = randomVec2(random, 20);
        if (def.type != BodyType::Static) def.angularVelocity = random.uniform(-9, 9);
        const bool massive = def.type == BodyType::Dynamic;
        for (int i = random.integer(0, 2); i >= 0; --i) def.shapes.push_back(anyShapeDef(massive));
        bodies_.push_back({world.add(def), def.shapes});
    }
    std::size_t anyBody() { return static_cast<std::size_t>(random.integer(0, static_cast<int>(bodies_.size()) - 1)); }
    void remove() {
        const std::size_t i = anyBody();
        world.remove(bodies_[i].id);
        bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(i));
    }
    void jump() {
        const Vec2 place = randomVec2(random, size);
        const double angle = random.uniform(-3, 3);
        world.body(bodies_[anyBody()].id).setPose(place, angle);
    }
    void look() {
        shapes.clear();
        for (const Body& body : bodies_) {
            const Transform pose = world.body(body.id).pose();
            for (std::uint32_t i = 0; i < body.shapes.size(); ++i)
                shapes.push_back(knownOf({body.id, i}, body.shapes[i], pose));
        }
        std::sort(shapes.begin(), shapes.end(), [](const Known& a, const Known& b) {
            return std::pair(a.id.body.index, a.id.number) < std::pair(b.id.body.index, b.id.number);
        });
    }

    std::vector<Body> bodies_;
};

inline bool isSeen(const Known& known, const Filter& filter) {
    return !known.sensor && letsThrough(known.filter, filter);
}

inline const char* faultOfFirst(const Twin& twin, const Mover& mover, const Filter& filter,
                                const std::optional<CastHit>& hit) {
    const double part = hit ? hit->fraction * (1 - 1e-9) : 1;
    bool known = !hit;
    for (const Known& shape : twin.shapes) {
        const bool seen = isSeen(shape, filter);
        if (hit && shape.id == hit->shape) {
            known = true;
            if (!seen) return "found what the filter lets not through";
            if (!isRightlyMet(shape, mover, *hit)) return "the hit is not right";
        }
        if (!seen || !isMetBefore(shape, mover, part)) continue;
        if (part > 0) return "another is met before";
        // Of those that it begins in, the first is found.
        const auto rank = [](const ShapeId& id) { return std::pair(id.body.index, id.number); };
        if (rank(shape.id) < rank(hit->shape)) return "it begins in another";
    }
    return known ? nullptr : "found what is not there";
}

inline bool isAfter(const CastHit& a, const CastHit& b) {
    return std::tuple(a.fraction, a.shape.body.index, a.shape.number) >
           std::tuple(b.fraction, b.shape.body.index, b.shape.number);
}

inline const char* faultOfAll(const Twin& twin, const Mover& mover, const Filter& filter,
                              const std::vector<CastHit>& hits) {
    std::size_t found = 0;
    for (const Known& shape : twin.shapes) {
        const auto isIt = [&](const CastHit& hit) { return hit.shape == shape.id; };
        const auto times = std::count_if(hits.begin(), hits.end(), isIt);
        found += static_cast<std::size_t>(times);
        if (times > 1) return "found twice";
        if (times == 1 && !isSeen(shape, filter)) return "found what the filter lets not through";
        const auto hit = std::find_if(hits.begin(), hits.end(), isIt);
        if (times == 1 && !isRightlyMet(shape, mover, *hit)) return "a hit is not right";
        if (!isSeen(shape, filter) || (times == 1 && hit->fraction == 0)) continue;
        if (isMetBefore(shape, mover, times == 1 ? hit->fraction * (1 - 1e-9) : 1)) return "missed, or met before";
    }
    if (std::is_sorted(hits.begin(), hits.end(), [](const CastHit& a, const CastHit& b) { return isAfter(b, a); }))
        return found == hits.size() ? nullptr : "found what is not there";
    return "not in order";
}

inline double gapTo(const Known& shape, const Outline& outline) {
    double least = std::numeric_limits<double>::infinity();
    for (const Outline& piece : shape.pieces) least = std::min(least, gapBetween(piece, outline).separation);
    return least;
}

inline const char* faultOfOverlaps(const Twin& twin, const Outline& outline, const Filter& filter,
                                   const std::vector<ShapeId>& found) {
    auto next = found.begin();
    for (const Known& shape : twin.shapes) {
        const bool listed = next != found.end() && *next == shape.id;
        if (listed) ++next;
        if (listed && !isSeen(shape, filter)) return "found what the filter lets not through";
        if (!isSeen(shape, filter)) continue;
        if (!listed && isOutOfReach(shape, {outline})) continue;
        const double tolerance = toleranceOf(caseOf(shape.pieces[0], shape, {outline}));
        const double gap = gapTo(shape, outline);
        if (listed && gap > tolerance) return "found what does not overlap";
        if (!listed && gap < -tolerance) return "missed what overlaps";
    }
    return next == found.end() ? nullptr : "not in order, or found what is not there";
}

inline const char* faultOfNearest(const Twin& twin, const Vec2& point, double within, const Filter& filter,
                                  const std::optional<Nearest>& nearest) {
    const Outline outline{{pointOf(point)}, 0};
    double least = std::numeric_limits<double>::infinity(), itself = least, tolerance = 0;
    for (const Known& shape : twin.shapes) {
        if (!isSeen(shape, filter)) continue;
        const double gap = gapTo(shape, outline);
        least = std::min(least, gap);
        if (nearest && shape.id == nearest->shape) itself = gap;
        tolerance = std::max(tolerance, toleranceOf(caseOf(shape.pieces[0], shape, {outline})));
    }
    if (!nearest) return least < within - tolerance ? "missed" : nullptr;
    if (itself > least + tolerance) return "another is nearer";
    if (nearest->separation > within) return "farther than was asked for";
    if (std::fabs(nearest->separation - itself) > tolerance) return "the separation is not the gap";
    const Vec2 back = nearest->point + nearest->normal * nearest->separation - point;
    return back.norm() > tolerance ? "the point is not a separation away" : nullptr;
}

}  // namespace plumb::test
