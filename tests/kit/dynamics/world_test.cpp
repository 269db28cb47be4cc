// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <plumb/plumb.h>
#include "catch.h"
#include "numbers.h"

using plumb::BodyDef;
using plumb::BodyId;
using plumb::BodyType;
using plumb::Vec2;
using plumb::World;
using plumb::test::infinity;

namespace {

std::string refusal(const std::function<void()>& call) {
    try {
        call();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

BodyDef ballAt(double x, double y) {
    return {.position = {x, y}, .shapes = {plumb::circle(0.5)}};
}

/// A floor, and a ball that lies on it.
struct Resting {
    World world;
    BodyId floor, ball;
    Resting() {
        floor = world.add({.type = BodyType::Static, .shapes = {plumb::segment({-10, 0}, {10, 0})}});
        ball = world.add(ballAt(0, 0.5));
        for (int tick = 0; tick < 60; ++tick) world.step(1.0 / 60);
    }
};

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

TEST_CASE("a def with an impossible number is refused by a text that names field and value", "[dynamics][errors]") {
    World world;
    const auto add = [&world](const std::function<void(BodyDef&)>& spoil) {
        BodyDef def = ballAt(0, 0);
        spoil(def);
        return refusal([&] { world.add(def); });
    };
    CHECK(add([](BodyDef& d) { d.position.x() = notANumber; }) == "BodyDef.position: (nan, 0) is not finite");
    CHECK(add([](BodyDef& d) { d.velocity.y() = infinity; }) == "BodyDef.velocity: (0, inf) is not finite");
    CHECK(add([](BodyDef& d) { d.angle = notANumber; }) == "BodyDef.angle: nan is not finite");
    CHECK(add([](BodyDef& d) { d.angularVelocity = -infinity; }) == "BodyDef.angularVelocity: -inf is not finite");
    CHECK(add([](BodyDef& d) { d.gravityScale = notANumber; }) == "BodyDef.gravityScale: nan is not finite");
    CHECK(add([](BodyDef& d) { d.linearDamping = -1; }).starts_with("BodyDef.linearDamping: -1 is"));
    CHECK(add([](BodyDef& d) { d.angularDamping = notANumber; }).starts_with("BodyDef.angularDamping: nan is"));
    CHECK(add([](BodyDef& d) { d.mass = plumb::Mass{0, {0, 0}, 1}; }).starts_with("BodyDef.mass.mass: 0 is"));
    CHECK(add([](BodyDef& d) { d.mass = plumb::Mass{1, {0, 0}, -2}; }).starts_with("BodyDef.mass.inertia: -2 is"));
    CHECK(add([](BodyDef& d) {
              d.mass = plumb::Mass{1, {notANumber, 0}, 2};
          }).starts_with("BodyDef.mass.center: (nan, 0) is"));
    CHECK(add([](BodyDef& d) { d.shapes.clear(); }).starts_with("BodyDef.shapes.mass: 0 is not a positive"));
    CHECK(add([](BodyDef& d) { d.shapes[0].material.friction = -0.1; }).find("friction: -0.1") != std::string::npos);
    CHECK(add([](BodyDef& d) { d.shapes[0].material.restitution = 1.5; }).find("restitution: 1.5") !=
          std::string::npos);
    CHECK(add([](BodyDef& d) { d.shapes[0].material.restitution = 1.5; }) ==
          "BodyDef.shapes[0].material.restitution: 1.5 is not within 0 to 1; for a bumper, which adds speed, apply an "
          "impulse at each ContactBegin: see dynamics/events.md, Bumpers");
    CHECK(add([](BodyDef& d) { d.shapes[0].material.restitution = -0.5; }) ==
          "BodyDef.shapes[0].material.restitution: -0.5 is not within 0 to 1");
    CHECK(add([](BodyDef& d) { d.shapes[0].material.density = notANumber; }).find("density: nan") != std::string::npos);
    CHECK(add([](BodyDef& d) { d.shapes[0] = plumb::circle(0); }).find("radius: 0 is not positive") !=
          std::string::npos);
    CHECK(add([](BodyDef& d) { d.shapes[0] = plumb::segment({1, 1}, {1, 1}); }) != "");
    CHECK(add([](BodyDef& d) { d.shapes[0] = plumb::polygon({{0, 0}, {1, 0}}); }) != "");
    CHECK(add([](BodyDef& d) { d.shapes[0] = plumb::polygon({{0, 0}, {0, 1}, {1, 0}}); }) != "");
    CHECK(add([](BodyDef& d) { d.shapes[0] = plumb::polygon({{0, 0}, {1, 0}, {2, 0}}); }) != "");
    CHECK(add([](BodyDef& d) {
              d.type = BodyType::Static;
              d.velocity = {1, 0};
          }) == "BodyDef.velocity: (1, 0) on a static body, not (0, 0)");
    CHECK(world.bodies().empty());
}

TEST_CASE("a world refuses impossible settings, and a step that is negative or no number", "[dynamics][errors]") {
    CHECK(refusal([] { World({.gravity = {0, notANumber}}); }) == "WorldDef.gravity: (0, nan) is not finite");
    CHECK(refusal([] { World({.solver = {.subSteps = 0}}); }).starts_with("WorldDef.solver.subSteps: 0 is"));
    CHECK(refusal([] { World({.solver = {.contactFrequency = 0}}); }) != "");
    World world;
    CHECK(refusal([&] { world.step(-0.1); }).starts_with("World.step: dt: -0.1 is"));
    CHECK(refusal([&] { world.step(notANumber); }) != "");
    CHECK(refusal([&] { world.step(infinity); }) != "");
    CHECK(refusal([&] { world.setGravity({notANumber, 0}); }) != "");
}

TEST_CASE("a step of no time changes nothing", "[dynamics]") {
    World world;
    const BodyId ball = world.add({.velocity = {1, 2}, .shapes = {plumb::circle(1)}});
    const std::uint64_t before = plumb::stateHash(world);
    world.step(0.0);
    CHECK(plumb::stateHash(world) == before);
    CHECK(world.body(ball).velocity() == Vec2(1, 2));
}

TEST_CASE("joints to a missing, a foreign or the same body, or between two that never move, are refused",
          "[dynamics][errors]") {
    World world, other;
    const BodyId wall = world.add({.type = BodyType::Static}), wall2 = world.add({.type = BodyType::Static});
    const BodyId ball = world.add(ballAt(0, 0)), gone = world.add(ballAt(3, 0)), foreign = other.add(ballAt(0, 0));
    world.remove(gone);
    const auto hinge = [&](BodyId a, BodyId b) {
        return refusal([&] { world.join(plumb::RevoluteJointDef{.bodyA = a, .bodyB = b}); });
    };
    CHECK(hinge({}, ball).find("RevoluteJointDef.bodyA") == 0);
    CHECK(hinge({}, ball).find("never set") != std::string::npos);
    CHECK(hinge(ball, gone).find("RevoluteJointDef.bodyB") == 0);
    CHECK(hinge(ball, gone).find("removed") != std::string::npos);
    CHECK(hinge(ball, foreign).find("another world") != std::string::npos);
    CHECK(hinge(ball, ball).find("same body") != std::string::npos);
    CHECK(hinge(wall, wall2).find("dynamic") != std::string::npos);
    CHECK(refusal([&] {
              world.join(plumb::DistanceJointDef{.bodyA = wall, .bodyB = ball, .anchorA = {1, 1}, .anchorB = {1, 1}});
          }).find("DistanceJointDef.anchorB: (1, 1)") == 0);
    CHECK(refusal([&] {
              world.join(plumb::DistanceJointDef{.bodyA = wall, .bodyB = ball, .anchorB = {1, 1}, .length = -1.0});
          }).find("DistanceJointDef.length: -1") == 0);
    CHECK(refusal([&] {
              world.join(plumb::RevoluteJointDef{.bodyA = wall, .bodyB = ball, .anchor = {notANumber, 0}});
          }).find("RevoluteJointDef.anchor: (nan, 0)") == 0);
}

TEST_CASE("an id of a removed body is refused even after its slot was used again", "[dynamics][errors]") {
    World world, other;
    const BodyId first = world.add(ballAt(0, 0));
    world.remove(first);
    const BodyId second = world.add(ballAt(1, 0));
    CHECK(second.index == first.index);
    CHECK_FALSE(world.contains(first));
    CHECK(world.contains(second));
    CHECK_FALSE(other.contains(second));
    CHECK(refusal([&] { world.body(first); }).find("removed") != std::string::npos);
    CHECK(refusal([&] { world.remove(first); }).find("removed") != std::string::npos);
    CHECK(refusal([&] { other.body(second); }).find("another world") != std::string::npos);
    CHECK(refusal([&] { world.remove(plumb::JointId{}); }) != "");
    CHECK(refusal([&] { world.joint(plumb::JointId{5, 0, second.world}).reaction(); }) != "");
}

TEST_CASE("an id that never was is not told that it was removed", "[dynamics][errors]") {
    World world;
    const BodyId body = world.add(ballAt(0, 0));
    const plumb::JointId joint = world.join(plumb::TargetJointDef{.body = body});
    const auto says = [](const std::string& text, const std::string& part) {
        INFO(text);
        CHECK(text.find(part) != std::string::npos);
    };
    for (const BodyId& wrong : {BodyId{99, 0, body.world}, {body.index, 1, body.world}, {0, 0, body.world}})
        says(refusal([&] { world.body(wrong); }), "names no body of this world: there never was such a one");
    for (const plumb::JointId& wrong : {plumb::JointId{99, 0, body.world}, {joint.index, 1, body.world}})
        says(refusal([&] { world.remove(wrong); }), "names no joint of this world: there never was such a one");
    says(refusal([&] {
             (void)world.shape({body, 7}).def();
         }),
         "7 names no shape of that body: there never was such a one");
    world.add(body, plumb::circle(1));
    world.remove(plumb::ShapeId{body, 1});
    says(refusal([&] {
             (void)world.shape({body, 1}).def();
         }),
         "1 names no shape of that body any more: it was removed");
    says(refusal([&] { (void)world.distance({body, 0}, {body, 1}); }), "b.number: 1 names no shape of that body any");
    world.remove(joint);
    world.remove(body);
    says(refusal([&] { world.body(body); }), "it was removed");
    says(refusal([&] { world.joint(joint); }), "it was removed");
}

TEST_CASE("removing a body takes its joints and contacts along and wakes what lay on it", "[dynamics]") {
    Resting scene;
    const BodyId rider = scene.world.add(ballAt(0, 1.5));
    for (int tick = 0; tick < 120; ++tick) scene.world.step(1.0 / 60);
    REQUIRE_FALSE(scene.world.body(rider).awake());
    scene.world.remove(scene.ball);
    CHECK(scene.world.body(rider).awake());
    scene.world.step(1.0 / 60);
    CHECK(scene.world.contactEnds().size() == 2);
    scene.world.step(1.0 / 60);
    CHECK(scene.world.contactEnds().empty());
    for (int tick = 0; tick < 120; ++tick) scene.world.step(1.0 / 60);
    CHECK(std::fabs(scene.world.body(rider).position().y() - 0.5) < 1e-3);
}

TEST_CASE("a ball at rest falls asleep, and wakes by a push, a force, a hit, a jump or a change of gravity",
          "[dynamics][sleep]") {
    const auto wakes = [](const std::function<void(Resting&)>& event) {
        Resting scene;
        if (scene.world.body(scene.ball).awake()) return false;
        event(scene);
        return scene.world.body(scene.ball).awake();
    };
    CHECK(wakes([](Resting& s) { s.world.body(s.ball).applyImpulse({0, 1}); }));
    CHECK(wakes([](Resting& s) { s.world.body(s.ball).applyForce({1, 0}); }));
    CHECK(wakes([](Resting& s) { s.world.body(s.ball).setVelocity({1, 0}); }));
    CHECK(wakes([](Resting& s) { s.world.body(s.ball).setPose({0, 3}, 0); }));
    CHECK(wakes([](Resting& s) { s.world.setGravity({0, 9.81}); }));
    CHECK(wakes([](Resting& s) { s.world.remove(s.floor); }));
    CHECK(wakes([](Resting& s) {
        s.world.add({.position = {-3, 0.5}, .velocity = {10, 0}, .shapes = {plumb::circle(0.5)}});
        for (int tick = 0; tick < 20; ++tick) s.world.step(1.0 / 60);
    }));
    CHECK_FALSE(wakes([](Resting& s) {
        s.world.add({.position = {-3, 3}, .velocity = {10, 0}, .shapes = {plumb::circle(0.5)}});
        for (int tick = 0; tick < 20; ++tick) s.world.step(1.0 / 60);
    }));
}

TEST_CASE("a body that drifts at 1 mm/s with nothing to hold it never falls asleep", "[dynamics][sleep]") {
    World world({.gravity = {0, 0}});
    const BodyId ball = world.add({.velocity = {0.001, 0}, .shapes = {plumb::circle(0.5)}});
    for (int tick = 0; tick < 600; ++tick) world.step(1.0 / 60);
    CHECK(std::fabs(world.body(ball).position().x() - 0.01) < 1e-12);
}

TEST_CASE("a kinematic platform carries a box up at 1 m/s, and lets it sleep when it stops", "[dynamics]") {
    World world;
    const BodyId lift = world.add({.type = BodyType::Kinematic, .velocity = {0, 1}, .shapes = {plumb::box({2, 0.5})}});
    const BodyId box = world.add({.position = {0, 1}, .shapes = {plumb::box({0.5, 0.5})}});
    for (int tick = 0; tick < 120; ++tick) world.step(1.0 / 60);
    CHECK(std::fabs(world.body(lift).position().y() - 2) < 1e-12);
    CHECK(std::fabs(world.body(box).position().y() - 3) < 1e-3);
    CHECK(world.body(box).awake());
    world.body(lift).setVelocity({0, 0});
    for (int tick = 0; tick < 120; ++tick) world.step(1.0 / 60);
    CHECK_FALSE(world.body(box).awake());
    world.body(lift).setVelocity({0, 1});
    CHECK(world.body(box).awake());
}

TEST_CASE("a ball that lands tells so once, with point, normal and speed, and once when it leaves",
          "[dynamics][events]") {
    World world;
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {plumb::segment({-10, 0}, {10, 0})}});
    const BodyId ball = world.add(ballAt(0, 1.5));
    std::size_t begins = 0;
    for (int tick = 0; tick < 120; ++tick) {
        world.step(1.0 / 60);
        for (const plumb::ContactBegin& event : world.contactBegins()) {
            ++begins;
            CHECK((event.shapeA.body == floor && event.shapeB.body == ball));
            CHECK(event.normal.y() > 0.999);
            CHECK(event.point.norm() < 0.01);
            // sqrt(2 g 1 m) = 4.429 m/s, told as it was at the step's start, at most a step and a sub-step before
            CHECK(std::fabs(event.approachSpeed - 4.429) < 1.25 * 9.81 / 60 + 1e-3);
        }
        CHECK(world.contactEnds().empty());
    }
    CHECK(begins == 1);
    world.body(ball).setVelocity({0, 5});
    std::size_t ends = 0;
    for (int tick = 0; tick < 30; ++tick) {
        world.step(1.0 / 60);
        ends += world.contactEnds().size();
    }
    CHECK(ends == 1);
}

TEST_CASE("a body that overflows is put in quarantine with one event, and its neighbours go on", "[dynamics][errors]") {
    World world;
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {plumb::segment({-10, 0}, {10, 0})}});
    const BodyId ball = world.add(ballAt(0, 0.5)), fast = world.add(ballAt(5, 5));
    world.body(fast).setVelocity({1e300, 0});
    std::size_t events = 0;
    for (int tick = 0; tick < 60; ++tick) {
        world.step(1.0 / 60);
        events += world.quarantines().size();
        if (!world.quarantines().empty()) CHECK(world.quarantines()[0].body == fast);
    }
    CHECK(events == 1);
    CHECK(world.body(fast).quarantined());
    CHECK(world.body(fast).position() == Vec2(5, 5));
    CHECK(std::fabs(world.body(ball).position().y() - 0.5) < 1e-3);
    CHECK(world.contains(floor));
    world.body(ball).applyForce({1e308, 1e308});
    world.step(1.0 / 60);
    CHECK(world.body(ball).quarantined());
}

TEST_CASE("filters keep apart what does not name each other", "[dynamics]") {
    World world;
    world.add({.type = BodyType::Static,
               .shapes = {{.shape = plumb::Segment{{-10, 0}, {10, 0}}, .filter = {.category = 2}}}});
    BodyDef ghost = ballAt(0, 1);
    ghost.shapes[0].filter.mask = ~std::uint64_t{2};
    const BodyId through = world.add(ghost);
    const BodyId held = world.add(ballAt(3, 1));
    for (int tick = 0; tick < 120; ++tick) world.step(1.0 / 60);
    CHECK(world.body(through).position().y() < -5);
    CHECK(world.body(held).position().y() > 0.49);
}

TEST_CASE("a fixed rotation stays fixed when a box lands on its corner", "[dynamics]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {plumb::segment({-10, 0}, {10, 0})}});
    const BodyId box =
        world.add({.position = {0, 2}, .angle = 0.3, .fixedRotation = true, .shapes = {plumb::box({0.5, 0.5})}});
    for (int tick = 0; tick < 120; ++tick) world.step(1.0 / 60);
    CHECK(world.body(box).angle() == 0.3);
    CHECK(world.body(box).position().y() > 0.5);
}
