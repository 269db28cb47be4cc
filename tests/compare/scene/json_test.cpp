// SPDX-License-Identifier: MIT
#include <compare/scene/json.h>

#include <limits>

#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

constexpr double noBound = std::numeric_limits<double>::infinity();

/// One of each kind, between the bodies a and b; no field has its default value.
std::vector<SceneJoint> fullJoints() {
    const Limit limit{-noBound, 0.5};
    const Spring spring{20, 3};
    const Breaking breaking{100, 50};
    return {
        {"h", "a", "b", RevoluteJointDef{{}, {}, {1, 2}, limit, spring, 0.25, -3, 4, true, breaking}},
        {"s", "a", "b", PrismaticJointDef{{}, {}, {1, 2}, {0, 2}, limit, spring, 0.25, -3, 4, true, breaking}},
        {"r", "b", "a", DistanceJointDef{{}, {}, {1, 2}, {3, 4}, 5, spring, 1, 6, -7, noBound, true, breaking}},
        {"w", "a", "b", WeldJointDef{{}, {}, {1, 2}, spring, Spring{7, 8}, true, breaking}},
        {"v", "a", "b", WheelJointDef{{}, {}, {1, 2}, {1, 1}, limit, spring, 0.25, -3, 4, true, breaking}},
        {"p", "a", "b", PulleyJointDef{{}, {}, {1, 9}, {2, 9}, {1, 2}, {3, 4}, 2, false, breaking}},
        {.name = "g", .def = GearJointDef{{}, {}, -2.5, breaking}, .jointA = "h", .jointB = "s"},
        {"m", "a", "b", MotorJointDef{{}, {}, Vec2(1, 2), 0.5, 6, {3, 4}, 5, 7, noBound, false, breaking}},
        {"t", "b", "", TargetJointDef{{}, {1, 2}, {3, 4}, spring, 60, breaking}},
        {"f", "a", "b", FilterJointDef{}},
    };
}

/// One of each law; no member has its default value.
std::vector<SceneField> fullFields() {
    const Attractor pull{{1, 2}, 3, 4, 5, 6};
    const Fluid water{7, {8, 9}, {1, -2}};
    return {
        {"u", {.law = UniformGravity{{1, 2}}}},
        {"g", {.law = MutualGravity{3, 4}}},
        {"d", {.law = Drag{5, 6, {7, 8}}, .region = Circle{2, {1, 1}}}},
        {"a", {.law = pull, .filter = {2, 3, -4}}},
        {"m", {.law = Magnet{{}, pull}}, "b"},
        {"p", {.law = Pool{water, 3, {4, 5}}, .region = boxPolygon({1, 2})}},
        {"f", {.law = GroundFriction{0.25, 2, 3}}},
    };
}

