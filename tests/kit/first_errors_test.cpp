// SPDX-License-Identifier: MIT
// What is somebody told whose first lines are wrong? Each text names the member, the value, and what was wanted.
#include <cmath>
#include <limits>

#include <plumb/movers/grid_mover.h>
#include <plumb/movers/move_and_collide.h>
#include <plumb/movers/move_and_slide.h>
#include <plumb/movers/platform_mover.h>
#include <plumb/plumb.h>

#include "catch.h"

using namespace plumb;
using namespace plumb::test;

namespace {

/// What a first program has, and bodies that are not there.
struct FirstProgram {
    World world, other;
    BodyId ground = world.add({.type = BodyType::Static, .shapes = {box({10, 0.5})}});
    BodyId ball = world.add({.position = {0, 5}, .shapes = {circle(0.5)}});
    BodyId hero = world.add({.type = BodyType::Kinematic, .position = {5, 5}, .shapes = {box({0.4, 0.9})}});
    BodyId gone = world.add({.position = {9, 9}, .shapes = {circle(0.5)}});
    BodyId foreign = other.add({.shapes = {circle(1)}});
    JointId hinge = world.join(RevoluteJointDef{.bodyA = ground, .bodyB = ball});
    Joint lost = world.joint(world.join(RevoluteJointDef{.bodyA = ground, .bodyB = gone}));
    Body kept = world.body(gone);
    BodyShape keptShape = world.shape({gone, 0});

    FirstProgram() { world.remove(gone); }
};

constexpr double infinite = std::numeric_limits<double>::infinity();

#define REFUSED(expression, text) CHECK_THROWS_WITH((expression), text)
#define REFUSED_WITH(expression, text) CHECK_THROWS_WITH((expression), containsText(text))

}  // namespace

TEST_CASE("a wrong shape is refused with a text that says what was wanted", "[first]") {
    FirstProgram p;
    REFUSED(p.world.add({.shapes = {segment({0, 0}, {1, 0})}}),
            "BodyDef.shapes.mass: 0 is not a positive finite mass (a dynamic body needs a shape with area and density, "
            "or a mass of its own)");
    REFUSED(p.world.add({.shapes = {circle(0)}}), "BodyDef.shapes[0].shape.radius: 0 is not positive");
    REFUSED(p.world.add({.shapes = {circle(-1)}}), "BodyDef.shapes[0].shape.radius: -1 is not positive");
    REFUSED(p.world.add({.shapes = {circle(std::nan(""))}}), "BodyDef.shapes[0].shape.radius: nan is not finite");
    REFUSED(p.world.add({.shapes = {box({0, 1})}}), "box.halfSize: (0, 1) is not positive");
    REFUSED(p.world.add({.shapes = {box({1, -1})}}), "box.halfSize: (1, -1) is not positive");
    REFUSED(p.world.add({.shapes = {capsule({1, 0}, {1, 0}, 0.2)}}),
            "BodyDef.shapes[0].shape.end: (1, 0) is the same point as start: that is a circle");
    REFUSED(p.world.add({.shapes = {polygon({{0, 0}, {1, 0}})}}),
            "BodyDef.shapes[0].shape.vertices: 2 corners are fewer than 3");
    REFUSED(p.world.add({.shapes = {polygon({{0, 0}, {0, 1}, {1, 0}})}}),
            "BodyDef.shapes[0].shape.vertices: the corners run clockwise, not counter-clockwise");
    REFUSED(p.world.add({.shapes = {polygon({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}})}}),
            "BodyDef.shapes[0].shape.vertices[2]: (0.5, 0.5) makes the polygon not convex");
    REFUSED(p.world.add({.type = BodyType::Static, .shapes = {chain({{0, 0}})}}),
            "BodyDef.shapes[0].shape.points: 1 points are fewer than 2");
    REFUSED(p.world.add({.type = BodyType::Static, .shapes = {loop({{0, 0}, {1, 0}})}}),
            "BodyDef.shapes[0].shape.points: 2 points are fewer than 3 of a closed chain");
    REFUSED(p.world.add({.shapes = {tiles(tileMapOf({"##"}))}}),
            "BodyDef.shapes.mass: 0 is not a positive finite mass (a dynamic body needs a shape with area and density, "
            "or a mass of its own)");
    REFUSED(p.world.add({.shapes = {circle(0.5, {.density = -1})}}),
            "BodyDef.shapes[0].material.density: -1 is negative");
    REFUSED(p.world.add({.shapes = {circle(0.5, {.density = 0})}}),
            "BodyDef.shapes.mass: 0 is not a positive finite mass (a dynamic body needs a shape with area and density, "
            "or a mass of its own)");
    REFUSED(p.world.add({.shapes = {circle(0.5, {.friction = -0.1})}}),
            "BodyDef.shapes[0].material.friction: -0.1 is negative");
    REFUSED(p.world.add({.shapes = {circle(0.5, {.restitution = 1.5})}}),
            "BodyDef.shapes[0].material.restitution: 1.5 is not within 0 to 1; for a bumper, which adds speed, apply "
            "an impulse at each ContactBegin: see dynamics/events.md, Bumpers");
    REFUSED(p.world.add({.shapes = {{.shape = Circle{0.5}, .oneWay = Vec2(0, 0)}}}),
            "BodyDef.shapes[0].oneWay: (0, 0) is no direction");
}

