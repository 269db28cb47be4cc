// SPDX-License-Identifier: MIT
// A manifold is used again while the two bodies hardly move. What changes it must act at once.
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"

namespace {

using namespace plumb;
using namespace plumb::test;

ShapeDef ngon(int corners, double radius, double friction = 1) {
    Polygon polygon;
    for (int i = 0; i < corners; ++i) {
        const double angle = std::numbers::pi * (2.0 * i / corners - 0.5 + 1.0 / corners);
        polygon.vertices.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return {.shape = polygon, .material = {.friction = friction}};
}

/// A polygon that has rested on a slope for two seconds, awake.
struct Rest {
    World world{WorldDef{.sleeping = false}};
    BodyId ground, body;
    double angle;
    int corners;

    Rest(int corners, double angle) : angle(angle), corners(corners) {
        const Vec2 up(-std::sin(angle), std::cos(angle));
        ground = world.add({.type = BodyType::Static,
                            .angle = angle,
                            .shapes = {plumb::polygon({{-9, -1}, {9, -1}, {8, 0}, {-8, 0}}, {.friction = 1})}});
        const double height = 0.5 * std::cos(std::numbers::pi / corners);
        body = world.add({.position = up * height, .angle = angle, .shapes = {ngon(corners, 0.5)}});
        for (int i = 0; i < 120; ++i) world.step(dt);
    }
};

}  // namespace

TEST_CASE("what is changed at a body that has rested on a slope acts in the same step", "[dynamics][editing]") {
    struct Change {
        std::string name;
        std::function<void(Rest&)> make;
        double speed;  ///< along the slope after one step, as a share of g dt
    };
    constexpr double angle = 0.2;
    const double down = std::sin(angle);
    const std::vector<Change> changes{
        {"nothing", [](Rest&) {}, 0},
        {"friction",
         [](Rest& r) {
             r.world.shape({r.body, 0}).set(ngon(r.corners, 0.5, 0));
             ShapeDef ground = r.world.shape({r.ground, 0}).def();
             ground.material.friction = 0;
             r.world.shape({r.ground, 0}).set(ground);
         },
         down},
        {"filter",
         [](Rest& r) {
             ShapeDef ghost = ngon(r.corners, 0.5);
             ghost.filter.mask = 2;
             r.world.shape({r.body, 0}).set(ghost);
         },
         down},
        {"a smaller shape",
         [](Rest& r) {
             r.world.shape({r.body, 0}).set(ngon(r.corners, 0.4));
         },
         down},
        {"a joint that lets them pass",
         [](Rest& r) { r.world.join(FilterJointDef{.bodyA = r.ground, .bodyB = r.body}); }, down},
    };
    for (const int corners : {3, 5, 6, 8}) {
        for (const Change& change : changes) {
            Rest rest(corners, angle);
            change.make(rest);
            rest.world.step(dt);
            const Vec2 v = rest.world.body(rest.body).velocity();
            const double along = -(v.x() * std::cos(angle) + v.y() * std::sin(angle));
            INFO(corners << " corners, " << change.name);
            CHECK(std::fabs(along / (g * dt) - change.speed) < 0.02);
        }
    }
}

TEST_CASE("a body that has rested tips over at once when its centre of mass is moved beyond its base",
          "[dynamics][editing]") {
    for (const int corners : {5, 6, 8}) {
        Rest rest(corners, 0);
        const double halfBase = 0.5 * std::sin(std::numbers::pi / corners),
                     height = 0.5 * std::cos(std::numbers::pi / corners), out = halfBase + 0.1;
        rest.world.body(rest.body).setMass({1, {out, 0}, 0.1});
        rest.world.step(dt);
        // It turns about the corner: torque m g 0.1 over the moment of inertia about it.
        const double inertia = 0.1 + 0.01 + height * height;
        CHECK(rest.world.body(rest.body).angularVelocity() == Approx(-g * 0.1 / inertia * dt).epsilon(0.05));
    }
}

TEST_CASE("a contact at a corner that has rested is none any more in the step in which a shape covers the face there",
          "[dynamics][editing]") {
    // A plank lies over the corner of a block, with its other end on the ground.
    World world({.sleeping = false});
    world.add(
        {.type = BodyType::Static, .shapes = {plumb::polygon({{-9, -1}, {9, -1}, {8, 0}, {-8, 0}}, {.friction = 1})}});
    const ShapeDef heavy = plumb::polygon({{0, 0}, {1, 0}, {0.9, 0.5}, {0, 0.5}}, {.density = 100, .friction = 1});
    const BodyId block = world.add({.position = {0, 0}, .shapes = {heavy}});
    const double angle = std::atan2(0.5, 2.0);
    const BodyId plank =
        world.add({.position = {-2, 0},
                   .angle = angle,
                   .shapes = {plumb::polygon({{0, 0}, {3, 0}, {2.9, 0.1}, {0, 0.1}}, {.friction = 1})}});
    for (int i = 0; i < 200; ++i) world.step(dt);
    const auto touches = [&] {
        for (const Contact& contact : world.body(plank).contacts())
            if (contact.shapeA.body == block || contact.shapeB.body == block) return true;
        return false;
    };
    REQUIRE(touches());
    // It fills the gap below the plank up to a millimetre.
    world.add({.type = BodyType::Static,
               .position = world.body(block).position(),
               .shapes = {plumb::polygon({{-0.3, 0.2}, {0, 0.2}, {0, 0.499}, {-0.3, 0.405}})}});
    world.step(dt);
    CHECK_FALSE(touches());
}
