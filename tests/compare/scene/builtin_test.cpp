// SPDX-License-Identifier: MIT
#include <compare/scene/builtin.h>
#include <compare/scene/joint_geometry.h>

#include <algorithm>
#include <cmath>
#include <set>

#include <compare/closed_form/oracle.h>
#include <compare/metric/geometry.h>
#include <compare/metric/joint_state.h>
#include <compare/metric/metrics.h>
#include <compare/scene/scene.h>

#include "catch.h"

namespace plumb::compare {
namespace {

std::string reasonOf(const Check& check) {
    return std::visit([](const auto& c) { return c.reason; }, check);
}

const SceneBody& bodyOf(const Scene& scene, const std::string& name) {
    return *std::ranges::find(scene.bodies, name, &SceneBody::name);
}

/// How far a body's lowest or nearest point is off a line through a point, along the line's unit normal.
double gapTo(const SceneBody& body, const Vec2& point, const Vec2& normal) {
    const Shape& shape = body.def.shapes.at(0).shape;
    if (const auto* circle = std::get_if<Circle>(&shape)) {
        return (body.def.position - point).dot(normal) - circle->radius;
    }
    double nearest = 1e9;
    for (const Vec2& corner : std::get<Polygon>(shape).vertices) {
        const double c = std::cos(body.def.angle);
        const double s = std::sin(body.def.angle);
        const Vec2 turned(c * corner.x() - s * corner.y(), s * corner.x() + c * corner.y());
        nearest = std::min(nearest, (body.def.position + turned - point).dot(normal));
    }
    return nearest;
}

/// When a body of a scene first meets anything.
double firstImpact(Scene scene) {
    scene.closedForm = ClosedForm{};
    scene.duration = 1;
    for (const SceneBody& body : scene.bodies)
        if (body.def.type == BodyType::Dynamic) scene.closedForm->bodies.push_back(FreeMotion{body.name});
    double first = scene.duration;
    for (const BodyMotion& motion : workedOut(scene).bodies) {
        const std::vector<Flight>& flights = std::get<PiecewiseMotion>(motion).flights;
        if (flights.size() > 1) first = std::min(first, flights[1].start);
    }
    return first;
}

}  // namespace

TEST_CASE("there are at least 60 built-in scenes, at least 40 of them with a closed form", "[compare][scene]") {
    const std::vector<Scene> scenes = builtinScenes();
    CHECK(scenes.size() >= 60);
    CHECK(std::ranges::count_if(scenes, [](const Scene& scene) { return scene.closedForm.has_value(); }) >= 40);
}

TEST_CASE("each built-in scene is valid, asks a question, and gives a reason for each check", "[compare][scene]") {
    std::set<std::string> names;
    for (const Scene& scene : builtinScenes()) {
        INFO(scene.name);
        CHECK_NOTHROW(validate(scene));
        CHECK(names.insert(scene.name).second);
        CHECK(scene.question.ends_with("?"));
        CHECK_FALSE(scene.checks.empty());
        for (const Check& check : scene.checks) CHECK_FALSE(reasonOf(check).empty());
        const bool exact =
            std::ranges::any_of(scene.checks, [](const Check& c) { return std::holds_alternative<ExactCheck>(c); });
        CHECK(exact == scene.closedForm.has_value());
        for (const Probe& probe : scene.probes) CHECK_FALSE(probe.unit.empty());
    }
}

TEST_CASE("the metrics that a check may name are the ones that are measured", "[compare][scene]") {
    for (const Scene& scene : builtinScenes()) {
        std::vector<std::string> checkable = checkableMetrics(scene);
        std::vector<std::string> measured = metricNames(scene);
        if (!scene.closedForm) {  // both stand in a run's metrics, without a value
            std::erase(measured, "error_max");
            std::erase(measured, "error_end");
        }
        std::ranges::sort(checkable);
        std::ranges::sort(measured);
        INFO(scene.name);
        CHECK(checkable == measured);
    }
}

TEST_CASE("a scene is found by its name, and only by its name", "[compare][scene]") {
    CHECK(findScene("pendulum_150").value().name == "pendulum_150");
    CHECK_FALSE(findScene("pendulum"));
}

TEST_CASE("each closed form begins where its bodies do, and covers every moving body for as long as it holds",
          "[compare][scene]") {
    for (const Scene& scene : builtinScenes()) {
        if (!scene.closedForm) continue;
        const std::vector<BodyState> start = closedFormStates(scene, 0);
        const double until = scene.closedForm->until;
        const std::vector<BodyState> end = closedFormStates(scene, until > 0 ? until : scene.duration);
        for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
            const BodyDef& def = scene.bodies[i].def;
            if (def.type != BodyType::Dynamic) continue;
            INFO(scene.name << ", " << scene.bodies[i].name);
            CHECK((start[i].position - def.position).norm() < 1e-14);  // rounding of metres
            CHECK((start[i].velocity - def.velocity).norm() < 1e-14);
            CHECK(std::abs(start[i].angle - def.angle) < 1e-14);  // of radians
            CHECK(std::abs(start[i].angularVelocity - def.angularVelocity) < 1e-15);
            CHECK(end[i].position.allFinite());
        }
    }
}