TEST_CASE("a wrong body is refused with a text that says what was wanted", "[first]") {
    FirstProgram p;
    REFUSED(p.world.add({}),
            "BodyDef.shapes.mass: 0 is not a positive finite mass (a dynamic body needs a shape with area and density, "
            "or a mass of its own)");
    REFUSED(p.world.add({.position = {std::nan(""), 0}, .shapes = {circle(0.5)}}),
            "BodyDef.position: (nan, 0) is not finite");
    REFUSED(p.world.add({.angle = infinite, .shapes = {circle(0.5)}}), "BodyDef.angle: inf is not finite");
    REFUSED(p.world.add({.linearDamping = -1, .shapes = {circle(0.5)}}), "BodyDef.linearDamping: -1 is negative");
    REFUSED(p.world.add({.type = BodyType::Static, .velocity = {1, 0}, .shapes = {circle(0.5)}}),
            "BodyDef.velocity: (1, 0) on a static body, not (0, 0)");
    REFUSED(p.world.add({.mass = Mass{.mass = -1, .inertia = 1}}),
            "BodyDef.mass.mass: -1 is not a positive finite mass");
}

TEST_CASE("a wrong world, step or question is refused with a text that says what was wanted", "[first]") {
    FirstProgram p;
    REFUSED(World({.gravity = {0, std::nan("")}}), "WorldDef.gravity: (0, nan) is not finite");
    REFUSED(World({.hitSpeed = -1}), "WorldDef.hitSpeed: -1 is negative");
    REFUSED(World({.wrap = {.width = -10}}), "WorldDef.wrap.width: -10 is not within 0.001 to 1000000000");
    REFUSED(World({.solver = {.subSteps = 0}}), "WorldDef.solver.subSteps: 0 is not within 1 to 64");
    REFUSED(p.world.step(-1.0), "World.step: dt: -1 is negative");
    REFUSED(p.world.step(16.67),
            "World.step: dt: 16.67 s is longer than 1 s: wanted are seconds, not milliseconds; for a longer time make "
            "several steps");
    REFUSED(p.world.step(std::nan("")), "World.step: dt: nan is not finite");
    REFUSED(p.world.castRay({0, 0}, {std::nan(""), 0}), "World.castRay: to: (nan, 0) is not finite");
    REFUSED(p.world.ledger(), "World.ledger: WorldDef.ledger was not set, so no account was kept");
}

TEST_CASE("an id or a view of what is not there is refused with a text that says what was wanted", "[first]") {
    FirstProgram p;
    REFUSED(p.world.body({}).position(), "BodyId: {index 0, generation 0, world 0} names no body: it was never set");
    REFUSED_WITH(p.world.body(p.gone).position(), "names no body of this world any more: it was removed");
    REFUSED_WITH(p.kept.position(), "names no body of this world any more: it was removed");
    REFUSED_WITH(p.kept.setVelocity({1, 0}), "names no body of this world any more: it was removed");
    REFUSED_WITH(p.keptShape.material(), "names no body of this world any more: it was removed");
    REFUSED_WITH(p.lost.reaction(), "names no joint of this world any more: it was removed");
    REFUSED_WITH(p.world.body(p.foreign).position(), "belongs to another world");
    REFUSED_WITH(p.world.remove(p.gone), "names no body of this world any more: it was removed");
}

