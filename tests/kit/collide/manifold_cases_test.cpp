// SPDX-License-Identifier: MIT
// Placements whose manifold can be told by hand, and what must not change from step to step.
#include <plumb/collide/manifold.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/math/random.h>

#include "catch.h"

namespace {

using namespace plumb;

Convex boxOf(double halfWidth, double halfHeight) {
    return convexOf(boxPolygon({halfWidth, halfHeight}), {0, 0});
}

Convex lineOf(double fromX, double toX) {
    return convexOf(Segment{{fromX, 0}, {toX, 0}}, {0, 0});
}

Convex capsuleOf(double halfLength, double radius) {
    return convexOf(Capsule{{-halfLength, 0}, {halfLength, 0}, radius}, {0, 0});
}

RelativePose at(double x, double y, double angle = 0) {
    return {{static_cast<float>(x), static_cast<float>(y)},
            static_cast<float>(std::cos(angle)),
            static_cast<float>(std::sin(angle))};
}

/// Features in order, so that the order of the points does not matter.
std::array<int, 2> featuresOf(const Manifold& m) {
    std::array<int, 2> features{m.points[0].feature, m.points[1].feature};
    std::sort(features.begin(), features.end());
    return features;
}

constexpr float noise = 1e-6f;  // a few roundings of numbers about 1

}  // namespace

TEST_CASE("a 1 m box 2 mm above a 10 m floor has a point under each of its lower corners", "[collide]") {
    const Manifold m = manifold(lineOf(-5, 5), boxOf(0.5, 0.5), at(2, 0.502), 0.01f);
    REQUIRE(m.count == 2);
    CHECK(m.normal == Vec2f(0, 1));
    for (const ManifoldPoint& point : m.points) {
        CHECK(std::fabs(point.separation - 0.002f) < noise);
        CHECK(std::fabs(point.position.y() - 0.001f) < noise);
    }
    CHECK(std::fabs(m.points[0].position.x() + m.points[1].position.x() - 4) < noise);
    CHECK(std::fabs(std::fabs(m.points[0].position.x() - m.points[1].position.x()) - 1) < noise);
}

TEST_CASE("a segment pushes up what is above it and down what is below it", "[collide]") {
    for (const double side : {1.0, -1.0}) {
        const Manifold box = manifold(lineOf(-5, 5), boxOf(0.5, 0.5), at(0, side * 0.45), 0);
        CHECK(box.count == 2);
        CHECK(box.normal == Vec2f(0, static_cast<float>(side)));
        CHECK(std::fabs(box.points[0].separation + 0.05f) < noise);
        const Manifold ball = manifold(lineOf(-5, 5), convexOf(Circle{0.5}, {0, 0}), at(0, side * 0.45), 0);
        CHECK(ball.count == 1);
        CHECK(ball.normal == Vec2f(0, static_cast<float>(side)));
        CHECK(std::fabs(ball.points[0].separation + 0.05f) < noise);
    }
}

TEST_CASE("two boxes corner to corner, 0.3 m across and 0.4 m up, have one point half way at 0.5 m", "[collide]") {
    const Manifold m = manifold(boxOf(1, 1), boxOf(1, 1), at(2.3, 2.4), 1);
    REQUIRE(m.count == 1);
    CHECK((m.normal - Vec2f(0.6f, 0.8f)).norm() < noise);
    CHECK(std::fabs(m.points[0].separation - 0.5f) < noise);
    CHECK((m.points[0].position - Vec2f(1.15f, 1.2f)).norm() < noise);
    CHECK(manifold(boxOf(1, 1), boxOf(1, 1), at(2.3, 2.4), 0.49f).count == 0);
}

TEST_CASE("segments in line meet end to end, not along their sides", "[collide]") {
    for (const double tilt : {0.0, 1e-7, -1e-4}) {
        const Manifold m = manifold(lineOf(-1, 1), lineOf(-1, 1), at(2.25, 0, tilt), 1);
        REQUIRE(m.count == 1);
        CHECK(std::fabs(m.points[0].separation - 0.25f) < 2 * noise);
        CHECK((m.normal - Vec2f(1, 0)).norm() < 1e-3f);
    }
    const Manifold capsules = manifold(capsuleOf(1, 0.2), capsuleOf(1, 0.2), at(2.25, 0), 0);
    REQUIRE(capsules.count == 1);
    CHECK(std::fabs(capsules.points[0].separation + 0.15f) < noise);
    CHECK(capsules.normal == Vec2f(1, 0));
}

