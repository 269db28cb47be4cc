// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/held/held_motion.h>
#include <compare/closed_form/held/holding.h>

namespace plumb::compare {
namespace {

constexpr double inLine = 1e-9;  // up to this distance from the spring's line, a value is on it [m, m/s, m/s^2]

void refuseSideways(const std::string& body, const Vec2& along, const Vec2& what, const std::string& called) {
    if (std::abs(cross(along, what)) > inLine) notKnown(body, called + " is not along its spring");
}

}  // namespace

WorkedMotion heldMotion(const SpringsMotion& motion, const Scene& scene) {
    const HeldBody body = heldBodyOf(scene, motion.body);
    const BodyDef& def = body.scene->def;
    const std::vector<Holding> holdings = holdingsOf(scene, body);
    if (holdings.size() != 1 || scene.joints[holdings[0].joint].name != motion.joint)
        notKnown(motion.body, "the joint " + motion.joint + " alone does not hold it");
    const Holding& hold = holdings[0];
    const auto* joint = std::get_if<DistanceJointDef>(&scene.joints[hold.joint].def);
    if (!joint || !joint->spring || joint->spring->stiffness <= 0 || joint->maxMotorForce > 0)
        notKnown(motion.body, "the joint " + motion.joint + " is not a spring");
    if ((hold.held - body.center).norm() > inLine || (def.position - body.center).norm() > inLine)
        notKnown(motion.body, "its spring does not hold it at its centre of mass");
    if (def.angularVelocity != 0) notKnown(motion.body, "it turns");
    const Vec2 along = (hold.held - hold.fixed).normalized();
    refuseSideways(motion.body, along, body.gravity, "gravity");
    refuseSideways(motion.body, along, def.velocity, "its speed");
    const double stretched = (hold.held - hold.fixed).norm(), k = joint->spring->stiffness, m = body.mass.mass;
    const double rest = joint->length.value_or(stretched) + m * body.gravity.dot(along) / k;
    const double offset = stretched - rest, speed = def.velocity.dot(along);
    const double swing = std::hypot(offset, speed / std::sqrt(k / m));
    if (rest - swing <= std::max(0.0, joint->minLength) || rest + swing >= joint->maxLength)
        notKnown(motion.body, "its spring comes to an end");
    return {OscillatorMotion{.body = motion.body,
                             .rest = hold.fixed + rest * along,
                             .direction = along,
                             .offset = offset,
                             .speed = speed,
                             .mass = m,
                             .stiffness = k,
                             .damping = joint->spring->damping}};
}

WorkedMotion heldMotion(const FloatsMotion& motion, const Scene& scene) {
    const HeldBody body = heldBodyOf(scene, motion.body, motion.field);
    const BodyDef& def = body.scene->def;
    const auto field = std::ranges::find(scene.fields, motion.field, &SceneField::name);
    const auto* pool = std::get_if<Pool>(&field->def.law);
    if (!pool || field->def.region || pool->drag != 0) notKnown(motion.body, "it does not float in still water");
    const auto* box = def.shapes.size() == 1 ? std::get_if<Polygon>(&def.shapes[0].shape) : nullptr;
    if (!box || box->radius > 0 || box->vertices.size() != 4 || !def.fixedRotation || def.angle != 0)
        notKnown(motion.body, "it is not an upright box that keeps its angle");
    if (!holdingsOf(scene, body).empty()) notKnown(motion.body, "a joint holds it");
    Vec2 low = box->vertices[0], high = low;
    for (const Vec2& corner : box->vertices) low = low.cwiseMin(corner), high = high.cwiseMax(corner);
    for (const Vec2& c : box->vertices)
        if ((c.x() != low.x() && c.x() != high.x()) || (c.y() != low.y() && c.y() != high.y()))
            notKnown(motion.body, "its sides are not upright");
    const Vec2 pull = pool->fluid.gravity;
    const double g = downwardGravity(body), m = body.mass.mass, width = high.x() - low.x();
    const double k = pool->fluid.density * -pull.y() * width;
    if (pull.x() != 0 || !(k > 0) || def.velocity.x() != 0) notKnown(motion.body, "it does not bob up and down alone");
    const double deep = m * g / k;
    const Vec2 rest(def.position.x(), pool->fluid.surface.y() - deep - low.y());
    const double offset = def.position.y() - rest.y();
    const double swing = std::hypot(offset, def.velocity.y() / std::sqrt(k / m));
    if (swing > deep || deep + swing > high.y() - low.y()) notKnown(motion.body, "it leaves the water, or dives");
    return {OscillatorMotion{
        .body = motion.body, .rest = rest, .offset = offset, .speed = def.velocity.y(), .mass = m, .stiffness = k}};
}

}  // namespace plumb::compare
