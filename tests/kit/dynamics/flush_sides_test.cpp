// SPDX-License-Identifier: MIT
#include <cmath>
#include <numbers>

#include <plumb/dynamics/contacts/floors/flush_sides.h>
#include <plumb/math/random.h>

#include "catch.h"

namespace {

using namespace plumb;

Vec2f directionAt(double angle) {
    return {static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))};
}

/// Two loose bodies.
struct Two {
    BodyStore bodies;
    ContactGraph graph;
    BodyIndex a = bodies.acquire(), b = bodies.acquire();

    Two() { bodies.velocity[a].inverseMass = bodies.velocity[b].inverseMass = 1; }
};

}  // namespace

TEST_CASE("what lies along a face is found at any angle, and what lies beside the body elsewhere is not it",
          "[dynamics][property]") {
    Two two;
    FlushSides flush;
    Random random(41);
    const double degree = std::numbers::pi / 180;
    for (int round = 0; round < 20'000; ++round) {
        // The body's angle, and the directions of its face and of a contact's normal in its frame.
        const double angle = random.uniform(-3, 3), face = random.uniform(-3, 3), normal = random.uniform(-3, 3);
        const double away = random.uniform(0, std::numbers::pi);
        const double side = angle + face + (random.integer(0, 1) == 0 ? away : -away);
        const Vec2f now = directionAt(angle + normal + random.uniform(-2e-3, 2e-3));
        const std::uint8_t faces[2] = {faceFrom(directionAt(normal), directionAt(face)), 0};
        INFO("round " << round << ", " << away / degree << " degrees away");
        for (const bool ofA : {true, false}) {
            flush.gather(two.graph, two.bodies);
            flush.add(two.a, two.b, directionAt(ofA ? side : side + std::numbers::pi), true);
            const BodyIndex body = ofA ? two.a : two.b;
            CHECK(flush.any(body, true));
            if (away < degree) CHECK(flush.mayLieAlong(body, now, faces, true));
            if (away > 23 * degree) CHECK_FALSE(flush.mayLieAlong(body, now, faces, false));
        }
    }
}

TEST_CASE("what has not moved since it was seen does not count as new", "[dynamics]") {
    Two two;
    FlushSides flush;
    flush.gather(two.graph, two.bodies);
    flush.add(two.a, two.b, directionAt(1), false);
    const std::uint8_t faces[2] = {faceFrom(directionAt(0), directionAt(1)), 0};
    CHECK(flush.mayLieAlong(two.a, directionAt(0), faces, false));
    CHECK_FALSE(flush.mayLieAlong(two.a, directionAt(0), faces, true));
    CHECK_FALSE(flush.any(two.b, true));
}

TEST_CASE("of bodies that do not move by forces it is not known what lies along them", "[dynamics]") {
    Two two;
    two.bodies.velocity[two.a].inverseMass = 0;
    FlushSides flush;
    flush.gather(two.graph, two.bodies);
    const std::uint8_t faces[2] = {faceFrom(directionAt(0), directionAt(1)), 0}, none[2] = {0, 0};
    CHECK(flush.mayLieAlong(two.a, directionAt(0), faces, true));
    CHECK_FALSE(flush.mayLieAlong(two.a, directionAt(0), none, true));
    CHECK_FALSE(flush.any(two.b, false));
}
