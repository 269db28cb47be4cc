// SPDX-License-Identifier: MIT
// Fast bodies that spin and fly at each other: does none pass another without a contact?
#include <algorithm>
#include <cmath>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "cases.h"
#include "catch.h"
#include "numbers.h"

namespace plumb::test {

namespace {

/// A shape around its centre of mass, and the radius of the largest disc in it around that centre [m].
struct Spinner {
    ShapeDef shape;
    double inner = 0;
};

Spinner randomSpinner(Random& random, const Material& material) {
    const double size = random.uniform(0.1, 0.5), wide = size * random.uniform(0.2, 1);
    switch (random.integer(0, 4)) {
        case 0: return {circle(size, material), size};
        case 1: return {box({size, wide}, material), wide};
        case 2: return {capsule({-size, 0}, {size, 0}, wide, material), wide};
        case 3: return {box({size, 0.1 * size}, material), 0.1 * size};
        default: break;
    }
    const int corners = random.integer(3, 8);
    std::vector<Vec2> outline;
    for (int i = 0; i < corners; ++i)
        outline.push_back(size * Vec2(std::cos(2 * pi * i / corners), std::sin(2 * pi * i / corners)));
    return {polygon(outline, material), size * std::cos(pi / corners)};
}

/// The least distance of two centres, if both move straight on in a step.
double leastDistance(const Vec2& before, const Vec2& after) {
    const Vec2 moved = after - before;
    const double squared = moved.squaredNorm();
    const double time = squared > 0 ? std::clamp(-before.dot(moved) / squared, 0.0, 1.0) : 0;
    return (before + moved * time).norm();
}

/// Do the inner discs of two bodies overlap between two poses before a contact is told?
bool passes(std::uint64_t seed) {
    Random random(seed);
    World world({.gravity = {0, random.integer(0, 1) == 0 ? -9.81 : 0}});
    const Material material{.friction = random.integer(0, 1) == 0 ? 0.5 : 0,
                            .restitution = random.integer(0, 2) == 0 ? 0.3 : 0};
    const double speed = random.uniform(20, 200), apart = random.uniform(1, 5), spin = random.uniform(0, 300);
    const double dt = 1.0 / (30 << random.integer(0, 2));
    const Spinner left = randomSpinner(random, material), right = randomSpinner(random, material);
    const auto add = [&](const Spinner& spinner, const Vec2& at, double velocity) {
        return world.add({.position = at,
                          .angle = random.uniform(-3, 3),
                          .velocity = {velocity, 0},
                          .angularVelocity = random.uniform(-1, 1) * spin,
                          .shapes = {spinner.shape}});
    };
    const BodyId a = add(left, {-apart, random.uniform(-0.03, 0.03)}, speed);
    const BodyId b = add(right, {apart, 0}, -speed * random.uniform(0, 1));
    const auto between = [&] { return Vec2(world.body(b).centerOfMass() - world.body(a).centerOfMass()); };
    for (int tick = 0; tick < 40; ++tick) {
        const Vec2 before = between();
        world.step(dt);
        if (!world.contactBegins().empty() || !world.contactHits().empty()) return false;
        if (leastDistance(before, between()) < left.inner + right.inner) return true;
    }
    return false;
}

}  // namespace

TEST_CASE("of 20,000 fast pairs that spin by up to 300 rad/s none passes the other", "[dynamics][spinning]") {
    const int pairs = cases(20000);
    for (int seed = 1; seed <= pairs; ++seed) {
        INFO("seed " << seed);
        CHECK_FALSE(passes(static_cast<std::uint64_t>(seed)));
    }
}

}  // namespace plumb::test
