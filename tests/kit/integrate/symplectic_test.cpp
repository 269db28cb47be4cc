// SPDX-License-Identifier: MIT
#include <plumb/integrate/symplectic.h>

#include <plumb/kinematics/oscillation.h>

#include <cmath>

#include "catch.h"
#include "kit/integrate/methods.h"

namespace {

using namespace plumb::test;
using namespace plumb;

/// The largest size in 10,000 steps of a spring of k / m [1/s^2] from 1 m at rest.
double springReach(double stiffnessOverMass, double step) {
    const auto pull = [&](double, const Number& x, const Number&) -> Number { return -stiffnessOverMass * x; };
    Phase<Number> phase{Number(1), Number(0)};
    double reach = 0;
    for (int i = 0; i < 10'000; ++i) {
        phase = semiImplicitEulerStep(pull, 0, phase, step);
        reach = std::max(reach, std::fabs(phase.position[0]));
    }
    return reach;
}

/// How far x'' = -2 z x' - x is from its closed form after 5 s.
double dampedError(Method method, double z, int steps) {
    const auto pull = [&](double, const Number& x, const Number& v) -> Number { return -x - 2 * z * v; };
    Phase<Number> phase{Number(1), Number(0)};
    for (int i = 0; i < steps; ++i) phase = stepOf<1>(method, pull, 0, phase, 5.0 / steps);
    const AxisMotion truth = oscillate(AxisMotion{1, 0}, 0, {1, z}, 5);
    return std::hypot(phase.position[0] - truth.position, phase.velocity[0] - truth.velocity);
}

}  // namespace

// Worked numbers of the integrators, invariants. 100,000 steps round by some 1e-16 each.
TEST_CASE("semi-implicit Euler and velocity Verlet keep their shadow of the energy", "[integrate][facts]") {
    const double w2 = 4;
    const auto pull = [&](double, const Number& x, const Number&) -> Number { return -w2 * x; };
    for (const double h : {0.01, 0.1, 0.5, 0.9}) {
        Phase<Number> euler{Number(1), Number(0.3)}, verlet = euler;
        const auto ofEuler = [&] {
            const double x = euler.position[0], v = euler.velocity[0];
            return v * v + w2 * x * x - h * w2 * x * v;
        };
        const auto ofVerlet = [&] {
            const double x = verlet.position[0], v = verlet.velocity[0];
            return v * v + w2 * x * x * (1 - h * h * w2 / 4);
        };
        const double eulerStart = ofEuler(), verletStart = ofVerlet();
        for (int i = 0; i < 100'000; ++i) {
            euler = semiImplicitEulerStep(pull, 0, euler, h);
            verlet = velocityVerletStep(pull, 0, verlet, h);
        }
        CHECK(std::fabs(ofEuler() / eulerStart - 1) < 1e-11);
        CHECK(std::fabs(ofVerlet() / verletStart - 1) < 1e-11);
    }
}

// Worked numbers of the integrators: z = h w < 2.
TEST_CASE("semi-implicit springs hold below k / m = 14400 at 60 Hz and below 10000 at 0.02 s", "[integrate][facts]") {
    CHECK(springReach(14'390, 1.0 / 60) < 100);
    CHECK(springReach(14'410, 1.0 / 60) > 1e10);
    CHECK(springReach(9'990, 0.02) < 100);
    CHECK(springReach(10'010, 0.02) > 1e10);
}

// Order 1 and 2 from the errors of two steps, so within the next term of each, h.
TEST_CASE("the orders stay 1 and 2 where the acceleration depends on the velocity", "[integrate]") {
    for (const double z : {0.1, 0.7, 1.0}) {
        const auto slope = [&](Method method) {
            return std::log2(dampedError(method, z, 1000) / dampedError(method, z, 2000));
        };
        CHECK(std::fabs(slope(Method::SemiImplicitEuler) - 1) < 0.02);
        CHECK(std::fabs(slope(Method::VelocityVerlet) - 2) < 0.02);
    }
}

TEST_CASE("semi-implicit Euler and Verlet refuse by name a velocity or an acceleration of another size",
          "[integrate]") {
    const Phase<Eigen::VectorXd> phase{Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)};
    const Phase<Eigen::VectorXd> odd{Eigen::Vector2d(1, 0), Eigen::Vector3d(0, 1, 2)};
    const auto pull = [](double, const Eigen::VectorXd& x, const Eigen::VectorXd&) -> Eigen::VectorXd { return -x; };
    const auto longer = [](double, const Eigen::VectorXd&, const Eigen::VectorXd&) -> Eigen::VectorXd {
        return Eigen::Vector3d(1, 2, 3);
    };
    CHECK_THROWS_WITH(semiImplicitEulerStep(longer, 0, phase, 1), "acceleration: size 3 is not the position's, 2");
    CHECK_THROWS_WITH(velocityVerletStep(longer, 0, phase, 1), "acceleration: size 3 is not the position's, 2");
    CHECK_THROWS_WITH(velocityVerletStep(pull, 0, odd, 1), "velocity: size 3 is not the position's, 2");
    CHECK_THROWS_WITH(velocityVerletStep(pull, 0, phase, INFINITY), "step: inf is not finite");
}
