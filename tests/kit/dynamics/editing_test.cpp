// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/dynamics/edited.h"

using namespace plumb;
using namespace plumb::test;

TEST_CASE("what sleeps on something wakes, and falls or slides, when that is changed in any of ten ways",
          "[dynamics][editing]") {
    struct Change {
        std::string name;
        std::function<void(Rest&)> make;
        double tilt = 0;
    };
    const auto setShape = [](Rest& rest, const std::function<void(ShapeDef&)>& edit) {
        ShapeDef def = rest.world.shape({rest.plank, 0}).def();
        edit(def);
        rest.world.shape({rest.plank, 0}).set(def);
    };
    const std::vector<Change> changes{
        {"removed", [](Rest& r) { r.world.remove(r.plank); }},
        {"disabled", [](Rest& r) { r.world.body(r.plank).setEnabled(false); }},
        {"moved away",
         [](Rest& r) {
             r.world.body(r.plank).setPose({0, -3}, 0);
         }},
        {"given a velocity",
         [](Rest& r) {
             r.world.body(r.plank).setType(BodyType::Kinematic), r.world.body(r.plank).setVelocity({0, -1});
         }},
        {"made dynamic", [](Rest& r) { r.world.body(r.plank).setType(BodyType::Dynamic); }},
        {"its shape removed",
         [](Rest& r) {
             r.world.remove(ShapeId{r.plank, 0});
         }},
        {"its shape made a sensor", [&](Rest& r) { setShape(r, [](ShapeDef& d) { d.sensor = true; }); }},
        {"filtered out", [&](Rest& r) { setShape(r, [](ShapeDef& d) { d.filter.mask = 2; }); }},
        {"made thinner", [&](Rest& r) { setShape(r, [](ShapeDef& d) {
                                            d.shape = boxPolygon({5, 0.2});
                                        }); }},
        {"made slippery", [&](Rest& r) { setShape(r, [](ShapeDef& d) { d.material.friction = 0; }); }, 0.3},
    };
    for (const Change& change : changes) {
        INFO(change.name);
        Rest rest(BodyType::Static, change.tilt);
        REQUIRE_FALSE(rest.world.body(rest.box).awake());
        const Vec2 before = rest.world.body(rest.box).position();
        change.make(rest);
        CHECK(rest.world.body(rest.box).awake());
        steps(rest.world, 30);
        CHECK((rest.world.body(rest.box).position() - before).norm() > 0.2);
    }
}

TEST_CASE("a static box made dynamic falls as g t^2 / 2, and made static stays", "[dynamics][editing]") {
    World world;
    const BodyId box = world.add({.type = BodyType::Static, .position = {1, 9}, .shapes = {shapeAt({0.3, 0.2})}});
    CHECK(world.body(box).mass() == 0);
    steps(world, 10);
    world.body(box).setType(BodyType::Dynamic);
    CHECK(world.body(box).mass() == 0.5);
    steps(world, 60);
    CHECK((world.body(box).position() - Vec2(1, 9 - g / 2)).norm() < 1e-9);
    world.body(box).setType(BodyType::Static);
    const Vec2 where = world.body(box).position();
    const BodyId ball = world.add({.position = {1.3, 8}, .shapes = {circle(0.25)}});
    steps(world, 120);
    CHECK(world.body(box).position() == where);
    CHECK(std::fabs(world.body(ball).position().y() - (where.y() + 0.2 + 0.25 + 0.25)) < 1e-3);
}

TEST_CASE("a body of any type made another goes on as one that was added as that", "[dynamics][editing]") {
    for (const BodyType from : {BodyType::Static, BodyType::Kinematic, BodyType::Dynamic}) {
        for (const BodyType to : {BodyType::Static, BodyType::Kinematic, BodyType::Dynamic}) {
            World edited({.gravity = {0, -1}}), added({.gravity = {0, -1}});
            BodyDef def = spinning({shapeAt({1, 2}), circle(0.5)});
            if (from == BodyType::Static) def.velocity.setZero(), def.angularVelocity = 0;
            def.type = from;
            const BodyId a = edited.add(def);
            steps(edited, 5);
            edited.body(a).setType(to);
            def.type = to;
            def.position = edited.body(a).position();
            def.angle = edited.body(a).angle();
            def.velocity = edited.body(a).velocity();
            def.angularVelocity = edited.body(a).angularVelocity();
            const BodyId b = added.add(def);
            CHECK(edited.body(a).mass() == added.body(b).mass());
            CHECK(edited.body(a).type() == to);
            for (World* world : {&edited, &added}) {
                world->add({.position = {3, 12}, .velocity = {0, -8}, .shapes = {circle(1)}});
                steps(*world, 90);
            }
            CHECK(differenceOf(motionOf(edited.body(a)), motionOf(added.body(b))) < 1e-5);
        }
    }
}

