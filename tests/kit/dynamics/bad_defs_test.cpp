// SPDX-License-Identifier: MIT
// What is refused of a definition that its description does not say, and what becomes of numbers that are taken?
#include "catch.h"
#include "kit/dynamics/sound_defs.h"

namespace plumb::test {

namespace {

struct BadShape {
    Shape shape;
    std::string member, complaint;
};

const std::vector<BadShape>& badShapes() {
    static const std::string folds = " folds the line straight back on itself", inLine = "(0, -1) lies in line";
    static const std::vector<BadShape> all{
        {Capsule{{1, 0}, {1, 0}, 1}, ".end", "(1, 0) is the same point as start"},
        {Polygon{}, ".vertices", "0 corners are fewer than 3"},
        {Polygon{{{-1, -1}, {1, -1}}}, ".vertices", "2 corners are fewer than 3"},
        {Polygon{std::vector<Vec2>(65, Vec2(0, 0))}, ".vertices", "65 corners are more than 64"},
        {Polygon{{{-1, -1}, {1, -1}, {1, -1}, {-1, 1}}}, ".vertices[2]", "(1, -1) repeats the corner before it"},
        {Polygon{{{-1, -1}, {0, -1}, {1, -1}, {1, 1}}}, ".vertices[1]", inLine + " with the corners beside it"},
        {Polygon{{{-1, -1}, {1, -1}, {0, -0.5}, {-1, 1}}}, ".vertices[2]", "(0, -0.5) makes the polygon not convex"},
        {Polygon{{{1, 1}, {1, -1}, {-1, -1}, {-1, 1}}}, ".vertices", "run clockwise, not counter-clockwise"},
        {Segment{{0, 0}, {0, 0}}, ".end", "(0, 0) is the same point as start"},
        {Segment{.before = Vec2(0, 0)}, ".before", "(0, 0) is the end of the segment"},
        {Segment{.before = Vec2(0.5, 0)}, ".before", "(0.5, 0)" + folds},
        {Segment{.after = Vec2(1, 0)}, ".after", "(1, 0) is the end of the segment"},
        {Segment{.after = Vec2(0.5, 0)}, ".after", "(0.5, 0)" + folds},
        {Chain{}, ".points", "0 points are fewer than 2"},
        {Chain{{{0, 0}}}, ".points", "1 points are fewer than 2"},
        {Chain{{{0, 0}, {1, 0}}, true}, ".points", "2 points are fewer than 3 of a closed chain"},
        {Chain{{{0, 0}, {1, 0}, {1, 0}}}, ".points[2]", "(1, 0) repeats the point before it"},
        {Chain{{{0, 0}, {1, 0}, {0.5, 0}}}, ".points[1]", "(1, 0)" + folds},
        {Circle{.radius = 1, .center = {2e5, 0}}, "", "200001 m from the body's origin"},
        {Circle{.radius = 1e6}, "", "1000000 m from the body's origin"},
    };
    return all;
}

struct BadBody {
    BodyDef def;
    std::string field, complaint;
};

std::vector<BadBody> badBodies() {
    const std::string noMass = "is not a positive finite mass",
                      noInertia = "is not a positive finite moment of inertia";
    const std::string noArea = "0 " + noMass + " (a dynamic body needs a shape with area and density";
    const std::string arm = "mass.inertia, its radius of gyration", armRange = "is not within 1e-06 to 1000000";
    const Vec2 o{0, 0};
    const BodyType fixed = BodyType::Static;
    const auto weighed = [](const Mass& mass) { return BodyDef{.mass = mass, .shapes = {circle(1)}}; };
    const auto dense = [](double density) { return BodyDef{.shapes = {circle(1, {.density = density})}}; };
    return {
        {{.type = fixed, .velocity = {0, 2}}, "velocity", "(0, 2) on a static body, not (0, 0)"},
        {{.type = fixed, .angularVelocity = 2}, "angularVelocity", "2 on a static body, not 0"},
        {{.angularVelocity = 2, .fixedRotation = true, .shapes = {circle(1)}},
         "angularVelocity",
         "2 on a body of fixed rotation"},
        {{.type = fixed, .mass = Mass{2, o, 1}}, "mass", "2 kg given to a body that is not dynamic"},
        {{}, "shapes.mass", noArea},
        {{.shapes = {segment({0, 0}, {1, 0})}}, "shapes.mass", noArea},
        {dense(0), "shapes.mass", noArea},
        {dense(1e20), "shapes.mass", "is not within 1e-12"},
        {weighed({0, o, 1}), "mass.mass", "0 " + noMass},
        {weighed({1e-13, o, 1}), "mass.mass", "1e-13 is not within 1e-12"},
        {weighed({1e13, o, 1}), "mass.mass", "10000000000000 is not within 1e-12"},
        {weighed({1, {0, -2e5}, 1}), "mass.center", "(0, -200000) is more than 100000 m from the body's origin"},
        {weighed({1, o, 0}), "mass.inertia", "0 " + noInertia},
        {weighed({1, o, 1e-13}), arm, armRange},
        {weighed({1, o, 1e13}), arm, armRange},
    };
}

/// Where it falls on the floor, and another thing lies on it.
void takeBody(Bench& bench, const BodyDef& def) {
    bench.world.add(def);
    bench.world.add({.position = {2.1, 9.5}, .shapes = {circle(0.4)}});
}
void takeShape(Bench& bench, const ShapeDef& def) {
    bench.world.add(bench.crate, def);
}
void replaceShape(Bench& bench, const ShapeDef& def) {
    bench.world.shape(bench.liftShape).set(def);
}

void takeWorld(Bench& bench, const WorldDef& def) {
    World world(def);
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {box({20, 0.5})}});
    for (int i = 0; i < 3; ++i) world.add({.position = {0.1 * i, 1.0 + i}, .shapes = {box({0.5, 0.5})}});
    const BodyId bob = world.add({.position = {3, 2}, .shapes = {circle(0.5)}});
    world.join(RevoluteJointDef{.bodyA = floor, .bodyB = bob, .anchor = {2, 2}});
    bench.world = std::move(world);
}

