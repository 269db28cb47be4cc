// SPDX-License-Identifier: MIT
#include <compare/scene/set_field.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <compare/scene/builtin.h>
#include <compare/scene/json.h>

#include "catch.h"

namespace plumb::compare {
namespace {

Scene twoBalls() {
    return {.name = "two",
            .bodies = {{"ground", {.type = BodyType::Static, .shapes = {segment({-9, 0}, {9, 0})}}},
                       {"ball", {.position = {0, 5}, .shapes = {circle(0.5), box({1, 1})}}}},
            .joints = {{"hinge", "ground", "ball", RevoluteJointDef{}}},
            .closedForm = ClosedForm{.bodies = {PiecewiseMotion{"ball", {{}}}}},
            .checks = {InvariantCheck{"energy_drift", 1}}};
}

Scene setTo(const std::string& path, const std::string& value) {
    return withField(twoBalls(), path, value);
}

std::string setComplaint(const std::string& path, const std::string& value) {
    try {
        setTo(path, value);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no complaint";
}

}  // namespace

TEST_CASE("a number, a fraction, a vector, a word and true are set by the names of a file's fields",
          "[compare][scene][set]") {
    CHECK(setTo("duration", "3.5").duration == 3.5);
    CHECK(setTo("dt", "1/240").dt == 1.0 / 240);
    CHECK(setTo("gravity", "0,-1/2").gravity == Vec2(0, -0.5));
    CHECK(setTo("gravity.1", "-1").gravity == Vec2(0, -1));
    CHECK(setTo("sleeping", "false").sleeping == false);
    CHECK(setTo("bodies.ball.velocity", "15,26").bodies[1].def.velocity == Vec2(15, 26));
    CHECK(setTo("bodies.1.type", "kinematic").bodies[1].def.type == BodyType::Kinematic);
    CHECK(setTo("bodies.ball.tag", "18446744073709551615").bodies[1].def.tag == 18446744073709551615u);
    CHECK(setTo("question", "1, 2 or 3?").question == "1, 2 or 3?");
    const Scene bound = setTo("checks.0.invariant.engines", "plumb,box2d-2.4");
    CHECK(std::get<InvariantCheck>(bound.checks[0]).engines == std::vector<std::string>{"plumb", "box2d-2.4"});
    const auto hinge = [](const std::string& field, const std::string& value) {
        return std::get<RevoluteJointDef>(setTo("joints.hinge.revolute." + field, value).joints[0].def);
    };
    CHECK(std::isinf(hinge("maxMotorTorque", "infinite").maxMotorTorque));
    CHECK(hinge("limit", R"({"upper": 1})").limit->upper == 1);
    CHECK_FALSE(hinge("limit", "null").limit);
    const Scene flown = setTo("closedForm.bodies.ball.piecewise.flights.0.angle", "2");
    CHECK(std::get<PiecewiseMotion>(flown.closedForm->bodies[0]).flights[0].angle == 2);
}

TEST_CASE("a body's friction is that of all its shapes, and a shape's that of its material", "[compare][scene][set]") {
    const Scene both = setTo("bodies.ball.friction", "0.125");
    for (const ShapeDef& shape : both.bodies[1].def.shapes) CHECK(shape.material.friction == 0.125);
    CHECK(both.bodies[0].def.shapes[0].material.friction == twoBalls().bodies[0].def.shapes[0].material.friction);
    const Scene one = setTo("bodies.ball.shapes.0.restitution", "0.25");
    CHECK(one.bodies[1].def.shapes[0].material.restitution == 0.25);
    CHECK(one.bodies[1].def.shapes[1].material.restitution == 0);
    CHECK(setTo("bodies.ball.shapes.1.material.density", "3").bodies[1].def.shapes[1].material.density == 3);
}

TEST_CASE("what shapes hold is set for a whole body, also a part of it", "[compare][scene][set]") {
    const Scene masked = setTo("bodies.ball.filter.mask", "6");
    for (const ShapeDef& shape : masked.bodies[1].def.shapes) CHECK(shape.filter.mask == 6);
    CHECK(masked.bodies[0].def.shapes[0].filter.mask == Filter{}.mask);
    const Scene sensing = setTo("bodies.ball.sensor", "true");
    for (const ShapeDef& shape : sensing.bodies[1].def.shapes) CHECK(shape.sensor);
    CHECK(
        setComplaint("bodies.ball.filter.masks", "6")
            .starts_with("bodies.ball.filter.masks=6: bodies.ball.filter.masks: \"masks\" is not a field, the nearest "
                         "is mask; known are "));
}

TEST_CASE("a body of two shapes gets a mass of 3 kg: the densities are scaled alike, the centre stays",
          "[compare][scene][set]") {
    Scene scene = twoBalls();
    scene.bodies[1].def.shapes[0].material.density = 4;
    const BodyDef heavy = withField(scene, "bodies.ball.mass", "3").bodies[1].def;
    const Mass was = massOf(scene.bodies[1].def), is = massOf(heavy);
    CHECK_FALSE(heavy.mass);
    CHECK(is.mass == Approx(3).epsilon(1e-14));
    CHECK(is.inertia == Approx(was.inertia * 3 / was.mass).epsilon(1e-14));
    CHECK((is.center - was.center).norm() < 1e-14);
    const auto density = [&](std::size_t shape) { return heavy.shapes[shape].material.density; };
    CHECK(density(0) == Approx(4 * density(1)).epsilon(1e-14));
    CHECK(setTo("bodies.ball.mass", R"({"mass": 3, "inertia": 1})").bodies[1].def.mass->mass == 3);
}

TEST_CASE("a mass of 3 kg holds whatever else of the body is set, before it or after it", "[compare][scene][set]") {
    const FieldSetting mass{"bodies.ball.mass", "3"}, radius{"bodies.ball.shapes.0.circle.radius", "2"},
        density{"bodies.ball.density", "7"};
    for (const auto& settings :
         {std::vector{mass, radius, density}, std::vector{density, mass, radius}, std::vector{radius, density, mass}}) {
        const BodyDef def = withFields(twoBalls(), settings).bodies[1].def;
        CHECK(massOf(def).mass == Approx(3).epsilon(1e-14));
        CHECK(std::get<Circle>(def.shapes[0].shape).radius == 2);
    }
}

TEST_CASE("of a mass that is given with its inertia both change by the same factor", "[compare][scene][set]") {
    Scene scene = twoBalls();
    scene.bodies[1].def.mass = Mass{2, {0.5, 0}, 0.25};
    const std::optional<Mass> mass = withField(scene, "bodies.ball.mass", "6").bodies[1].def.mass;
    REQUIRE(mass);
    CHECK(mass->mass == 6);
    CHECK(mass->center == Vec2(0.5, 0));
    CHECK(mass->inertia == 0.75);
}

TEST_CASE("a mass that is not positive, and one of a static body, are refused", "[compare][scene][set][errors]") {
    CHECK(setComplaint("bodies.ball.mass", "0") == "bodies.ball.mass=0: bodies[1].mass: 0 is not positive");
    CHECK(setComplaint("bodies.ball.mass", "-2") == "bodies.ball.mass=-2: bodies[1].mass: -2 is not positive");
    CHECK(setComplaint("bodies.ball.mass", "heavy") ==
          "bodies.ball.mass=heavy: bodies[1].mass: \"heavy\" is not a number or an object");
    CHECK(setComplaint("bodies.ground.mass", "3") ==
          "bodies.ground.mass=3: bodies[0].mass: 3 is the mass of a static body, wanted a dynamic body, or no mass");
}

TEST_CASE("nothing but the field is changed in any built-in scene", "[compare][scene][set]") {
    for (const Scene& scene : builtinScenes()) {
        INFO(scene.name);
        Scene expected = scene;
        expected.question = "?";
        CHECK(toJson(withField(scene, "question", "?")) == toJson(expected));
    }
}

TEST_CASE("a setting that is refused names the path, the value and what was wanted", "[compare][scene][set][errors]") {
    CHECK(setComplaint("dt", "0") == "dt=0: dt: 0 is not positive");
    CHECK(setComplaint("dt", "1/0") == "dt=1/0: 1/0 divides by 0");
    CHECK(setComplaint("dt", "fast") == "dt=fast: dt: \"fast\" is not a number");
    CHECK(setComplaint("gravity", "1,2,3") == "gravity=1,2,3: gravity: [1,2,3] is not two numbers [x, y]");
    CHECK(setComplaint("bodies.ball.type", "statc") ==
          "bodies.ball.type=statc: bodies[1].type: \"statc\" is not static, kinematic or dynamic");
    CHECK(setComplaint("bodies.bal.angle", "1") ==
          "bodies.bal.angle=1: bodies.bal: \"bal\" is not the name of one of them, the nearest is ball; known are "
          "ground, ball");
    CHECK(setComplaint("bodies.2.angle", "1") ==
          "bodies.2.angle=1: bodies.2: \"2\" is not a place in a list of 2, which count from 0");
    CHECK(setComplaint("gravty", "1")
              .starts_with("gravty=1: gravty: \"gravty\" is not a field, the nearest is gravity; known are name"));
    CHECK(setComplaint("bodies.ball.mass.mass", "1") ==
          "bodies.ball.mass.mass=1: bodies.ball.mass: is not given, wanted all of it at once, as JSON");
    CHECK(setComplaint("dt.x", "1") == "dt.x=1: dt.x: dt has no parts: it is 0.016666666666666666");
    CHECK(setComplaint("gravity", "[0") == "gravity=[0: \"[0\" is not JSON");
}

TEST_CASE("a setting is a path, a sign and a value, of which only the first sign parts", "[compare][scene][set]") {
    const FieldSetting setting = fieldSettingOf("question=a=b?");
    CHECK(setting.path == "question");
    CHECK(setting.value == "a=b?");
    CHECK_THROWS_AS(fieldSettingOf("dt"), std::invalid_argument);
    CHECK_THROWS_AS(fieldSettingOf("=3"), std::invalid_argument);
}

TEST_CASE("of two settings of one field the last holds", "[compare][scene][set]") {
    const std::vector<FieldSetting> settings{{"dt", "0.5"}, {"duration", "3"}, {"dt", "0.25"}};
    const Scene set = withFields(twoBalls(), settings);
    CHECK(set.dt == 0.25);
    CHECK(set.duration == 3);
}

TEST_CASE("two values that are wrong one without the other may be set in any order", "[compare][scene]") {
    const FieldSetting limit{"joints.hinge.revolute.limit", R"({"lower": 0, "upper": 1})"};
    const FieldSetting lower{"joints.hinge.revolute.limit.lower", "2"}, upper{"joints.hinge.revolute.limit.upper", "3"};
    for (const auto& settings : {std::vector{limit, lower, upper}, std::vector{limit, upper, lower}}) {
        const Scene set = withFields(twoBalls(), settings);
        CHECK(std::get<RevoluteJointDef>(set.joints[0].def).limit->lower == 2);
        CHECK(std::get<RevoluteJointDef>(set.joints[0].def).limit->upper == 3);
    }
    CHECK_THROWS_WITH(withFields(twoBalls(), std::vector{limit, lower}), Catch::Contains("lower"));
}

}  // namespace plumb::compare