TEST_CASE("a spinning body whose type, mass or shapes change stays where it is and moves on as it did",
          "[dynamics][editing]") {
    const std::vector<std::function<void(World&, BodyId)>> changes{
        [](World& w, BodyId b) {
            w.body(b).setMass({7, {2, -3}, 5});
        },
        [](World& w, BodyId b) { w.body(b).setType(BodyType::Kinematic); },
        [](World& w, BodyId b) {
            w.add(b, shapeAt({4, 4}));
        },
        [](World& w, BodyId b) {
            w.remove(ShapeId{b, 1});
        },
        [](World& w, BodyId b) {
            w.shape(ShapeId{b, 1}).set(circle(2));
        },
        [](World& w, BodyId b) {
            ShapeDef heavy = w.shape({b, 0}).def();
            heavy.material.density = 20;
            w.shape(ShapeId{b, 0}).set(heavy);
        },
    };
    for (const auto& change : changes) {
        World world({.gravity = {0, 0}});
        const BodyId body = world.add(spinning({shapeAt({1, 2}), shapeAt({-2, 0})}));
        const std::vector<double> before = motionOf(world.body(body));
        const Vec2 center = world.body(body).centerOfMass();
        change(world, body);
        CHECK(differenceOf(before, motionOf(world.body(body))) < 1e-13);
        CHECK((world.body(body).centerOfMass() - center).norm() > 0.05);
    }
}

TEST_CASE("a stack of ten put to sleep and woken at once stands as one that was left alone, within 0.1 mm",
          "[dynamics][editing]") {
    World woken({.sleeping = false}), left({.sleeping = false});
    const std::vector<BodyId> boxes = stackOf(woken, 10), others = stackOf(left, 10);
    steps(woken, 300);
    steps(left, 300);
    woken.body(boxes[4]).sleep();
    for (const BodyId box : boxes) REQUIRE_FALSE(woken.body(box).awake());
    woken.body(boxes[7]).wake();
    for (const BodyId box : boxes) REQUIRE(woken.body(box).awake());
    for (int tick = 0; tick < 20; ++tick) {
        woken.step(dt);
        left.step(dt);
        for (std::size_t i = 0; i < boxes.size(); ++i)
            CHECK((woken.body(boxes[i]).position() - left.body(others[i]).position()).norm() < 1e-4);
    }
}

TEST_CASE("a kinematic body told to move to a place is there after the step, and goes on", "[dynamics][editing]") {
    World world;
    const BodyId lift = world.add({.type = BodyType::Kinematic, .position = {1, 2}, .shapes = {plumb::box({1, 1})}});
    world.body(lift).moveTo({4, -3}, 1.5, dt);
    world.step(dt);
    CHECK((world.body(lift).position() - Vec2(4, -3)).norm() < 1e-14);
    CHECK(std::fabs(world.body(lift).angle() - 1.5) < 1e-15);
    world.step(dt);
    CHECK((world.body(lift).position() - Vec2(7, -8)).norm() < 1e-13);
    world.body(lift).moveTo({7, -8}, 3, dt);
    world.step(dt);
    CHECK((world.body(lift).position() - Vec2(7, -8)).norm() < 1e-13);
    const BodyId ball = world.add({.shapes = {circle(1)}});
    CHECK_THROWS_WITH(world.body(ball).moveTo({0, 0}, 0, dt), containsText("Body.moveTo: the body is not kinematic"));
    CHECK_THROWS_WITH(world.body(lift).moveTo({0, 0}, 0, 0), containsText("Body.moveTo: dt: 0"));
}