/// The same for each bench.
auto always(const auto& def) {
    return [def](const Bench&) { return def; };
}

using Faults = std::vector<std::string>;

}  // namespace

TEST_CASE("a shape is refused when its points do not make one, or lie too far out", "[dynamics][errors]") {
    Bench bench;
    for (const BadShape& bad : badShapes()) {
        const ShapeDef def{.shape = bad.shape};
        const std::string field = "ShapeDef.shape" + bad.member, inBody = "BodyDef.shapes[1].shape" + bad.member;
        const BodyDef body{.shapes = {circle(1), def}};
        const auto fault = [&](const std::string& name, auto&& take) {
            return faultOf(bench, take, name, bad.complaint);
        };
        CHECK(fault(field, [&] { takeShape(bench, def); }) == "");
        CHECK(fault(field, [&] { replaceShape(bench, def); }) == "");
        CHECK(fault(inBody, [&] { takeBody(bench, body); }) == "");
    }
}

TEST_CASE("a body is refused when its members do not suit each other, or its mass no solver", "[dynamics][errors]") {
    Bench bench;
    for (const BadBody& bad : badBodies())
        CHECK(faultOf(
                  bench, [&] { takeBody(bench, bad.def); }, "BodyDef." + bad.field, bad.complaint) == "");
}

TEST_CASE("a joint is refused when its members do not suit each other or the world", "[dynamics][joints][errors]") {
    forEachSoundJoint([](const auto& make) {
        Bench bench;
        forEachWrongTogether(bench, make(bench), [&](const auto& bad, const Wrong& wrong) {
            CHECK(faultOf(
                      bench, [&] { bench.world.join(bad); }, fullName(bad, wrong.path) + wrong.behind,
                      wrong.complaint) == "");
        });
    });
}

TEST_CASE("a joint can be changed after its bodies have gone 1,000 km, or can no longer move",
          "[dynamics][joints][errors]") {
    forEachSoundJoint([](const auto& make) {
        Bench bench;
        const auto sound = make(bench);
        const JointId id = bench.world.join(sound);
        for (const BodyId body : {bench.ball, bench.crate}) bench.world.body(body).setPose({1e6, 2e6}, 3);
        CHECK(refusalOf([&] { bench.world.joint(id).set(sound); }) == "");
        for (const BodyId body : {bench.ball, bench.crate}) bench.world.body(body).setType(BodyType::Static);
        CHECK(refusalOf([&] { bench.world.joint(id).set(sound); }) == "");
        CHECK(unsoundAfter(bench.world) == "");
    });
}

TEST_CASE(
    "numbers from 1e-320 to 1.7e308 in a WorldDef, BodyDef or ShapeDef are refused, or leave every body finite "
    "or quarantined",
    "[dynamics][errors]") {
    CHECK(unsoundWith(always(WorldDef{}), takeWorld, unsoundAfter) == Faults{});
    BodyDef weighed = soundBody();
    weighed.mass = Mass{1, {0, 0}, 1};
    for (const BodyDef& body : {soundBody(), weighed})
        CHECK(unsoundWith(always(body), takeBody, unsoundAfter) == Faults{});
    for (const ShapeDef& shape : soundShapes()) {
        CHECK(unsoundWith(always(shape), takeShape, unsoundAfter) == Faults{});
        CHECK(unsoundWith(always(shape), replaceShape, unsoundAfter) == Faults{});
    }
}

TEST_CASE(
    "numbers from 1e-320 to infinity in a joint, new or a step old, are refused, or leave every body finite and "
    "out of quarantine",
    "[dynamics][joints][errors]") {
    forEachSoundJoint([](const auto& make) {
        const auto join = [](Bench& bench, const auto& def) { bench.world.join(def); };
        const auto set = [&](Bench& bench, const auto& def) {
            const JointId id = bench.world.join(make(bench));
            bench.world.step(1.0 / 60);
            bench.world.joint(id).set(def);
        };
        CHECK(unsoundWith(make, join, unsoundOrQuarantinedAfter) == Faults{});
        CHECK(unsoundWith(make, set, unsoundOrQuarantinedAfter) == Faults{});
    });
}

}  // namespace plumb::test