/// No field has its default value.
Scene fullScene() {
    const Material material{.density = 2,
                            .friction = 0.25,
                            .restitution = 0.5,
                            .rollingResistance = 0.125,
                            .surfaceSpeed = -3,
                            .frictionMix = Mix::Product,
                            .restitutionMix = Mix::Average};
    const Filter filter{.category = 0x8000000000000001u, .mask = 6, .group = -2147483647 - 1};
    const std::vector<Vec2> corners{{0, 0}, {1, 0}, {0, 1}};
    return {
        .name = "full",
        .question = "Does \"all\" of it\nsurvive \xc3\xa4?",
        .gravity = {1, -2},
        .duration = 3,
        .dt = 0.1,
        .sleeping = false,
        .bodies = {{"a",
                    {.type = BodyType::Static,
                     .shapes = {{Segment{{0, 1}, {2, 3}, Vec2(-1, 0), Vec2(4, 5)}}, loop({{0, 0}, {1, 2}, {3, 4}})}}},
                   {"b",
                    {.type = BodyType::Kinematic,
                     .position = {1.0 / 3, 2},
                     .angle = 3,
                     .velocity = {4, 5},
                     .angularVelocity = 6,
                     .gravityScale = 7,
                     .linearDamping = 8,
                     .angularDamping = 9,
                     .canSleep = false,
                     .shapes = {{Circle{0.75, {0.5, 0.25}}, material, filter, true, Vec2(0, 2), nullptr, 9},
                                roundedPolygon(corners, 0.125)}}},
                   {"c",
                    {.fixedRotation = true,
                     .lockX = true,
                     .lockY = true,
                     .awake = false,
                     .enabled = false,
                     .tag = 0x8000000000000002u,
                     .mass = Mass{10, {11, 12}, 13},
                     .shapes = {capsule({1, 2}, {3, 5}, 0.25)}}}},
        .joints = fullJoints(),
        .fields = fullFields(),
        .closedForm = ClosedForm{.formula = "f",
                                 .source = "s",
                                 .until = 2,
                                 .bodies = {PiecewiseMotion{"a", {{}, {1, {2, 3}, {4, 5}, {6, 7}, 8, 9, 10}}},
                                            PendulumMotion{"b", {1, 2}, 3, 4, 5, -0.5, 6, false, 7, {8, 9}, Side::Left},
                                            OscillatorMotion{"c", {1, 2}, {1, 0}, 3, 4, 5, 6, 7}}},
        .probes = {{"p", AngleProbe{"a"}, 1, 2, "rad"},
                   {"q", NormalForceProbe{"a", "b"}, 3, 4, "N"},
                   {"r", JointForceProbe{"h"}, 5, 6, "N", 7, Watch::Largest},
                   {"s", PositionProbe{"a", {1, 0}}, 1, 2, "m", 3, Watch::Last},
                   {"t", VelocityProbe{"a", {0, 1}}, 1, 2, "m/s"},
                   {"u", LimitProbe{"h"}, 1, 2, "rad"},
                   {"v", JointBrokenProbe{"h"}, 1, 2, "-"},
                   {"w", SensorCountProbe{"a"}, 1, 2, "-"}},
        .checks = {ExactCheck{0.5, "e"}, AgreeCheck{0.25, 2, "a"},
                   InvariantCheck{"energy_drift", 0.125, {"plumb", "box2d-3"}, "i"}, OrderCheck{3, {"box2d-2.4"}, "o"}},
    };
}

Scene withBox(const std::string& box) {
    return fromJson(R"({"name": "a", "bodies": [{"name": "b", "shapes": [{"box": {)" + box + "}}]}]}", "f.json");
}

}  // namespace

TEST_CASE("every built-in scene reads back as it was written", "[compare][scene]") {
    for (const Scene& scene : builtinScenes()) {
        INFO(scene.name);
        const std::string text = toJson(scene);
        CHECK(toJson(fromJson(text, "f.json")) == text);
    }
}

TEST_CASE("motions that hold names survive writing and reading", "[compare][scene]") {
    Scene scene = fullScene();
    scene.closedForm->bodies = {FreeMotion{"a", 0.5}, SwingsMotion{"b", "h", Side::Right, "a"},
                                SpringsMotion{"c", "h"}};
    const std::string text = toJson(scene);
    CHECK(toJson(fromJson(text, "f.json")) == text);
    const Scene read = fromJson(text, "f.json");
    CHECK(std::get<FreeMotion>(read.closedForm->bodies.at(0)).shortestFlight == 0.5);
    CHECK(std::get<SwingsMotion>(read.closedForm->bodies.at(1)).after == "a");
    CHECK(std::get<SwingsMotion>(read.closedForm->bodies.at(1)).side == Side::Right);
    CHECK(std::get<SpringsMotion>(read.closedForm->bodies.at(2)).joint == "h");
}

