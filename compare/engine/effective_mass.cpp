// SPDX-License-Identifier: MIT
#include <compare/engine/effective_mass.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <plumb/shapes/mass.h>

namespace plumb::compare {
namespace {

struct Inverse {
    double mass = 0, inertia = 0;
    Vec2 center{0, 0};  ///< in the body's frame [m]
};

Inverse inverseOf(const BodyDef& def) {
    if (def.type != BodyType::Dynamic) return {};
    const Mass mass = massOf(def);
    return {1 / mass.mass, def.fixedRotation ? 0 : 1 / mass.inertia, mass.center};
}

/// One body's part of 1 / m.
double mobility(const Scene& scene, std::size_t body, const Vec2& localAnchor, const Vec2& direction) {
    if (body == noBody) return 0;
    const Inverse inverse = inverseOf(scene.bodies[body].def);
    const Vec2 arm = startPose(scene.bodies[body].def).rotation * Vec2(localAnchor - inverse.center);
    const double lever = cross(arm, direction);
    return inverse.mass + inverse.inertia * lever * lever;
}

}  // namespace

double effectiveMass(const Scene& scene, const JointGeometry& joint, const Vec2& direction) {
    const double sum = mobility(scene, joint.bodyA, joint.localAnchorA, direction) +
                       mobility(scene, joint.bodyB, joint.localAnchorB, direction);
    return sum > 0 ? 1 / sum : 0;
}

double effectiveInertia(const Scene& scene, const JointGeometry& joint) {
    const double sum =
        inverseOf(scene.bodies[joint.bodyA].def).inertia + inverseOf(scene.bodies[joint.bodyB].def).inertia;
    return sum > 0 ? 1 / sum : 0;
}

Frequency frequencyOf(const Spring& spring, double mass) {
    constexpr double unseen = 2 * std::numbers::pi * 1e-4;  // [rad/s]
    if (mass == 0) return {};
    double rate = std::sqrt(spring.stiffness / mass);
    if (spring.damping > 0) rate = std::max(rate, unseen);
    if (rate == 0) return {};
    return {rate / (2 * std::numbers::pi), spring.damping / (2 * mass * rate)};
}

}  // namespace plumb::compare