TEST_CASE("a capsule of 0.25 m radius lying 0.3 m above a floor has two points at 0.05 m, standing it has one",
          "[collide]") {
    const Manifold lying = manifold(lineOf(-5, 5), capsuleOf(0.5, 0.25), at(0, 0.3), 0.1f);
    REQUIRE(lying.count == 2);
    for (const ManifoldPoint& point : lying.points) CHECK(std::fabs(point.separation - 0.05f) < noise);
    const Manifold standing = manifold(lineOf(-5, 5), capsuleOf(0.5, 0.25), at(0, 0.8, std::acos(0.0)), 10);
    REQUIRE(standing.count == 1);
    CHECK(std::fabs(standing.points[0].separation - 0.05f) < noise);
}

TEST_CASE("two faces share two points just when they overlap by a stretch whose ends are within the margin",
          "[collide]") {
    // A box 2 m wide stands with its lower left corner on the top of another, tilted up from there. The stretch ends at
    // the lower edge's end or the tilted one's, whichever comes first, and is tan(tilt) times its length high there.
    constexpr double margin = 0.05;
    int two = 0, one = 0;
    for (int i = 0; i < 60; ++i) {
        for (int j = 0; j < 60; ++j) {
            const double corner = -0.99 + 1.97 * j / 59, tilt = 0.001 + 0.2 * i / 59;
            const double length = std::min(1 - corner, 2 * std::cos(tilt)), high = std::tan(tilt) * length;
            if (std::fabs(high - margin) < 1e-5) continue;  // rounding decides
            const double x = corner + std::cos(tilt) - std::sin(tilt), y = 1 + std::sin(tilt) + std::cos(tilt);
            const Manifold m = manifold(boxOf(1, 1), boxOf(1, 1), at(x, y, tilt), static_cast<float>(margin));
            const int expected = high < margin ? 2 : 1;
            if (m.count != expected) FAIL("corner at " << corner << ", tilt " << tilt << ": " << m.count << " points");
            ++(expected == 2 ? two : one);
        }
    }
    CHECK(two > 1000);
    CHECK(one > 1000);
}

TEST_CASE("a box on its like, trembling by 1e-6 m and 1e-4 rad, keeps its normal and features for 10,000 steps",
          "[collide]") {
    // Tilted by 1e-4 over a shift of 0.25 m, the upper face does better than the lower by up to 2.5e-5 m: not by 1e-4.
    const Convex box = boxOf(0.5, 0.5);
    Random random(1);
    for (const double shift : {0.0, 0.25}) {
        const std::array<int, 2> features = featuresOf(manifold(box, box, at(shift, 1), 0.01f));
        CHECK(features[0] != features[1]);
        int changed = 0;
        for (int i = 0; i < 10'000; ++i) {
            const double x = shift + random.uniform(-1e-6, 1e-6), y = 1 + random.uniform(-1e-6, 1e-6);
            const Manifold m = manifold(box, box, at(x, y, random.uniform(-1e-4, 1e-4)), 0.01f);
            changed += m.count != 2 || m.normal != Vec2f(0, 1) || featuresOf(m) != features;
        }
        CHECK(changed == 0);
    }
}

TEST_CASE("a box tilting by 1e-4 keeps its features on a floor of 10 m and of 1,000 m, whichever is A", "[collide]") {
    // The face of either may do for both; the points are the box's corners all the same.
    const Convex box = boxOf(0.5, 0.5);
    Random random(2);
    for (const double length : {10.0, 1000.0}) {
        const Convex floor = lineOf(-length / 2, length / 2);
        const std::array<int, 2> onFloor = featuresOf(manifold(floor, box, at(1, 0.5), 0.01f));
        const std::array<int, 2> underBox = featuresOf(manifold(box, floor, at(1, -0.5), 0.01f));
        int changed = 0;
        for (int i = 0; i < 1000; ++i) {
            const double tilt = random.uniform(-1e-4, 1e-4);
            const Manifold a = manifold(floor, box, at(1, 0.5, tilt), 0.01f);
            changed += a.count != 2 || featuresOf(a) != onFloor;
            const Manifold b = manifold(box, floor, at(-std::cos(tilt), -0.5, tilt), 0.01f);
            changed += b.count != 2 || featuresOf(b) != underBox;
        }
        CHECK(changed == 0);
    }
}

