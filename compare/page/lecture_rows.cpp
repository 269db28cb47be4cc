// SPDX-License-Identifier: MIT
#include <compare/page/lecture_table.h>

#include <fmt/format.h>

#include <numbers>

#include <compare/scene/builtin.h>
#include <compare/scene/named.h>
#include <compare/scene/set_field.h>
#include <plumb/math/trig.h>

namespace plumb::compare {
namespace {

constexpr double throwSpeed = 20;  // [m/s]

Vec2 directionAt(int angleDegrees) {
    const SinCos turned = sinCos(angleDegrees * std::numbers::pi / 180);
    return {turned.cos, turned.sin};
}

std::string vectorText(const Vec2& vector) {
    return fmt::format("{:.17g},{:.17g}", vector.x(), vector.y());
}

const BodyDef& bodyOf(const Scene& scene, const std::string& name) {
    return scene.bodies[bodyIndex(scene, name)].def;
}

Scene asked(Scene scene, const std::vector<FieldSetting>& settings, const std::string& query) {
    scene = withFields(std::move(scene), settings);
    scene.answer = "{" + query + "}";
    return scene;
}

LectureRow pendulumRow(int amplitudeDegrees) {
    const Scene scene = *findScene("pendulum_150");
    const Vec2 pivot = bodyOf(scene, "pivot").position;
    const double length = (bodyOf(scene, "bob").position - pivot).norm();
    const Vec2 start = pivot + length * directionAt(amplitudeDegrees - 90);
    return {fmt::format("Pendulum, {} degrees: period", amplitudeDegrees),
            asked(scene, {{"bodies.bob.position", vectorText(start)}}, "period of x of bob")};
}

LectureRow throwRow(int angleDegrees) {
    return {fmt::format("Throw at {} m/s, {} degrees: range", throwSpeed, angleDegrees),
            asked(*findScene("projectile"),
                  {{"bodies.ball.velocity", vectorText(throwSpeed * directionAt(angleDegrees))}, {"duration", "4"}},
                  "x of ball when y first returns to 0")};
}

LectureRow dragRow(int angleDegrees) {
    const Scene scene = *findScene("projectile_damped");
    return {
        fmt::format("Throw at {} m/s, {} degrees, drag {} /s: range", throwSpeed, angleDegrees,
                    bodyOf(scene, "ball").linearDamping),
        asked(scene, {{"bodies.ball.velocity", vectorText(throwSpeed * directionAt(angleDegrees))}, {"duration", "4"}},
              "x of ball when y first returns to 0")};
}

/// The density with which the only shape of a body gives it a mass.
FieldSetting massSetting(const Scene& scene, const std::string& body, double mass) {
    const BodyDef& def = bodyOf(scene, body);
    const double density = def.shapes.front().material.density * mass / massOf(def).mass;
    return {"bodies." + body + ".density", fmt::format("{:.17g}", density)};
}

/// duration: longer than the fall, and too short for the light weight to come to the wheel [s].
LectureRow atwoodRow(double heavyMass, const std::string& duration) {
    const Scene scene = *findScene("atwood_machine");
    return {
        fmt::format("Atwood's machine, {} kg beside 1 kg: time to fall 1 m", heavyMass),
        asked(scene, {massSetting(scene, "light", 1), massSetting(scene, "heavy", heavyMass), {"duration", duration}},
              fmt::format("time when y of heavy first is below {}", bodyOf(scene, "heavy").position.y() - 1))};
}

}  // namespace

const std::vector<std::string>& lectureScenes() {
    static const std::vector<std::string> names{"pendulum_150", "projectile", "projectile_damped", "atwood_machine"};
    return names;
}

std::vector<LectureRow> lectureRows() {
    constexpr int throwAngles[] = {15, 30, 45, 60, 75};
    std::vector<LectureRow> rows;
    for (const int amplitude : {10, 30, 60, 90, 120, 150, 170}) rows.push_back(pendulumRow(amplitude));
    for (const int angle : throwAngles) rows.push_back(throwRow(angle));
    for (const int angle : throwAngles) rows.push_back(dragRow(angle));
    rows.push_back(atwoodRow(1.1, "2.5"));
    rows.push_back(atwoodRow(2, "1"));
    rows.push_back(atwoodRow(10, "0.6"));
    return rows;
}

}  // namespace plumb::compare