TEST_CASE("each field survives writing and reading to the last bit", "[compare][scene]") {
    const Scene scene = fullScene();
    const std::string text = toJson(scene);
    CHECK(toJson(fromJson(text, "f.json")) == text);
    const Scene read = fromJson(text, "f.json");
    CHECK(read.question == scene.question);
    CHECK(read.gravity == scene.gravity);
    CHECK(read.dt == 0.1);
    const BodyDef& body = read.bodies.at(1).def;
    CHECK(body.type == BodyType::Kinematic);
    CHECK(body.position.x() == 1.0 / 3);
    CHECK_FALSE(body.canSleep);
    CHECK(read.bodies.at(2).def.fixedRotation);
    CHECK(read.bodies.at(2).def.mass->center == Vec2(11, 12));
    CHECK(std::get<Circle>(body.shapes.at(0).shape).center == Vec2(0.5, 0.25));
    CHECK(body.shapes.at(0).material.restitution == 0.5);
    CHECK(body.shapes.at(0).filter.category == 0x8000000000000001u);
    CHECK(std::get<Polygon>(body.shapes.at(1).shape).vertices.at(1) == Vec2(1, 0));
    CHECK(std::get<Segment>(read.bodies.at(0).def.shapes.at(0).shape).end == Vec2(2, 3));
    CHECK_FALSE(read.sleeping);
    CHECK_FALSE(read.bodies.at(2).def.awake);
    const Material& material = body.shapes.at(0).material;
    CHECK(material.rollingResistance == 0.125);
    CHECK(material.surfaceSpeed == -3);
    CHECK(material.frictionMix == Mix::Product);
    CHECK(material.restitutionMix == Mix::Average);
    CHECK(body.shapes.at(0).filter.group == -2147483647 - 1);
    CHECK(std::get<Polygon>(body.shapes.at(1).shape).radius == 0.125);
    CHECK(std::get<Capsule>(read.bodies.at(2).def.shapes.at(0).shape).end == Vec2(3, 5));
    CHECK(std::get<Segment>(read.bodies.at(0).def.shapes.at(0).shape).after == Vec2(4, 5));
    const auto& ring = std::get<Chain>(read.bodies.at(0).def.shapes.at(1).shape);
    CHECK(ring.closed);
    CHECK(ring.points == std::vector<Vec2>{{0, 0}, {1, 2}, {3, 4}});
    CHECK(std::get<RevoluteJointDef>(read.joints.at(0).def).motorSpeed == -3);
    CHECK(std::get<RevoluteJointDef>(read.joints.at(0).def).maxMotorTorque == 4);
    CHECK(std::get<RevoluteJointDef>(read.joints.at(0).def).collideConnected);
    CHECK(std::get<DistanceJointDef>(read.joints.at(2).def).length == 5);
    CHECK(std::get<PiecewiseMotion>(read.closedForm->bodies.at(0)).flights.at(1).angularAcceleration == 10);
    CHECK_FALSE(std::get<PendulumMotion>(read.closedForm->bodies.at(1)).turns);
    CHECK(std::get<PendulumMotion>(read.closedForm->bodies.at(1)).side == Side::Left);
    CHECK(std::get<OscillatorMotion>(read.closedForm->bodies.at(2)).damping == 7);
    CHECK(read.probes.at(3).watch == Watch::Last);
    CHECK(read.probes.at(3).until == 3);
    CHECK(std::get<JointForceProbe>(read.probes.at(2).quantity).joint == "h");
    CHECK(std::get<InvariantCheck>(read.checks.at(2)).engines.at(1) == "box2d-3");
    CHECK(std::get<OrderCheck>(read.checks.at(3)).reason == "o");
}

TEST_CASE("each kind of joint survives writing and reading, with its spring, limit and what breaks it",
          "[compare][scene]") {
    const std::vector<SceneJoint> joints = fromJson(toJson(fullScene()), "f.json").joints;
    REQUIRE(joints.size() == std::variant_size_v<JointDef>);
    for (std::size_t i = 0; i < joints.size(); ++i) CHECK(joints[i].def.index() == i);
    const auto& hinge = std::get<RevoluteJointDef>(joints[0].def);
    CHECK(hinge.limit->lower == -noBound);
    CHECK(hinge.limit->upper == 0.5);
    CHECK(hinge.spring->stiffness == 20);
    CHECK(hinge.spring->damping == 3);
    CHECK(hinge.restAngle == 0.25);
    CHECK(hinge.breaking.force == 100);
    CHECK(hinge.breaking.torque == 50);
    CHECK(std::get<PrismaticJointDef>(joints[1].def).axis == Vec2(0, 2));
    CHECK(std::get<DistanceJointDef>(joints[2].def).maxMotorForce == noBound);
    CHECK(std::get<DistanceJointDef>(joints[2].def).maxLength == 6);
    CHECK(std::get<WeldJointDef>(joints[3].def).bending->damping == 8);
    CHECK(std::get<WheelJointDef>(joints[4].def).restShift == 0.25);
    CHECK(std::get<PulleyJointDef>(joints[5].def).groundB == Vec2(2, 9));
    CHECK(std::get<GearJointDef>(joints[6].def).ratio == -2.5);
    CHECK(joints[6].jointB == "s");
    CHECK(std::get<MotorJointDef>(joints[7].def).offset == Vec2(1, 2));
    CHECK(std::get<MotorJointDef>(joints[7].def).maxTorque == noBound);
    CHECK(std::get<TargetJointDef>(joints[8].def).target == Vec2(3, 4));
    CHECK(joints[8].bodyB.empty());
}