TEST_CASE("no closed form jumps: each flight begins where the one before it ends", "[compare][scene]") {
    int joins = 0;
    for (const Scene& scene : builtinScenes()) {
        if (!scene.closedForm) continue;
        for (const BodyMotion& motion : workedOut(scene).bodies) {
            const auto* piecewise = std::get_if<PiecewiseMotion>(&motion);
            if (!piecewise) continue;
            for (std::size_t i = 1; i < piecewise->flights.size(); ++i) {
                const Flight& before = piecewise->flights[i - 1];
                const Flight& after = piecewise->flights[i];
                const double s = after.start - before.start;
                const Vec2 end = before.position + before.velocity * s + before.acceleration * (s * s / 2);
                INFO(scene.name << ", " << piecewise->body << ", flight " << i);
                // The starts add up: 40 s of rounding, 5e-15 s, at 10 m/s.
                CHECK(scene.wrap.shortest(end, after.position).norm() < 1e-13);
                ++joins;
            }
        }
    }
    // bounce_08, bounce_1, wall_touch, five pairs of discs; two landings twice, six bullets, slide_to_roll, conveyor,
    // one_way_platform; mover_wall, ten laps of four legs, jump_1985, jump_modern; wrap_head_on: each meets
    // ten times, and one crosses the seam after all of them but the first.
    CHECK(joins == 18 + 20 + 1 + 5 * 2 + 2 * 2 + 6 + 1 + 1 + 1 + 1 + 40 + 2 + 5 + 20 + 9);
}

TEST_CASE("the hammer of spin_free balances at its origin", "[compare][scene]") {
    double mass = 0;
    Vec2 moment(0, 0);
    const Scene scene = findScene("spin_free").value();
    for (const ShapeDef& shape : scene.bodies.at(0).def.shapes) {
        const std::vector<Vec2>& corners = std::get<Polygon>(shape.shape).vertices;
        const double weight = shape.material.density * (corners[2] - corners[0]).prod();
        mass += weight;
        moment += weight * (corners[0] + corners[2]) / 2;
    }
    CHECK(moment.norm() / mass < 1e-16);
}

TEST_CASE("a ball dropped from 5 m has its lowest point 5 m over the floor", "[compare][scene]") {
    const Scene scene = findScene("bounce_1").value();
    CHECK(gapTo(bodyOf(scene, "ball"), {0, 0}, {0, 1}) == 5);
    CHECK(std::get<PiecewiseMotion>(workedOut(scene).bodies.at(0)).flights.size() == 21);
    // Each of the twenty times it is up again; apexes 2.0192751093 s apart.
    for (int i = 1; i <= 20; ++i) {
        CHECK(std::abs(closedFormStates(scene, i * 2.0192751093).at(1).position.y() - 5.5) < 1e-12);
    }
}