TEST_CASE("a stack put to sleep sleeps as a whole until a ball lands on it", "[dynamics][editing]") {
    World world;
    const std::vector<BodyId> boxes = stackOf(world, 3);
    steps(world, 10);
    world.body(boxes[1]).sleep();
    for (const BodyId box : boxes) CHECK_FALSE(world.body(box).awake());
    const BodyId ball = world.add({.position = {0, 5}, .shapes = {circle(0.3)}});
    steps(world, 30);
    CHECK_FALSE(world.body(boxes[0]).awake());
    steps(world, 10);
    CHECK(world.body(boxes[0]).awake());
    world.body(boxes[0]).setCanSleep(false);
    steps(world, 240);
    CHECK(world.body(ball).awake());
    CHECK(world.body(boxes[0]).awake());
}

TEST_CASE("a rider put to sleep on a lift that moves goes on with it", "[dynamics][editing]") {
    World world;
    const BodyId lift =
        world.add({.type = BodyType::Kinematic, .velocity = {0, 0.5}, .shapes = {plumb::box({2, 0.5})}});
    const BodyId rider = world.add({.position = {0, 1}, .shapes = {plumb::box({0.5, 0.5})}});
    for (int tick = 0; tick < 240; ++tick) {
        if (tick % 10 == 0) world.body(rider).sleep();
        world.step(dt);
        REQUIRE(std::fabs(world.body(rider).position().y() - world.body(lift).position().y() - 1) < 5e-3);
    }
}

TEST_CASE("a ball put to sleep 5 mm above a plate that slides by sleeps on, and is carried up when the plate rises",
          "[dynamics][editing]") {
    World world({.gravity = {0, 0}});
    const BodyId plate =
        world.add({.type = BodyType::Kinematic, .velocity = {0.1, 0}, .shapes = {plumb::box({5, 0.5})}});
    const BodyId ball = world.add({.position = {0, 1.005}, .shapes = {circle(0.5)}});
    world.step(dt);
    world.body(ball).sleep();
    steps(world, 60);
    CHECK_FALSE(world.body(ball).awake());
    CHECK(world.body(ball).position() == Vec2(0, 1.005));
    CHECK(world.body(plate).contacts().empty());
    world.body(plate).setVelocity({0, 1});
    steps(world, 60);
    CHECK(std::fabs(world.body(ball).position().y() - 2) < 5e-3);
}

TEST_CASE("a disabled ball hangs where it is while others pass, and enabled goes on at its 3 m/s",
          "[dynamics][editing]") {
    World world({.gravity = {0, 0}});
    const BodyId ball = world.add({.velocity = {3, 0}, .shapes = {circle(0.5)}});
    const BodyId other = world.add({.position = {5, 0}, .velocity = {-4, 0}, .shapes = {circle(0.5)}});
    world.body(ball).setEnabled(false);
    CHECK_FALSE(world.body(ball).enabled());
    steps(world, 120);
    CHECK(world.body(ball).position() == Vec2(0, 0));
    CHECK((world.body(other).position() - Vec2(-3, 0)).norm() < 1e-12);
    world.body(ball).setEnabled(true);
    steps(world, 60);
    CHECK((world.body(ball).position() - Vec2(3, 0)).norm() < 1e-12);
    const BodyId off = world.add({.position = {9, 0}, .velocity = {1, 0}, .enabled = false, .shapes = {circle(1)}});
    steps(world, 150);
    CHECK(world.body(off).position() == Vec2(9, 0));
    CHECK(world.body(ball).position().x() > 10);
    world.body(off).setEnabled(true);
    steps(world, 60);
    CHECK(world.body(off).position().x() > 9.99);
}

TEST_CASE("a floor that is disabled and enabled holds what has not yet fallen past it", "[dynamics][editing]") {
    Rest rest;
    rest.world.body(rest.plank).setEnabled(false);
    rest.world.step(dt);
    CHECK(rest.world.contactEnds().size() == 1);
    rest.world.body(rest.plank).setEnabled(true);
    steps(rest.world, 120);
    CHECK(std::fabs(rest.world.body(rest.box).position().y() - 1) < 5e-3);
    CHECK_FALSE(rest.world.body(rest.box).awake());
}

