// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <string>

#include <plumb/plumb.h>
#include "catch.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

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
    return {.position = {x, y}, .shapes = {circle(0.5)}};
}

/// A floor, and a ball that lies on it.
struct Resting {
    World world;
    BodyId floor, ball;
    Resting() {
        floor = world.add({.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0})}});
        ball = world.add(ballAt(0, 0.5));
        for (int tick = 0; tick < 60; ++tick) world.step(1.0 / 60);
    }
};

}  // namespace

TEST_CASE("a step of no time changes nothing", "[dynamics]") {
    World world;
    const BodyId ball = world.add({.velocity = {1, 2}, .shapes = {circle(1)}});
    const std::uint64_t before = stateHash(world);
    world.step(0.0);
    CHECK(stateHash(world) == before);
    CHECK(world.body(ball).velocity() == Vec2(1, 2));
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
    CHECK(refusal([&] { world.remove(JointId{}); }) != "");
    CHECK(refusal([&] { world.joint(JointId{5, 0, second.world}).reaction(); }) != "");
}

TEST_CASE("an id that never was is not told that it was removed", "[dynamics][errors]") {
    World world;
    const BodyId body = world.add(ballAt(0, 0));
    const JointId joint = world.join(TargetJointDef{.body = body});
    const auto says = [](const std::string& text, const std::string& part) {
        INFO(text);
        CHECK(text.find(part) != std::string::npos);
    };
    for (const BodyId& wrong : {BodyId{99, 0, body.world}, {body.index, 1, body.world}, {0, 0, body.world}})
        says(refusal([&] { world.body(wrong); }), "names no body of this world: there never was such a one");
    for (const JointId& wrong : {JointId{99, 0, body.world}, {joint.index, 1, body.world}})
        says(refusal([&] { world.remove(wrong); }), "names no joint of this world: there never was such a one");
    says(refusal([&] {
             (void)world.shape({body, 7}).def();
         }),
         "7 names no shape of that body: there never was such a one");
    world.add(body, circle(1));
    world.remove(ShapeId{body, 1});
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
        s.world.add({.position = {-3, 0.5}, .velocity = {10, 0}, .shapes = {circle(0.5)}});
        for (int tick = 0; tick < 20; ++tick) s.world.step(1.0 / 60);
    }));
    CHECK_FALSE(wakes([](Resting& s) {
        s.world.add({.position = {-3, 3}, .velocity = {10, 0}, .shapes = {circle(0.5)}});
        for (int tick = 0; tick < 20; ++tick) s.world.step(1.0 / 60);
    }));
}

TEST_CASE("a body that drifts at 1 mm/s with nothing to hold it never falls asleep", "[dynamics][sleep]") {
    World world({.gravity = {0, 0}});
    const BodyId ball = world.add({.velocity = {0.001, 0}, .shapes = {circle(0.5)}});
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
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0})}});
    const BodyId ball = world.add(ballAt(0, 1.5));
    std::size_t begins = 0;
    for (int tick = 0; tick < 120; ++tick) {
        world.step(1.0 / 60);
        for (const ContactBegin& event : world.contactBegins()) {
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
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0})}});
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
    world.add({.type = BodyType::Static, .shapes = {{.shape = Segment{{-10, 0}, {10, 0}}, .filter = {.category = 2}}}});
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
    world.add({.type = BodyType::Static, .shapes = {segment({-10, 0}, {10, 0})}});
    const BodyId box =
        world.add({.position = {0, 2}, .angle = 0.3, .fixedRotation = true, .shapes = {plumb::box({0.5, 0.5})}});
    for (int tick = 0; tick < 120; ++tick) world.step(1.0 / 60);
    CHECK(world.body(box).angle() == 0.3);
    CHECK(world.body(box).position().y() > 0.5);
}
