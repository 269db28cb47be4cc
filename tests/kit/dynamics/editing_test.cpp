// SPDX-License-Identifier: MIT
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>
#include "catch.h"

using plumb::BodyDef;
using plumb::BodyId;
using plumb::BodyType;
using plumb::Mass;
using plumb::ShapeDef;
using plumb::ShapeId;
using plumb::Vec2;
using plumb::World;
using plumb::test::containsText;

namespace {

constexpr double g = 9.81;
constexpr double dt = 1.0 / 60;

void steps(World& world, int count) {
    for (int i = 0; i < count; ++i) world.step(dt);
}

/// A box of ten by one under a box of one by one that sleeps on it.
struct Rest {
    World world;
    BodyId plank, box;
    explicit Rest(BodyType type = BodyType::Static, double tilt = 0) {
        const plumb::Rot turn = plumb::Rot::fromAngle(tilt);
        plank = world.add({.type = type, .angle = tilt, .shapes = {plumb::box({5, 0.5})}});
        box = world.add({.position = turn * Vec2(0, 1), .angle = tilt, .shapes = {plumb::box({0.5, 0.5})}});
        steps(world, 120);
    }
};

ShapeDef shapeAt(const Vec2& at) {
    return {.shape = plumb::boxPolygon({0.5, 0.25}, at)};
}

/// A body that flies and spins.
BodyDef spinning(std::vector<ShapeDef> shapes) {
    return {.position = {3, 4}, .angle = 0.7, .velocity = {2, -1}, .angularVelocity = 3, .shapes = std::move(shapes)};
}

/// Where its origin is, how it is turned, and how two of its points move.
std::vector<double> motionOf(const plumb::BodyView& body) {
    const Vec2 p = body.position(), v = body.velocityAt({0, 0}), w = body.velocityAt({10, 5});
    return {p.x(), p.y(), body.angle(), v.x(), v.y(), w.x(), w.y(), body.angularVelocity()};
}

double differenceOf(const std::vector<double>& a, const std::vector<double>& b) {
    double worst = 0;
    for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, std::fabs(a[i] - b[i]));
    return worst;
}

std::vector<BodyId> stackOf(World& world, int count) {
    world.add({.type = BodyType::Static, .shapes = {plumb::segment({-10, 0}, {10, 0})}});
    std::vector<BodyId> boxes;
    for (int i = 0; i < count; ++i)
        boxes.push_back(world.add({.position = {0, 0.5 + i}, .shapes = {plumb::box({0.5, 0.5})}}));
    return boxes;
}

}  // namespace