TEST_CASE("what stands or lies at the start touches exactly", "[compare][scene]") {
    const double s = 0.5, c = std::sqrt(0.75);  // of 30 degrees
    for (const char* name : {"block_slides", "block_sticks", "disc_rolls"}) {
        const Scene scene = findScene(name).value();
        // The slope goes from (0, 5) down to the right.
        CHECK(std::abs(gapTo(scene.bodies.at(1), {0, 5}, {s, c})) < 1e-15);
        const BodyDef& incline = scene.bodies.at(0).def;
        const auto& corners = std::get<Polygon>(incline.shapes.at(0).shape).vertices;
        const Transform pose = startPose(incline);
        const bool isWedge = name == std::string("disc_rolls");
        const double length = isWedge ? 10 : 30;
        CHECK((pose * corners.at(isWedge ? 2 : 3) - Vec2(0, 5)).norm() < 1e-14);
        CHECK((pose * corners.at(isWedge ? 1 : 2) - Vec2(length * c, 5 - length * s)).norm() < 1e-14);
        // At the end it is still on the slope, of 10 m or more.
        const Vec2 end = closedFormStates(scene, scene.duration).at(1).position;
        CHECK((end - Vec2(0, 5)).dot(Vec2(c, -s)) < 9);
    }
    CHECK(gapTo(findScene("box_at_rest").value().bodies.at(1), {0, 0}, {0, 1}) == 0);
    const Scene stack = findScene("stack_of_ten").value();
    REQUIRE(stack.bodies.size() == 11);
    for (int i = 0; i < 10; ++i) {
        CHECK(gapTo(stack.bodies.at(static_cast<std::size_t>(i) + 1), {0, i}, {0, 1}) == 0);
    }
}

TEST_CASE("what rolls, tips, stands in a row or on a hill at the start touches exactly", "[compare][scene]") {
    for (const char* name : {"disc_rolls_down", "ring_rolls_down"}) {
        const Scene scene = findScene(name).value();
        const auto& line = std::get<Segment>(scene.bodies.at(0).def.shapes.at(0).shape);
        const Vec2 along = (line.end - line.start).normalized();
        CHECK(std::abs(std::atan2(-along.y(), along.x()) - 0.3490658503988659) < 1e-15);  // 20 degrees
        CHECK(std::abs(gapTo(scene.bodies.at(1), line.start, {-along.y(), along.x()})) < 1e-15);
        const Vec2 end = closedFormStates(scene, scene.duration).at(1).position;
        CHECK((end - line.start).dot(along) < (line.end - line.start).norm() - 1);
    }
    for (const char* name : {"slide_to_roll", "conveyor"})
        CHECK(gapTo(findScene(name)->bodies.at(1), {0, 0}, {0, 1}) == 0);
    const Scene stack = findScene("tall_stack").value();
    REQUIRE(stack.bodies.size() == 31);
    for (int i = 0; i < 30; ++i) CHECK(gapTo(stack.bodies.at(static_cast<std::size_t>(i) + 1), {0, i}, {0, 1}) == 0);
    const Scene row = findScene("dominoes").value();
    for (std::size_t i = 1; i < row.bodies.size(); ++i) CHECK(gapTo(row.bodies[i], {0, 0}, {0, 1}) == 0);
    for (const char* name : {"terrain_box", "terrain_disc"})
        CHECK(gapTo(findScene(name)->bodies.at(1), {0, 1}, {0, 1}) == 0);
}

TEST_CASE("the block on the slope is half a degree on either side of where it tips", "[compare][scene][law]") {
    for (const char* name : {"tip_below", "tip_above"}) {
        const Scene scene = findScene(name).value();
        const double slope = -scene.bodies.at(1).def.angle;
        const double tipping = 26.565051177 / 180 * 3.141592653589793;  // Worked numbers of response, block tip
        const double halfDegree = 0.008726646259971648;
        CHECK(std::abs(std::abs(slope - tipping) - halfDegree) < 1e-11);
        CHECK((slope > tipping) == (scene.name == "tip_above"));
        CHECK(std::abs(gapTo(scene.bodies.at(1), {0, 0}, {std::sin(slope), std::cos(slope)})) < 1e-15);
        CHECK(scene.bodies.at(1).def.shapes.at(0).material.friction > std::tan(slope));
    }
}

TEST_CASE("each stone of the arch shares a face with the next, and the first and last stand on the floor",
          "[compare][scene]") {
    const Scene scene = findScene("arch").value();
    REQUIRE(scene.bodies.size() == 16);
    const auto cornerOf = [&](std::size_t stone, std::size_t i) {
        const BodyDef& def = scene.bodies.at(stone).def;
        return Vec2(def.position + std::get<Polygon>(def.shapes.at(0).shape).vertices.at(i));
    };
    for (std::size_t stone = 1; stone < 15; ++stone) {
        CHECK((cornerOf(stone, 3) - cornerOf(stone + 1, 0)).norm() < 1e-14);
        CHECK((cornerOf(stone, 2) - cornerOf(stone + 1, 1)).norm() < 1e-14);
    }
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) CHECK(std::abs(cornerOf(1, i).y()) < 1e-14);
    for (const std::size_t i : {std::size_t{2}, std::size_t{3}}) CHECK(std::abs(cornerOf(15, i).y()) < 1e-14);
}

