// SPDX-License-Identifier: MIT
#include "kit/integrate/kepler.h"

#include <plumb/integrate/integrate.h>

#include <algorithm>
#include <iostream>

#include "catch.h"
#include "kit/integrate/methods.h"

namespace {

using namespace plumb::test;
using namespace plumb;

struct Orbits {
    double energyError = 0, momentumError = 0;  ///< worst, relative
    double wholeOrbitError = 0;                 ///< worst distance from perihelion after whole orbits
};

Orbits tenOrbits(Method method, int stepsPerOrbit) {
    Phase<Vec2> phase = perihelion();
    const double momentum = cross(phase.position, phase.velocity), h = 2 * std::numbers::pi / stepsPerOrbit;
    Orbits worst;
    for (int i = 1; i <= 10 * stepsPerOrbit; ++i) {
        phase = stepOf(method, sunsPull, 0, phase, h);
        worst.energyError = std::max(worst.energyError, std::fabs(energyOf(phase) / -0.5 - 1));
        const double now = cross(phase.position, phase.velocity);
        worst.momentumError = std::max(worst.momentumError, std::fabs(now / momentum - 1));
        if (i % stepsPerOrbit == 0)
            worst.wholeOrbitError = std::max(worst.wholeOrbitError, (phase.position - Vec2(0.5, 0)).norm());
    }
    return worst;
}

/// Worst distance from Kepler's equation in one orbit.
double orbitError(Method method, int steps) {
    Phase<Vec2> phase = perihelion();
    double worst = 0;
    for (int i = 1; i <= steps; ++i) {
        phase = stepOf(method, sunsPull, 0, phase, 2 * std::numbers::pi / steps);
        worst = std::max(worst, (phase.position - planetAt(i * 2 * std::numbers::pi / steps).position).norm());
    }
    return worst;
}

Eigen::Vector4d planetSlope(double, const Eigen::Vector4d& y) {
    const Vec2 pull = sunsPull(0, y.head<2>(), {});
    return {y[2], y[3], pull.x(), pull.y()};
}

}  // namespace

// Worked numbers of the integrators: Kepler e = 0.5, 1000 steps/orbit, 10 orbits, worst dE/E, to the digits given.
TEST_CASE("ten Kepler orbits of 1,000 steps: energy off by 0.58, 9.1e-3, 1.07e-4, 1.27e-4 and 4.6e-9",
          "[integrate][facts]") {
    CHECK(std::fabs(tenOrbits(Method::ExplicitEuler, 1000).energyError - 0.58) < 5e-3);
    CHECK(std::fabs(tenOrbits(Method::SemiImplicitEuler, 1000).energyError - 9.1e-3) < 5e-5);
    CHECK(std::fabs(tenOrbits(Method::VelocityVerlet, 1000).energyError - 1.07e-4) < 5e-7);
    CHECK(std::fabs(tenOrbits(Method::Midpoint, 1000).energyError - 1.27e-4) < 5e-7);
    CHECK(std::fabs(tenOrbits(Method::RungeKutta4, 1000).energyError - 4.6e-9) < 5e-11);
    CHECK(tenOrbits(Method::DormandPrince, 1000).energyError < 1e-10);
}

// The integrators' worked numbers have 4e-15 for the symplectic pair. It is all rounding, so it depends on the order
// of operations: here it is 3e-15 for semi-implicit Euler and 1.4e-14 for Verlet, printed below; a walk of 40,000
// roundings of 1e-16 is 2e-14.
TEST_CASE("only the symplectic pair keeps angular momentum over ten Kepler orbits", "[integrate][facts]") {
    for (const Method method : methods) {
        const double error = tenOrbits(method, 1000).momentumError;
        std::cout << "integrate, " << nameOf(method) << ": angular momentum off by " << error << '\n';
        const bool symplectic = method == Method::SemiImplicitEuler || method == Method::VelocityVerlet;
        if (symplectic) CHECK(error < 2e-14);
        if (method == Method::SemiImplicitEuler) CHECK(error < 4e-15);
        if (!symplectic) CHECK(error > 1e-12);
    }
}

// Worked numbers of the integrators: "Trap: sampled at whole orbits semi-implicit shows slope 2", for its error of
// first order swings and is nothing there.
TEST_CASE("seen all along the orbit semi-implicit Euler is of order 1, seen at whole orbits it seems of order 2",
          "[integrate][facts]") {
    const auto slope = [](double fewer, double more) { return std::log2(fewer / more); };
    const Orbits one = tenOrbits(Method::SemiImplicitEuler, 2000), two = tenOrbits(Method::SemiImplicitEuler, 4000);
    CHECK(std::fabs(slope(one.energyError, two.energyError) - 1) < 0.02);
    CHECK(std::fabs(slope(one.wholeOrbitError, two.wholeOrbitError) - 2) < 0.02);
    CHECK(std::fabs(slope(orbitError(Method::SemiImplicitEuler, 4000), orbitError(Method::SemiImplicitEuler, 8000)) -
                    1) < 0.02);
    CHECK(std::fabs(slope(orbitError(Method::VelocityVerlet, 4000), orbitError(Method::VelocityVerlet, 8000)) - 2) <
          0.02);
    CHECK(std::fabs(slope(orbitError(Method::Midpoint, 4000), orbitError(Method::Midpoint, 8000)) - 2) < 0.02);
    CHECK(std::fabs(slope(orbitError(Method::Heun, 4000), orbitError(Method::Heun, 8000)) - 2) < 0.02);
    CHECK(std::fabs(slope(orbitError(Method::RungeKutta4, 2000), orbitError(Method::RungeKutta4, 4000)) - 4) < 0.05);
}

// A step's error changes the energy by about as much, and the period by 3/2 of it: over 10.3 orbits the planet is
// then off by 3 pi 10.3 of that, times its speed. The tolerances are per component; 100 covers both.
TEST_CASE("after 10.3 Kepler orbits Dormand-Prince is where Kepler's equation says, to 100 tolerances a step",
          "[integrate]") {
    const double time = 10.3 * 2 * std::numbers::pi;
    const Phase<Vec2> truth = planetAt(time);
    for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) {
        const auto [position, velocity] = perihelion();
        const Eigen::Vector4d start(position.x(), position.y(), velocity.x(), velocity.y());
        const Integration<Eigen::Vector4d> found =
            integrate(planetSlope, 0, start, time, {.absoluteTolerance = tolerance, .relativeTolerance = tolerance});
        const double error = (found.state.head<2>() - truth.position).norm();
        const double energy = energyOf({found.state.head<2>(), found.state.tail<2>()}) / -0.5 - 1;
        std::cout << "integrate, Kepler at tolerance " << tolerance << ": off by " << error << " in " << found.accepted
                  << " steps, energy by " << energy << '\n';
        CHECK(found.end == IntegrationEnd::Reached);
        CHECK(error < 100 * tolerance * found.accepted);
        CHECK(std::fabs(energy) < tolerance * found.accepted);
    }
}
