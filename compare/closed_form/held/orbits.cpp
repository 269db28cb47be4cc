// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/held/held_motion.h>
#include <compare/closed_form/held/holding.h>

namespace plumb::compare {
namespace {

/// Two bodies that attract each other: r'' = -strength r / r^3, r from the other one to the body.
struct Drawn {
    HeldBody body{}, other{};
    double strength = 0;  ///< K [m^3/s^2]
};

double strengthOf(const SceneField& field, const std::string& body, double m, double other) {
    if (const auto* law = std::get_if<MutualGravity>(&field.def.law)) {
        if (law->softening > 0) notKnown(body, "the field " + field.name + " is softened");
        return law->constant * (m + other);
    }
    const auto* magnet = std::get_if<Magnet>(&field.def.law);
    if (!magnet || magnet->pull.power != 2 || magnet->pull.softening > 0 || std::isfinite(magnet->pull.range) ||
        magnet->pull.center != Vec2(0, 0))
        notKnown(body, "the field " + field.name + " does not draw by the inverse square of the distance");
    return magnet->pull.strength * (1 / m + 1 / other);
}

Drawn drawnOf(const OrbitsMotion& motion, const Scene& scene) {
    const auto field = std::ranges::find(scene.fields, motion.field, &SceneField::name);
    std::vector<std::string> drawn;
    for (const SceneBody& body : scene.bodies)
        if (actsOn(*field, body)) drawn.push_back(body.name);
    if (drawn.size() != 2) notKnown(motion.body, "not two bodies draw each other");
    Drawn pair{heldBodyOf(scene, motion.body, motion.field),
               heldBodyOf(scene, drawn[0] == motion.body ? drawn[1] : drawn[0], motion.field)};
    if (std::holds_alternative<Magnet>(field->def.law) && field->body != drawn[0] && field->body != drawn[1])
        notKnown(motion.body, "another body carries the magnet");
    for (const HeldBody& body : {pair.body, pair.other}) {
        if (!holdingsOf(scene, body).empty()) notKnown(motion.body, "a joint holds " + body.scene->name);
        if (body.mass.center != Vec2(0, 0)) notKnown(motion.body, "an origin is not a centre of mass");
        if (body.gravity != pair.body.gravity || body.gravity != Vec2(0, 0))
            notKnown(motion.body, "gravity pulls beside the other body");
    }
    pair.strength = strengthOf(*field, motion.body, pair.body.mass.mass, pair.other.mass.mass);
    return pair;
}

double reachOf(const BodyDef& def) {
    double reach = 0;
    for (const ShapeDef& shape : def.shapes) {
        const auto* circle = std::get_if<Circle>(&shape.shape);
        if (!circle) return std::numeric_limits<double>::infinity();
        reach = std::max(reach, circle->radius + circle->center.norm());
    }
    return reach;
}

double meanOf(double anomaly, double e) {
    return anomaly - e * std::sin(anomaly);
}

/// When the two touch on the way inwards; 0 if they do not.
double touchTime(const Drawn& pair, double a, double e, double rate, double anomaly) {
    if (!mayTouch(pair.body.scene->def, pair.other.scene->def)) return 0;
    const double reach = reachOf(pair.body.scene->def) + reachOf(pair.other.scene->def);
    if (!std::isfinite(reach)) notKnown(pair.body.scene->name, "not both are discs");
    if (a * (1 - e) >= reach) return 0;
    const double inwards = -std::acos(std::clamp((1 - reach / a) / e, -1.0, 1.0));
    const double mean = std::fmod(meanOf(inwards, e) - meanOf(anomaly, e) + 4 * std::numbers::pi, 2 * std::numbers::pi);
    return mean / rate;
}

}  // namespace

WorkedMotion heldMotion(const OrbitsMotion& motion, const Scene& scene) {
    const Drawn pair = drawnOf(motion, scene);
    const BodyDef &one = pair.body.scene->def, &other = pair.other.scene->def;
    const double m = pair.body.mass.mass, far = pair.other.mass.mass, all = m + far, K = pair.strength;
    const Vec2 r = one.position - other.position, v = one.velocity - other.velocity;
    const double distance = r.norm(), energy = v.squaredNorm() / 2 - K / distance, turn = cross(r, v);
    if (!(K > 0) || !(energy < 0)) notKnown(motion.body, "it does not come back");
    if (turn < 0) notKnown(motion.body, "it goes round clockwise");
    const double a = -K / (2 * energy), rate = std::sqrt(K / (a * a * a));
    const Vec2 towards = Vec2(-turn * perp(v)) / K - r / distance;  // v x h = -h perp(v)
    const double e = std::min(1.0, towards.norm());
    const bool circle = e < 1e-9;
    const Vec2 nearEnd = circle ? Vec2(r / distance) : Vec2(towards.normalized());
    const double anomaly = circle ? 0 : std::atan2(r.dot(v) / std::sqrt(K * a), 1 - distance / a);
    return {KeplerMotion{.body = motion.body,
                         .focus = (m * one.position + far * other.position) / all,
                         .drift = (m * one.velocity + far * other.velocity) / all,
                         .nearEnd = nearEnd,
                         .semiMajorAxis = a * far / all,
                         .eccentricity = circle ? 0 : e,
                         .period = 2 * std::numbers::pi / rate,
                         .since = meanOf(anomaly, circle ? 0 : e) / rate},
            touchTime(pair, a, e, rate, anomaly)};
}

}  // namespace plumb::compare
