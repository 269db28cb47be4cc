// SPDX-License-Identifier: MIT
#include <plumb/forces/gravity.h>

#include <cmath>
#include <numbers>

#include <plumb/forces/detail/require_numbers.h>
#include <plumb/math/check.h>

namespace plumb {
namespace {

void requireSound(const MutualGravity& gravity, const PointMass& a, const PointMass& b) {
    requireNumbers(gravity);
    requireNotNegative(a.mass, "PointMass a", ".mass");
    requireNotNegative(b.mass, "PointMass b", ".mass");
}

double softened(const MutualGravity& gravity, double squaredDistance) {
    return std::sqrt(squaredDistance + gravity.softening * gravity.softening);
}

}  // namespace

Vec2 gravityForceOf(const MutualGravity& gravity, const PointMass& a, const PointMass& b) {
    const Vec2 d = b.position - a.position;
    const double r = std::sqrt(d.squaredNorm() + gravity.softening * gravity.softening);
    const double pull = gravity.constant * (a.mass * b.mass) / (r * r * r);  // the same bits for either body
    if (!std::isfinite(pull)) return {0, 0};                                 // same position, or overflow
    return -pull * d;
}

Vec2 gravityForce(const UniformGravity& gravity, double mass) {
    requireNotNegative(mass, "gravityForce: mass");
    return mass * gravity.acceleration;
}

double potentialEnergy(const UniformGravity& gravity, double mass, const Vec2& position) {
    requireNotNegative(mass, "potentialEnergy: mass");
    return -mass * gravity.acceleration.dot(position);
}

Vec2 gravityForce(const MutualGravity& gravity, const PointMass& a, const PointMass& b) {
    requireSound(gravity, a, b);
    return gravityForceOf(gravity, a, b);
}

double potentialEnergy(const MutualGravity& gravity, const PointMass& a, const PointMass& b) {
    requireSound(gravity, a, b);
    const double strength = gravity.constant * (a.mass * b.mass);
    if (strength == 0) return 0;
    return -strength / softened(gravity, (b.position - a.position).squaredNorm());
}

double circularOrbitSpeed(const MutualGravity& gravity, double totalMass, double distance) {
    requireNumbers(gravity);
    requirePositive(totalMass, "circularOrbitSpeed: totalMass");
    requirePositive(distance, "circularOrbitSpeed: distance");
    const double r = softened(gravity, distance * distance);
    return distance / r * std::sqrt(gravity.constant * totalMass / r);
}

double orbitPeriod(const MutualGravity& gravity, double totalMass, double semiMajorAxis) {
    requireNumbers(gravity);
    requirePositive(totalMass, "orbitPeriod: totalMass");
    requirePositive(semiMajorAxis, "orbitPeriod: semiMajorAxis");
    return 2 * std::numbers::pi * semiMajorAxis * std::sqrt(semiMajorAxis / (gravity.constant * totalMass));
}

}  // namespace plumb