TEST_CASE("no body of the small tumbler overlaps another at the start", "[compare][scene]") {
    const Scene scene = findScene("small_tumbler").value();
    REQUIRE(scene.bodies.size() == 37);
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        CHECK(scene.bodies[i].def.position.cwiseAbs().maxCoeff() < 2.75 - 0.3);  // 0.3 is the farthest reach of any
        for (std::size_t k = 1; k < i; ++k)
            CHECK((scene.bodies[i].def.position - scene.bodies[k].def.position).norm() > 0.6);
    }
}

TEST_CASE("the contacts of the stack of ten carry 9.81 N to 98.1 N", "[compare][scene][law]") {
    const Scene scene = findScene("stack_of_ten").value();
    REQUIRE(scene.probes.size() == 10);
    for (const Probe& probe : scene.probes) {
        const int carried = std::stoi(probe.name.substr(probe.name.find('_') + 1));
        CHECK(std::abs(probe.expected - 9.81 * carried) <
              1e-13);  // Worked numbers of response: N_i = i m g, ten of 1 kg: 98.1
    }
    const auto& lowest = std::get<NormalForceProbe>(scene.probes.at(0).quantity);
    CHECK(scene.probes.at(0).name == "normal_10");
    CHECK(lowest.bodyA == "floor");
    CHECK(lowest.bodyB == "box_1");
}

TEST_CASE("the four middle corners of the pyramid of ten rest on two boxes each", "[compare][scene]") {
    const Scene scene = findScene("small_pyramid").value();
    REQUIRE(scene.bodies.size() == 11);
    for (const SceneBody& body : scene.bodies) {
        if (body.def.type == BodyType::Static || body.def.position.y() == 0.5) continue;
        const auto below = std::ranges::count_if(scene.bodies, [&](const SceneBody& other) {
            const Vec2 d = body.def.position - other.def.position;
            return d.y() == 1 && std::abs(d.x()) < 0.6;
        });
        CHECK(below == 2);
    }
}

TEST_CASE("the gas of 20 discs starts apart and inside, and its first impact comes after the engines' horizon",
          "[compare][scene]") {
    const Scene scene = findScene("elastic_gas").value();
    std::vector<BodyDef> discs;
    for (const SceneBody& body : scene.bodies)
        if (body.def.type == BodyType::Dynamic) discs.push_back(body.def);
    REQUIRE(discs.size() == 20);
    const double radius = 0.2;
    for (std::size_t i = 0; i < discs.size(); ++i) {
        CHECK(discs[i].position.cwiseAbs().maxCoeff() < 5 - radius);
        for (std::size_t k = 0; k < i; ++k) CHECK((discs[i].position - discs[k].position).norm() > 2 * radius);
    }
    const double first = firstImpact(scene);
    const auto agree = std::ranges::find_if(
        scene.checks, [](const Check& check) { return std::holds_alternative<AgreeCheck>(check); });
    INFO("first impact at " << first << " s");
    CHECK(std::get<AgreeCheck>(*agree).until + scene.dt < first);
}

TEST_CASE("the double pendulum starts at 60 and 0 degrees with -19.62 J", "[compare][scene][law]") {
    const Scene scene = findScene("double_pendulum").value();
    const Vec2 pivot = bodyOf(scene, "pivot").def.position;
    const Vec2 upper = bodyOf(scene, "upper").def.position - pivot;
    const Vec2 lower = bodyOf(scene, "lower").def.position - pivot;
    CHECK(std::abs(std::atan2(upper.x(), -upper.y()) - 1.0471975511965976) < 1e-15);
    CHECK(std::abs((lower - upper).x()) < 1e-15);
    CHECK(std::abs(9.81 * (upper.y() + lower.y()) + 19.62) < 1e-14);  // Worked numbers of response, double pendulum
}

