// SPDX-License-Identifier: MIT
#include <plumb/forces/spring.h>

#include <plumb/math/check.h>

namespace plumb {
namespace {

void requireSound(const SpringDamper& spring) {
    requireNotNegative(spring.stiffness, "SpringDamper", ".stiffness");
    requireNotNegative(spring.damping, "SpringDamper", ".damping");
    requireNotNegative(spring.restLength, "SpringDamper", ".restLength");
}

}  // namespace

Vec2 springForce(const SpringDamper& spring, const SpringEnd& a, const SpringEnd& b) {
    requireSound(spring);
    const Vec2 d = b.position - a.position;
    const double length = d.norm();
    if (length == 0) return {0, 0};
    const Vec2 n = d / length;
    const double rate = (b.velocity - a.velocity).dot(n);
    return -(spring.stiffness * (length - spring.restLength) + spring.damping * rate) * n;
}

double potentialEnergy(const SpringDamper& spring, const Vec2& a, const Vec2& b) {
    requireSound(spring);
    const double stretch = (b - a).norm() - spring.restLength;
    return 0.5 * spring.stiffness * stretch * stretch;
}

double dampingPower(const SpringDamper& spring, const SpringEnd& a, const SpringEnd& b) {
    requireSound(spring);
    const Vec2 d = b.position - a.position;
    const double length = d.norm();
    if (length == 0) return 0;
    const double rate = (b.velocity - a.velocity).dot(d / length);
    return spring.damping * rate * rate;
}

}  // namespace plumb