TEST_CASE("a wrong call of a body is refused with a text that says what was wanted", "[first]") {
    FirstProgram p;
    REFUSED(p.world.body(p.ball).setVelocity({std::nan(""), 0}), "Body.setVelocity: velocity: (nan, 0) is not finite");
    REFUSED(p.world.body(p.ground).setVelocity({1, 0}),
            "Body.setVelocity: velocity: (1, 0) to a body that is static, and stays where it is");
    CHECK_NOTHROW(p.world.body(p.ground).setVelocity({0, 0}));  // as in the definition: a loop that stops all bodies
    REFUSED(p.world.body(p.ground).applyForce({1, 0}),
            "Body.applyForce: force: (1, 0) does nothing to a body that is static, not dynamic");
    REFUSED(p.world.body(p.ground).applyImpulse({1, 0}),
            "Body.applyImpulse: impulse: (1, 0) does nothing to a body that is static, not dynamic");
    REFUSED(p.world.body(p.ball).moveTo({1, 1}, 0, 0.1), "Body.moveTo: the body is not kinematic, but dynamic");
    REFUSED(p.world.body(p.ball).setMass({.mass = 0, .inertia = 1}),
            "Body.setMass: mass.mass: 0 is not a positive finite mass");
}

TEST_CASE("a wrong joint or field is refused with a text that says what was wanted", "[first]") {
    FirstProgram p;
    REFUSED_WITH(p.world.join(RevoluteJointDef{.bodyA = p.ball, .bodyB = p.ball}),
                 "is the same body as bodyA, two were wanted");
    REFUSED(p.world.join(RevoluteJointDef{.bodyA = p.ball}),
            "RevoluteJointDef.bodyB: {index 0, generation 0, world 0} names no body: it was never set");
    REFUSED(p.world.join(RevoluteJointDef{.bodyA = p.ground, .bodyB = p.ball, .motorSpeed = 3}),
            "RevoluteJointDef.motorSpeed: 3 does nothing while maxMotorTorque is 0");
    REFUSED(p.world.join(RevoluteJointDef{.bodyA = p.ground, .bodyB = p.ball, .limit = Limit{1, -1}}),
            "RevoluteJointDef.limit.lower: 1 is more than limit.upper -1");
    REFUSED(p.world.join(PrismaticJointDef{.bodyA = p.ground, .bodyB = p.ball, .axis = {0, 0}}),
            "PrismaticJointDef.axis: (0, 0) has no direction");
    REFUSED(p.world.join(DistanceJointDef{.bodyA = p.ground, .bodyB = p.ball, .length = -1}),
            "DistanceJointDef.length: -1 is not positive");
    REFUSED(p.world.join(DistanceJointDef{.bodyA = p.ground, .bodyB = p.ball, .anchorB = {0, 5}, .maxLength = 2}),
            "DistanceJointDef.maxLength: 2 does nothing without a spring");
    REFUSED(p.world.joint(p.hinge).setMotorSpeed(5),
            "RevoluteJointDef.motorSpeed: 5 does nothing while maxMotorTorque is 0");
    REFUSED(p.world.addField({.law = Drag{.linear = -1}}), "Drag.linear: -1 is negative");
}

TEST_CASE("a wrong call of a mover, a clock or a tile map is refused with a text that says what was wanted",
          "[first]") {
    FirstProgram p;
    REFUSED(tileMapOf({"#?"}),
            "tileMapOf: rows[0][1]: '?' stands for no tile; known are ' ', '#', '.', '/', '1', '2', '3', '4', '=', "
            "'\\', '^', '~'");
    REFUSED(tileMapOf({}), "tileMapOf: rows: hold no cell");
    REFUSED(moveAndSlide(p.world, p.ball, {.velocity = {1, 0}, .dt = 0.1}),
            "moveAndSlide: body: is not kinematic: set its type to Kinematic");
    REFUSED(moveAndCollide(p.world, p.ball, {1, 0}, 0.1),
            "moveAndCollide: body: is not kinematic: set its type to Kinematic");
    REFUSED(PlatformMover(p.hero).step(p.world, {.move = 2}, 0.1), "PlatformInput.move: 2 is not within -1 to 1");
    REFUSED(FixedClock({.interval = 0}), "ClockSettings.interval: 0 is not within 1e-06 to 1000000");
    REFUSED(FixedClock({.interval = 1.0 / 60}).advance(-1), "FixedClock.advance: elapsed: -1 is negative");
    REFUSED(GridMover({.pixelsPerTile = 0}), "GridMoverDef.pixelsPerTile: 0 is not within 1 to 2^20");
}