TEST_CASE("no joint of a built-in scene is torn or beyond its limit at the start", "[compare][scene]") {
    for (const Scene& scene : builtinScenes()) {
        const JointStates joints(scene);
        std::vector<BodyState> start;
        for (const SceneBody& body : scene.bodies) start.push_back({body.def.position, body.def.angle, {}, 0});
        for (std::size_t i = 0; i < scene.joints.size(); ++i) {
            INFO(scene.name << ", " << scene.joints[i].name);
            CHECK(joints.gap(i, start) < 1e-14);  // rounding of metres
            CHECK(joints.beyondLimit(i, start) == 0);
        }
    }
}

TEST_CASE("nothing overlaps at the start of the scenes that are held together", "[compare][scene]") {
    for (const char* name : {"cradle_one", "cradle_two", "cradle_gap", "ballistic_pendulum", "bridge_under_load",
                             "breaking_bridge", "car_over_hills", "ragdoll", "one_way_platform", "cart_of_a_ton",
                             "nine_carts", "rope_heaps_up", "doll_on_boulders"}) {
        const Scene scene = findScene(name).value();
        std::vector<BodyState> start;
        for (const SceneBody& body : scene.bodies) start.push_back({body.def.position, body.def.angle, {}, 0});
        INFO(name);
        CHECK(*Geometry(scene).penetration(start) < 1e-14);
    }
}

TEST_CASE("the discs of the cradle touch, and those that swing hang 30 degrees to the left", "[compare][scene]") {
    const Scene two = findScene("cradle_two").value();
    REQUIRE(two.bodies.size() == 6);
    for (std::size_t i = 4; i < 6; ++i)
        CHECK(std::abs((two.bodies[i].def.position - two.bodies[i - 1].def.position).norm() - 0.2) < 1e-15);
    for (const std::size_t swung : {std::size_t{1}, std::size_t{2}}) {
        const Vec2 hinge = std::get<RevoluteJointDef>(two.joints.at(swung - 1).def).anchor;
        const Vec2 hang = two.bodies[swung].def.position - hinge;
        CHECK(std::abs(std::atan2(hang.x(), -hang.y()) + 0.5235987755982988) < 1e-15);
    }
    // While one side is out the other hangs: at no time are more than two away from the middle.
    for (double t = 0; t < two.duration; t += 0.05) {
        const std::vector<BodyState> states = closedFormStates(two, t);
        CHECK(std::ranges::count_if(states, [](const BodyState& s) { return std::abs(s.angle) > 1e-9; }) <= 2);
    }
}

TEST_CASE("the bullet hits the block's wall at the end of the third step, and both rise by 4.21 cm",
          "[compare][scene][law]") {
    const Scene scene = findScene("ballistic_pendulum").value();
    const std::vector<BodyState> hit = closedFormStates(scene, 0.05);
    CHECK(std::abs(hit.at(2).position.x() + 0.05 - 0.4) < 1e-15);  // its rim at the wall, 0.4 m from the middle
    // v' = 0.1 * 10 / 1.1 = 0.909 m/s, squared over 19.62
    CHECK(std::abs(scene.probes.at(0).expected - 0.0421227) < 1e-7);
    const std::vector<BodyState> end = closedFormStates(scene, scene.duration);  // half a period: down again
    CHECK(std::abs(end.at(1).position.y()) < 1e-14);
    CHECK((end.at(2).position - end.at(1).position - hit.at(2).position).norm() < 1e-14);
}

TEST_CASE("the gear train's energy is the work of its motor", "[compare][scene][law]") {
    const Scene scene = findScene("gear_train").value();
    std::vector<BodyState> end = closedFormStates(scene, 2);
    end[0] = {scene.bodies[0].def.position, 0, {0, 0}, 0};  // the wall, of which it says nothing
    double energy = 0;
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        const Mass mass = massOf(scene.bodies[i].def);
        energy += (mass.mass * end[i].velocity.squaredNorm() + mass.inertia * std::pow(end[i].angularVelocity, 2)) / 2;
    }
    CHECK(std::abs(energy - 6 * end.at(1).angle) < 1e-11);
    for (std::size_t gear = 4; gear < 7; ++gear) CHECK(JointStates(scene).gap(gear, end) < 1e-14);
    CHECK(std::abs(end.at(1).angle + 2 * end.at(2).angle) < 1e-14);
    CHECK(std::abs(end.at(2).angle - 0.5 * end.at(3).angle) < 1e-14);
}

}  // namespace plumb::compare