TEST_CASE("what sleeps on something wakes, and falls or slides, when that is changed in any of ten ways",
          "[dynamics][editing]") {
    struct Change {
        std::string name;
        std::function<void(Rest&)> make;
        double tilt = 0;
    };
    const auto setShape = [](Rest& rest, const std::function<void(ShapeDef&)>& edit) {
        ShapeDef def = rest.world.shape({rest.plank, 0});
        edit(def);
        rest.world.set({rest.plank, 0}, def);
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
                                            d.shape = plumb::boxPolygon({5, 0.2});
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
    const BodyId ball = world.add({.position = {1.3, 8}, .shapes = {plumb::circle(0.25)}});
    steps(world, 120);
    CHECK(world.body(box).position() == where);
    CHECK(std::fabs(world.body(ball).position().y() - (where.y() + 0.2 + 0.25 + 0.25)) < 1e-3);
}

TEST_CASE("a body of any type made another goes on as one that was added as that", "[dynamics][editing]") {
    for (const BodyType from : {BodyType::Static, BodyType::Kinematic, BodyType::Dynamic}) {
        for (const BodyType to : {BodyType::Static, BodyType::Kinematic, BodyType::Dynamic}) {
            World edited({.gravity = {0, -1}}), added({.gravity = {0, -1}});
            BodyDef def = spinning({shapeAt({1, 2}), plumb::circle(0.5)});
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
                world->add({.position = {3, 12}, .velocity = {0, -8}, .shapes = {plumb::circle(1)}});
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
            w.set(ShapeId{b, 1}, plumb::circle(2));
        },
        [](World& w, BodyId b) {
            ShapeDef heavy = w.shape({b, 0});
            heavy.material.density = 20;
            w.set(ShapeId{b, 0}, heavy);
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

TEST_CASE("shapes added and removed 200 times weigh what they weigh together", "[dynamics][editing]") {
    plumb::Random random(5);
    World world({.gravity = {0, 0}});
    std::vector<ShapeDef> kept{plumb::circle(0.3)};
    const BodyId body = world.add(spinning(kept));
    for (int i = 0; i < 200; ++i) {
        const std::vector<ShapeId> ids = world.body(body).shapes();
        REQUIRE(ids.size() == kept.size());
        if (kept.size() < 2 || random.integer(0, 1) == 0) {
            const double x = random.uniform(-3, 3);
            kept.push_back(shapeAt({x, 1}));
            CHECK(world.add(body, kept.back()).number > ids.back().number);
        } else {
            const int which = random.integer(0, static_cast<int>(kept.size()) - 1);
            world.remove(ids[static_cast<std::size_t>(which)]);
            kept.erase(kept.begin() + which);
        }
        world.step(dt);
        World fresh;
        const BodyId same = fresh.add(spinning(kept));
        REQUIRE(world.body(body).mass() == fresh.body(same).mass());
        REQUIRE(world.body(body).inertia() == fresh.body(same).inertia());
    }
}

TEST_CASE("numbers of shapes count on, and a removed one's is refused for ever", "[dynamics][editing]") {
    World world;
    const BodyId body = world.add({.shapes = {plumb::circle(1), plumb::circle(2)}});
    world.remove(ShapeId{body, 1});
    const ShapeId third = world.add(body, plumb::circle(3));
    CHECK(third.number == 2);
    CHECK(world.body(body).shapes() == std::vector<ShapeId>{{body, 0}, {body, 2}});
    CHECK(world.contains(third));
    CHECK_FALSE(world.contains(ShapeId{body, 1}));
    CHECK_THROWS_WITH(world.shape({body, 1}), containsText("ShapeId.number: 1 names no shape of that body"));
    CHECK_THROWS_WITH(world.set({body, 7}, {}), containsText("ShapeId.number: 7"));
    CHECK_THROWS_WITH(world.remove(ShapeId{{}, 0}), containsText("ShapeId.body"));
    world.set({body, 0}, plumb::box({1, 1}));
    CHECK(world.body(body).shapes() == std::vector<ShapeId>{{body, 0}, {body, 2}});
    CHECK(std::get<plumb::Polygon>(world.shape({body, 0}).shape).vertices.size() == 4);
}

TEST_CASE("a shape is given back as it was given, a chain whole", "[dynamics][editing]") {
    World world;
    ShapeDef path = plumb::chain({{0, 0}, {1, 0}, {2, 1}, {5, 2}}, {.friction = 0.3}), ring = path, line = path;
    ring.shape = plumb::Chain{{{0, 0}, {1, 0}, {0, 1}}, true};
    line.shape = plumb::Chain{{{0, 0}, {1, 0}}};
    ShapeDef one = plumb::segment({0, 0}, {1, 1});
    one.tag = 99;
    one.oneWay = Vec2(0, 1);
    const BodyId body = world.add({.type = BodyType::Static, .shapes = {path, one, ring, line}});
    CHECK(world.shape({body, 0}).shape == path.shape);
    CHECK(world.shape({body, 0}).material.friction == 0.3);
    CHECK(world.shape({body, 1}).shape == one.shape);
    CHECK(world.shape({body, 1}).tag == 99);
    CHECK(*world.shape({body, 1}).oneWay == Vec2(0, 1));
    CHECK(world.shape({body, 2}).shape == ring.shape);
    CHECK(world.shape({body, 3}).shape == line.shape);
    world.set({body, 0}, one);  // one piece in the place of three
    CHECK(world.shape({body, 0}).shape == one.shape);
    CHECK(world.shape({body, 2}).shape == ring.shape);
    CHECK(world.body(body).shapes().size() == 4);
}

TEST_CASE("a stack of ten whose bottom box gets another friction or tag stands as if it had not, and no touch ends",
          "[dynamics][editing]") {
    for (const bool friction : {true, false}) {
        World edited({.sleeping = false}), left({.sleeping = false});
        const BodyId bottom = stackOf(edited, 10)[0];
        const std::vector<BodyId> boxes = stackOf(left, 10);
        steps(edited, 300);
        steps(left, 300);
        ShapeDef def = edited.shape({bottom, 0});
        (friction ? def.material.friction : def.material.rollingResistance) = 0.55;
        edited.set({bottom, 0}, def);
        for (int tick = 0; tick < 30; ++tick) {
            edited.step(dt);
            left.step(dt);
            CHECK(edited.contactBegins().size() + edited.contactEnds().size() == 0);
            for (std::size_t i = 0; i < boxes.size(); ++i)
                CHECK((edited.body(edited.bodies()[i + 1]).position() - left.body(boxes[i]).position()).norm() < 2e-5);
        }
    }
}

TEST_CASE("a stack of ten put to sleep and woken at once stands as one that was left alone, within 20 micrometres",
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
            CHECK((woken.body(boxes[i]).position() - left.body(others[i]).position()).norm() < 2e-5);
    }
}

TEST_CASE("a box on the floor that grows ten times as heavy keeps its touch and presses with 98.1 N",
          "[dynamics][editing]") {
    Rest rest;
    World& world = rest.world;
    world.body(rest.box).setMass({10, {0, 0}, 10.0 / 6});
    for (int tick = 0; tick < 10; ++tick) {
        world.step(dt);
        CHECK(world.contactBegins().size() + world.contactEnds().size() == 0);
    }
    double force = 0;
    const plumb::Contact contact = world.body(rest.box).contacts()[0];
    for (const plumb::ContactPoint& point : contact.points) force += point.normalForce;
    CHECK(std::fabs(force - 98.1) < 0.5);
    CHECK(world.body(rest.box).inertia() == 10.0 / 6);
    world.body(rest.box).setMassFromShapes();
    CHECK(world.body(rest.box).mass() == 1);
}

TEST_CASE("a box whose centre of mass is moved beyond its support tips over, and its contacts stay where they are",
          "[dynamics][editing]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {plumb::segment({-5, 0}, {0, 0})}});
    const BodyId box = world.add({.position = {-0.2, 0.5}, .shapes = {plumb::box({0.5, 0.5})}});
    steps(world, 60);
    world.body(box).setMass({1, {0.3, 0}, 0.2});
    world.step(dt);
    REQUIRE(world.body(box).contacts().size() == 1);
    const plumb::Contact contact = world.body(box).contacts()[0];
    for (const plumb::ContactPoint& point : contact.points) CHECK(std::fabs(point.position.y()) < 2e-3);
    steps(world, 60);
    CHECK(world.body(box).position().y() < 0.3);
}

TEST_CASE("a given mass outlasts new shapes and a time as a static body", "[dynamics][editing]") {
    World world;
    const BodyId body = world.add({.mass = Mass{3, {0.1, 0}, 2}, .shapes = {plumb::circle(1)}});
    world.add(body, plumb::circle(5));
    CHECK(world.body(body).mass() == 3);
    world.body(body).setType(BodyType::Static);
    CHECK(world.body(body).mass() == 0);
    world.body(body).setType(BodyType::Kinematic);
    world.body(body).setType(BodyType::Dynamic);
    CHECK(world.body(body).mass() == 3);
    CHECK(world.body(body).inertia() == 2);
    CHECK((world.body(body).centerOfMass() - Vec2(0.1, 0)).norm() < 1e-15);
}

TEST_CASE("a filter that lets in what it kept out finds what lies there; wider, it keeps the touch",
          "[dynamics][editing]") {
    Rest rest;
    World& world = rest.world;
    ShapeDef def = world.shape({rest.plank, 0});
    def.filter.category = 3;
    world.set({rest.plank, 0}, def);
    world.step(dt);
    CHECK(world.contactBegins().size() + world.contactEnds().size() == 0);
    CHECK(world.body(rest.box).contacts().size() == 1);
    def.filter.mask = 2;
    world.set({rest.plank, 0}, def);
    world.step(dt);
    CHECK(world.contactEnds().size() == 1);
    def.filter.mask = 3;
    world.set({rest.plank, 0}, def);
    steps(world, 60);
    CHECK(std::fabs(world.body(rest.box).position().y() - 1) < 5e-3);
    CHECK(world.body(rest.box).contacts().size() == 1);
}

TEST_CASE("a filter decides anew who is in a sensor", "[dynamics][editing][sensor]") {
    World world({.gravity = {0, 0}});
    ShapeDef gate = plumb::circle(1);
    gate.sensor = true;
    const BodyId sensor = world.add({.type = BodyType::Static, .shapes = {gate}});
    world.add({.shapes = {plumb::circle(0.5)}});
    steps(world, 3);
    for (int i = 0; i < 4; ++i) {
        gate.filter.mask = i % 2 == 0 ? 2 : 1;
        world.set({sensor, 0}, gate);
        world.step(dt);
        CHECK(world.sensorEnds().size() == (i % 2 == 0 ? 1 : 0));
        CHECK(world.sensorBegins().size() == (i % 2 == 0 ? 0 : 1));
        world.step(dt);
        CHECK(world.sensorEnds().size() + world.sensorBegins().size() == 0);
    }
}

TEST_CASE("a floor made a sensor lets a ball through and tells of it; solid again, it holds the next",
          "[dynamics][editing][sensor]") {
    World world;
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {plumb::box({5, 0.5})}});
    const BodyId ball = world.add({.position = {0, 1}, .shapes = {plumb::circle(0.5)}});
    steps(world, 60);
    ShapeDef def = world.shape({floor, 0});
    def.sensor = true;
    world.set({floor, 0}, def);
    std::size_t begins = 0, ends = 0;
    for (int tick = 0; tick < 60; ++tick) {
        world.step(dt);
        begins += world.sensorBegins().size();
        ends += world.sensorEnds().size();
    }
    CHECK(begins == 1);
    CHECK(ends == 1);
    CHECK(world.body(ball).position().y() < -1);
    world.body(ball).setPose({0, 1}, 0);
    world.body(ball).setVelocity({0, 0});
    def.sensor = false;
    world.set({floor, 0}, def);
    steps(world, 60);
    CHECK(std::fabs(world.body(ball).position().y() - 1) < 1e-3);
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
    const BodyId ball = world.add({.shapes = {plumb::circle(1)}});
    CHECK_THROWS_WITH(world.body(ball).moveTo({0, 0}, 0, dt), containsText("Body.moveTo: the body is not kinematic"));
    CHECK_THROWS_WITH(world.body(lift).moveTo({0, 0}, 0, 0), containsText("Body.moveTo: dt: 0"));
}

TEST_CASE("a stack put to sleep sleeps as a whole until a ball lands on it", "[dynamics][editing]") {
    World world;
    const std::vector<BodyId> boxes = stackOf(world, 3);
    steps(world, 10);
    world.body(boxes[1]).sleep();
    for (const BodyId box : boxes) CHECK_FALSE(world.body(box).awake());
    const BodyId ball = world.add({.position = {0, 5}, .shapes = {plumb::circle(0.3)}});
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
    const BodyId ball = world.add({.position = {0, 1.005}, .shapes = {plumb::circle(0.5)}});
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
    const BodyId ball = world.add({.velocity = {3, 0}, .shapes = {plumb::circle(0.5)}});
    const BodyId other = world.add({.position = {5, 0}, .velocity = {-4, 0}, .shapes = {plumb::circle(0.5)}});
    world.body(ball).setEnabled(false);
    CHECK_FALSE(world.body(ball).enabled());
    steps(world, 120);
    CHECK(world.body(ball).position() == Vec2(0, 0));
    CHECK((world.body(other).position() - Vec2(-3, 0)).norm() < 1e-12);
    world.body(ball).setEnabled(true);
    steps(world, 60);
    CHECK((world.body(ball).position() - Vec2(3, 0)).norm() < 1e-12);
    const BodyId off =
        world.add({.position = {9, 0}, .velocity = {1, 0}, .enabled = false, .shapes = {plumb::circle(1)}});
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
    const BodyId ball = world.add({.velocity = {4, 0}, .angularVelocity = 2, .shapes = {plumb::circle(0.5)}});
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
    const BodyId ball = world.add({.position = {1, 1}, .velocity = {1e300, 0}, .shapes = {plumb::circle(0.5)}});
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
    const BodyId wild = world.add({.awake = false, .shapes = {plumb::circle(0.5)}});
    world.body(wild).setVelocity({1e300, 0});
    world.remove(wild);
    const BodyId tame = world.add({.shapes = {plumb::circle(0.5)}});
    world.step(dt);
    CHECK(tame.index == wild.index);
    CHECK(world.body(tame).enabled());
    CHECK(world.quarantines().empty());
}

TEST_CASE("edits of what cannot be are refused with field and value, and change nothing",
          "[dynamics][editing][errors]") {
    Rest rest;
    World& world = rest.world;
    const double nan = std::nan("");
    const ShapeId shape{rest.box, 0};
    plumb::Body box = world.body(rest.box), plank = world.body(rest.plank);
    ShapeDef light = world.shape(shape), odd = light;
    light.material.density = 0;
    odd.material.friction = -1;
    const BodyId bare = world.add({.type = BodyType::Static});
    const std::vector<std::pair<std::function<void()>, std::string>> calls{
        {[&] {
             box.setMass({-1, {0, 0}, 1});
         },
         "Body.setMass: mass.mass: -1"},
        {[&] {
             box.setMass({1, {nan, 0}, 1});
         },
         "Body.setMass: mass.center: (nan, 0)"},
        {[&] {
             box.setMass({1, {0, 0}, 0});
         },
         "Body.setMass: mass.inertia: 0"},
        {[&] {
             plank.setMass({1, {0, 0}, 1});
         },
         "Body.setMass: the body is not dynamic"},
        {[&] { plank.setMassFromShapes(); }, "Body.setMassFromShapes: the body is not dynamic"},
        {[&] { world.body(bare).setType(BodyType::Dynamic); }, "Body.setType: Dynamic, for the shapes'.mass: 0"},
        {[&] { box.setGravityScale(nan); }, "Body.setGravityScale: scale: nan"},
        {[&] { box.setLinearDamping(-1); }, "Body.setLinearDamping: damping: -1"},
        {[&] { box.setAngularDamping(nan); }, "Body.setAngularDamping: damping: nan"},
        {[&] { box.applyAngularImpulse(nan); }, "Body.applyAngularImpulse: impulse: nan"},
        {[&] {
             (void)box.velocityAt({nan, 0});
         },
         "BodyView.velocityAt: point: (nan, 0)"},
        {[&] { world.set(shape, light); }, "ShapeDef, for the body's.mass: 0"},
        {[&] { world.set(shape, odd); }, "ShapeDef.material.friction: -1"},
        {[&] { world.add(rest.box, odd); }, "ShapeDef.material.friction: -1"},
        {[&] { world.remove(shape); }, "World.remove: ShapeId, for the other shapes'.mass: 0"},
        {[&] { world.add(rest.plank, plumb::circle(1e6)); }, "ShapeDef.shape: 1000000"},
    };
    const std::uint64_t before = plumb::stateHash(world);
    for (const auto& [call, text] : calls) CHECK_THROWS_WITH(call(), containsText(text));
    CHECK(plumb::stateHash(world) == before);
    CHECK_FALSE(box.awake());
    CHECK(world.contains(shape));
    CHECK(box.shapes().size() == 1);
}