TEST_CASE("each law of a field survives writing and reading, with its region and its filter",
          "[compare][scene][fields]") {
    const std::vector<SceneField> fields = fromJson(toJson(fullScene()), "f.json").fields;
    REQUIRE(fields.size() == std::variant_size_v<FieldLaw>);
    for (std::size_t i = 0; i < fields.size(); ++i) CHECK(fields[i].def.law.index() == i);
    CHECK(std::get<UniformGravity>(fields[0].def.law).acceleration == Vec2(1, 2));
    CHECK(std::get<MutualGravity>(fields[1].def.law).softening == 4);
    CHECK(std::get<Drag>(fields[2].def.law).wind == Vec2(7, 8));
    CHECK(std::get<Circle>(*fields[2].def.region) == Circle{2, {1, 1}});
    CHECK(std::get<Attractor>(fields[3].def.law).range == 6);
    CHECK(fields[3].def.filter == Filter{2, 3, -4});
    CHECK(std::get<Magnet>(fields[4].def.law).pull.power == 4);
    CHECK(fields[4].body == "b");
    CHECK(std::get<Pool>(fields[5].def.law).fluid.gravity == Vec2(1, -2));
    CHECK(std::get<Pool>(fields[5].def.law).flow == Vec2(4, 5));
    CHECK(std::get<Polygon>(*fields[5].def.region).vertices.size() == 4);
    CHECK(std::get<GroundFriction>(fields[6].def.law).lever == 3);
}

TEST_CASE("a sensor, a one-way shape, tags, locks and what is not enabled survive writing and reading",
          "[compare][scene]") {
    const Scene read = fromJson(toJson(fullScene()), "f.json");
    const ShapeDef& shape = read.bodies.at(1).def.shapes.at(0);
    CHECK(shape.sensor);
    CHECK(shape.oneWay == Vec2(0, 2));
    CHECK(shape.tag == 9);
    const BodyDef& body = read.bodies.at(2).def;
    CHECK(body.lockX);
    CHECK(body.lockY);
    CHECK_FALSE(body.enabled);
    CHECK(body.tag == 0x8000000000000002u);
}

TEST_CASE("a spring with nothing said of it is written, and a joint without one reads without one",
          "[compare][scene]") {
    Scene scene = fullScene();
    scene.joints = {{"r", "a", "b", DistanceJointDef{.anchorB = {0, 1}, .spring = Spring{}}}};
    scene.probes.clear();
    const std::string text = toJson(scene);
    CHECK(text.find(R"("spring": {})") != std::string::npos);
    CHECK(std::get<DistanceJointDef>(fromJson(text, "f.json").joints.at(0).def).spring.has_value());
    scene.joints = {{"r", "a", "b", DistanceJointDef{.anchorB = {0, 1}}}};
    CHECK_FALSE(std::get<DistanceJointDef>(fromJson(toJson(scene), "f.json").joints.at(0).def).spring);
}