TEST_CASE("a box that slides over the end of its floor keeps the feature of the corner that stays on", "[collide]") {
    const Convex floor = lineOf(-5, 5), box = boxOf(0.5, 0.5);
    const std::array<int, 2> whole = featuresOf(manifold(floor, box, at(1, 0.5), 0.01f));
    const std::array<int, 2> half = featuresOf(manifold(floor, box, at(5, 0.5), 0.01f));
    CHECK(std::count(whole.begin(), whole.end(), half[0]) + std::count(whole.begin(), whole.end(), half[1]) == 1);
    for (int i = 100; i < 549; ++i) {
        const Manifold m = manifold(floor, box, at(0.01 * i, 0.499), 0.01f);
        REQUIRE(m.count == 2);
        REQUIRE(featuresOf(m) == (i <= 450 ? whole : half));
    }
}

TEST_CASE("a box that tips over its corner from 1 to 89 degrees keeps that corner's feature", "[collide]") {
    const Convex floor = lineOf(-5, 5), box = boxOf(0.5, 0.5);
    const double radius = std::sqrt(0.5), quarter = std::acos(0.0);
    std::uint16_t feature = 0;
    for (int i = 1; i <= 89; ++i) {
        const double tilt = quarter * i / 90;
        const Manifold m = manifold(floor, box, at(0, radius * std::sin(quarter / 2 + tilt) - 0.001, tilt), 0.01f);
        REQUIRE(m.count == 1);
        CHECK(std::fabs(m.points[0].separation + 0.001f) < noise);
        if (i == 1) feature = m.points[0].feature;
        REQUIRE(m.points[0].feature == feature);
    }
}

TEST_CASE("a ball that rolls over a box's corner keeps its feature, and its normal turns without a jump", "[collide]") {
    const Convex box = boxOf(1, 1), ball = convexOf(Circle{0.5}, {0, 0});
    const std::uint16_t feature = manifold(box, ball, at(0, 1.5), 0.01f).points[0].feature;
    Vec2f before(0, 1);
    for (int i = 0; i <= 1000; ++i) {
        // Along the top, round the corner by a quarter turn, down the side: 1 mm and 1.6 mrad a step at most.
        const double angle = std::clamp((i - 250) / 500.0, 0.0, 1.0) * std::acos(0.0);
        const double x = std::min(1.0, i / 250.0), y = std::min(1.0, (1000 - i) / 250.0);
        const double height = 1 - (i > 750 ? 1 - y : 0.0);
        const Manifold m = manifold(box, ball, at(x + 0.5 * std::sin(angle), height + 0.5 * std::cos(angle)), 0.01f);
        REQUIRE(m.count == 1);
        REQUIRE(m.points[0].feature == feature);
        REQUIRE(std::fabs(m.points[0].separation) < 2 * noise);
        // 3.2 mrad a step, and a direction over 0.5 m that is as good as the place.
        REQUIRE((m.normal - before).norm() < 0.0032f + 4 * noise);
        before = m.normal;
    }
}

TEST_CASE("a box 400 m along a 1,000 m floor has its separation to 1e-6 m", "[collide]") {
    const Manifold m = manifold(lineOf(-500, 500), boxOf(0.5, 0.5), at(400, 0.501), 0.01f);
    REQUIRE(m.count == 2);
    for (const ManifoldPoint& point : m.points) CHECK(std::fabs(point.separation - 0.001f) < noise);
}

TEST_CASE("a place that is not a number, or infinite, makes no contact", "[collide]") {
    const std::array shapes{boxOf(1, 1), lineOf(-1, 1), capsuleOf(1, 0.1), convexOf(Circle{0.5}, {0, 0})};
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        for (const Convex& a : shapes) {
            for (const Convex& b : shapes) {
                CHECK(manifold(a, b, {{bad, 0}, 1, 0}, 1).count == 0);
                CHECK(manifold(a, b, {{0, bad}, 1, 0}, 1).count == 0);
            }
        }
    }
}
