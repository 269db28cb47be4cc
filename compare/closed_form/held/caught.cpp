// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/closed_form/free/first_descent.h>
#include <compare/closed_form/free/free_body.h>
#include <compare/closed_form/held/held_motion.h>
#include <compare/closed_form/held/holding.h>
#include <compare/formula/pendulum.h>

namespace plumb::compare {
namespace {

/// When the bullet, a disc that goes straight on, reaches a wall of the block; 0 for never.
double timeToWall(const Scene& scene, const SceneBody& block, const SceneBody& bullet, double radius) {
    Scene stopped = scene;  // the scene with the block at rest
    for (SceneBody& body : stopped.bodies)
        if (body.name == block.name) body.def.type = BodyType::Static;
    const BodyDef& def = stopped.bodies[bodyIndex(stopped, bullet.name)].def;
    double soonest = 0;
    for (const Face& face : obstaclesOf(stopped, def).faces) {
        const std::optional<double> time = firstDescent(
            {face.normal.dot(def.position) - face.offset - radius, face.normal.dot(def.velocity)}, scene.duration);
        if (!time || face.normal.dot(def.velocity) > -1e-9) continue;
        const double at = tangentOf(face.normal).dot(def.position + *time * def.velocity);
        if (at >= face.low && at <= face.high && (soonest == 0 || *time < soonest)) soonest = *time;
    }
    return soonest;
}

}  // namespace

WorkedMotion heldMotion(const CaughtMotion& motion, const Scene& scene) {
    const Hung block = [&] {
        for (const SceneJoint& joint : scene.joints)
            if (joint.bodyA == motion.block || joint.bodyB == motion.block)
                return hungOf(scene, motion.block, joint.name);
        notKnown(motion.block, "nothing holds it");
    }();
    const HeldBody bullet = heldBodyOf(scene, motion.bullet);
    const BodyDef &flies = bullet.scene->def, &hangs = block.body.scene->def;
    const auto* disc = flies.shapes.size() == 1 ? std::get_if<Circle>(&flies.shapes[0].shape) : nullptr;
    if (!disc || flies.velocity.y() != 0 || flies.angularVelocity != 0)
        notKnown(motion.bullet, "it is not a disc that flies level");
    if (block.turns || std::abs(block.angle) > 1e-9 || hangs.velocity != Vec2(0, 0))
        notKnown(motion.block, "it does not hang still on rods");
    for (const ShapeDef& shape : hangs.shapes) {
        const PairLaw law = lawOf(shape, flies.shapes[0]);
        if (law.restitution > 0 || law.friction > 0) notKnown(motion.bullet, "it does not stay in the block at once");
    }
    const double impact = timeToWall(scene, *block.body.scene, *bullet.scene, disc->radius);
    if (impact == 0) notKnown(motion.bullet, "it meets no wall of the block");
    const BallisticPendulum shot{bullet.mass.mass, block.body.mass.mass, std::abs(flies.velocity.x()), block.length,
                                 block.gravity};
    if (riseOf(shot) >= 2 * shot.length) notKnown(motion.block, "it goes over the top");
    const bool isBullet = motion.body == motion.bullet;
    const Vec2 hit = flies.position + impact * flies.velocity;
    return {PendulumMotion{.body = motion.body,
                           .pivot = (isBullet ? hit : hangs.position) + Vec2(0, block.length),
                           .length = block.length,
                           .equivalentLength = block.equivalent,
                           .gravity = block.gravity,
                           .amplitude = std::copysign(amplitudeOf(shot), flies.velocity.x()),
                           .bodyAngle = isBullet ? flies.angle : hangs.angle,
                           .turns = false,
                           .from = impact,
                           .approach = isBullet ? flies.velocity : Vec2(0, 0)}};
}

}  // namespace plumb::compare