TEST_CASE("a field is written only where it differs from its default", "[compare][scene]") {
    const Scene scene{.name = "a", .bodies = {{"b", {.shapes = {circle(0.5)}}}}};
    CHECK(toJson(scene) == R"({"name": "a", "bodies": [{"name": "b", "shapes": [{"circle": {}}]}]})");
    // A field that fullScene sets is one that stands in its text: none is forgotten.
    const std::string text = toJson(fullScene());
    for (const char* field : {"name",
                              "question",
                              "gravity",
                              "duration",
                              "dt",
                              "sleeping",
                              "bodies",
                              "joints",
                              "closedForm",
                              "probes",
                              "checks",
                              "type",
                              "position",
                              "angle",
                              "velocity",
                              "angularVelocity",
                              "gravityScale",
                              "linearDamping",
                              "angularDamping",
                              "fixedRotation",
                              "canSleep",
                              "awake",
                              "mass",
                              "shapes",
                              "inertia",
                              "center",
                              "circle",
                              "radius",
                              "polygon",
                              "vertices",
                              "segment",
                              "start",
                              "end",
                              "before",
                              "after",
                              "capsule",
                              "chain",
                              "points",
                              "closed",
                              "rollingResistance",
                              "surfaceSpeed",
                              "frictionMix",
                              "restitutionMix",
                              "group",
                              "motorSpeed",
                              "maxMotorTorque",
                              "material",
                              "density",
                              "friction",
                              "restitution",
                              "filter",
                              "category",
                              "mask",
                              "bodyA",
                              "bodyB",
                              "revolute",
                              "anchor",
                              "collideConnected",
                              "distance",
                              "anchorA",
                              "anchorB",
                              "length",
                              "formula",
                              "source",
                              "until",
                              "piecewise",
                              "body",
                              "flights",
                              "acceleration",
                              "angularAcceleration",
                              "pendulum",
                              "pivot",
                              "equivalentLength",
                              "amplitude",
                              "bodyAngle",
                              "turns",
                              "normalForce",
                              "jointForce",
                              "joint",
                              "expected",
                              "from",
                              "unit",
                              "exact",
                              "limit",
                              "reason",
                              "agree",
                              "tolerance",
                              "invariant",
                              "metric",
                              "engines",
                              "order",
                              "sensor",
                              "oneWay",
                              "tag",
                              "lockX",
                              "lockY",
                              "enabled",
                              "limit",
                              "lower",
                              "upper",
                              "spring",
                              "stiffness",
                              "damping",
                              "breaking",
                              "force",
                              "torque",
                              "restAngle",
                              "prismatic",
                              "axis",
                              "maxMotorForce",
                              "restShift",
                              "minLength",
                              "maxLength",
                              "weld",
                              "bending",
                              "wheel",
                              "pulley",
                              "groundA",
                              "groundB",
                              "ratio",
                              "gear",
                              "jointA",
                              "jointB",
                              "motor",
                              "offset",
                              "rate",
                              "maxForce",
                              "maxTorque",
                              "target",
                              "approach",
                              "side",
                              "oscillator",
                              "rest",
                              "direction",
                              "speed",
                              "watch",
                              "position",
                              "velocity",
                              "jointBroken",
                              "sensorCount"}) {
        INFO(field);
        CHECK(text.find("\"" + std::string(field) + "\":") != std::string::npos);
    }
}

TEST_CASE("a box of 2 m by 1 m reads as a polygon of four corners", "[compare][scene]") {
    const Scene scene = withBox(R"("halfSize": [1, 0.5], "center": [3, 0])");
    const auto& polygon = std::get<Polygon>(scene.bodies.at(0).def.shapes.at(0).shape);
    CHECK(polygon.vertices == std::vector<Vec2>{{2, -0.5}, {4, -0.5}, {4, 0.5}, {2, 0.5}});
}

TEST_CASE("a box of 2 m by 1 m with a radius of 0.1 m reads as a rounded polygon", "[compare][scene]") {
    const Scene scene = withBox(R"("halfSize": [1, 0.5], "radius": 0.1)");
    const auto& polygon = std::get<Polygon>(scene.bodies.at(0).def.shapes.at(0).shape);
    CHECK(polygon.vertices == std::vector<Vec2>{{-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}});
    CHECK(polygon.radius == 0.1);
}

TEST_CASE("a motor of infinite torque is written and read as \"infinite\"", "[compare][scene]") {
    Scene scene = fullScene();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    std::get<RevoluteJointDef>(scene.joints.at(0).def).maxMotorTorque = infinite;
    const std::string text = toJson(scene);
    CHECK(text.find(R"("maxMotorTorque": "infinite")") != std::string::npos);
    CHECK(std::get<RevoluteJointDef>(fromJson(text, "f.json").joints.at(0).def).maxMotorTorque == infinite);
}

TEST_CASE("a mass that a file gives as the number 3 is that of the body's shapes", "[compare][scene]") {
    const auto bodyOf = [](const std::string& mass) {
        return R"({"name": "a", "bodies": [{"name": "b", "mass": )" + mass + R"(, "shapes": [{"circle": {}}]}]})";
    };
    const BodyDef def = fromJson(bodyOf("3"), "f").bodies[0].def;
    CHECK_FALSE(def.mass);
    CHECK(massOf(def).mass == Approx(3).epsilon(1e-14));
    CHECK_THROWS_WITH(fromJson(bodyOf("-1"), "f"), "f:1: bodies[0].mass: -1 is not positive");
}

}  // namespace plumb::compare