TEST_CASE("damping, gravity scale and fixed rotation act from when they are set", "[dynamics][editing]") {
    World world;
    const BodyId ball = world.add({.velocity = {4, 0}, .angularVelocity = 2, .shapes = {circle(0.5)}});
    world.body(ball).setGravityScale(-0.5);
    world.body(ball).setLinearDamping(1);
    world.body(ball).setAngularDamping(2);
    CHECK(world.body(ball).gravityScale() == -0.5);
    CHECK(world.body(ball).linearDamping() == 1);
    CHECK(world.body(ball).angularDamping() == 2);
    steps(world, 60);
    CHECK(std::fabs(world.body(ball).velocity().x() - 4 * std::exp(-1)) < 1e-9);
    CHECK(std::fabs(world.body(ball).velocity().y() - 0.5 * g * (1 - std::exp(-1))) < 1e-9);
    CHECK(std::fabs(world.body(ball).angularVelocity() - 2 * std::exp(-2)) < 1e-9);
    world.body(ball).setFixedRotation(true);
    CHECK(world.body(ball).angularVelocity() == 0);
    world.body(ball).applyAngularImpulse(5);
    CHECK(world.body(ball).angularVelocity() == 0);
    world.body(ball).setFixedRotation(false);
    world.body(ball).applyAngularImpulse(world.body(ball).inertia());
    CHECK(std::fabs(world.body(ball).angularVelocity() - 1) < 1e-15);
    world.body(ball).setTag(77);
    CHECK(world.body(ball).tag() == 77);
}

TEST_CASE("a body in quarantine is disabled, and flies again when it is mended and enabled", "[dynamics][editing]") {
    World world({.gravity = {0, 0}});
    const BodyId ball = world.add({.position = {1, 1}, .velocity = {1e300, 0}, .shapes = {circle(0.5)}});
    world.step(dt);
    CHECK(world.quarantines().size() == 1);
    CHECK(world.body(ball).quarantined());
    CHECK_FALSE(world.body(ball).enabled());
    world.body(ball).setVelocity({1, 0});
    world.body(ball).setEnabled(true);
    CHECK_FALSE(world.body(ball).quarantined());
    steps(world, 60);
    CHECK((world.body(ball).position() - Vec2(2, 1)).norm() < 1e-12);
}

TEST_CASE("a body told to fly at 1e300 m/s in its sleep and removed leaves the next in its slot alone",
          "[dynamics][editing]") {
    World world;
    const BodyId wild = world.add({.awake = false, .shapes = {circle(0.5)}});
    world.body(wild).setVelocity({1e300, 0});
    world.remove(wild);
    const BodyId tame = world.add({.shapes = {circle(0.5)}});
    world.step(dt);
    CHECK(tame.index == wild.index);
    CHECK(world.body(tame).enabled());
    CHECK(world.quarantines().empty());
}

TEST_CASE("edits of what cannot be are refused with field and value, and change nothing",
          "[dynamics][editing][errors]") {
    Rest rest;
    World& world = rest.world;
    const ShapeId shape{rest.box, 0};
    const Body box = world.body(rest.box);
    ShapeDef light = world.shape(shape).def();
    light.material.density = 0;
    const BodyId bare = world.add({.type = BodyType::Static});
    const std::vector<std::pair<std::function<void()>, std::string>> calls{
        {[&] { world.body(bare).setType(BodyType::Dynamic); }, "Body.setType: Dynamic, for the shapes'.mass: 0"},
        {[&] { world.shape(shape).set(light); }, "ShapeDef, for the body's.mass: 0"},
        {[&] { world.remove(shape); }, "World.remove: ShapeId, for the other shapes'.mass: 0"},
        {[&] { world.add(rest.plank, circle(1e6)); }, "ShapeDef.shape: 1000000"},
    };
    const std::uint64_t before = stateHash(world);
    for (const auto& [call, text] : calls) CHECK_THROWS_WITH(call(), containsText(text));
    CHECK(stateHash(world) == before);
    CHECK_FALSE(box.awake());
    CHECK(world.contains(shape));
    CHECK(box.shapes().size() == 1);
}
