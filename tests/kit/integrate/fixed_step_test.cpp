// SPDX-License-Identifier: MIT
#include "kit/integrate/methods.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <limits>

#include "catch.h"

namespace {

using namespace plumb::test;
using namespace plumb;

struct Energies {
    double last, least, most;
};

/// Of x'' = -x from x = 1 at rest, where it is 1.
Energies energiesAfter(Method method, double z, int steps) {
    Phase<Number> phase{Number(1), Number(0)};
    Energies e{1, 1, 1};
    for (int i = 0; i < steps; ++i) {
        phase = stepOf<1>(method, oscillatorPull, i * z, phase, z);
        e.last = phase.position.squaredNorm() + phase.velocity.squaredNorm();
        e.least = std::min(e.least, e.last);
        e.most = std::max(e.most, e.last);
    }
    return e;
}

/// How far x'' = -x from x = 1 at rest is from the cosine after 10 s.
double errorAt10(Method method, int steps) {
    Phase<Number> phase{Number(1), Number(0)};
    for (int i = 0; i < steps; ++i) phase = stepOf<1>(method, oscillatorPull, 0, phase, 10.0 / steps);
    return std::hypot(phase.position[0] - std::cos(10.0), phase.velocity[0] + std::sin(10.0));
}

double slopeOf(Method method, int fewer, int more) {
    return std::log2(errorAt10(method, fewer) / errorAt10(method, more)) / std::log2(more / fewer);
}

/// The size of y' = -y after 2,000 steps of h, from 1.
template <typename Step>
double decayed(const Step& stepOnce, double h) {
    Number y(1);
    for (int i = 0; i < 2000; ++i) y = stepOnce([](double, const Number& state) -> Number { return -state; }, y, h);
    return std::fabs(y[0]);
}

}  // namespace

// Worked numbers of the integrators, table: energy after 1000 steps at z = 0.1; the digits given there.
TEST_CASE("the energy of an oscillator after 1,000 steps of z = 0.1", "[integrate][facts]") {
    CHECK(std::fabs(energiesAfter(Method::ExplicitEuler, 0.1, 1000).last - 20959.155638) < 5e-7);
    CHECK(std::fabs(energiesAfter(Method::Midpoint, 0.1, 1000).last - 1.0253148001) < 5e-11);
    CHECK(std::fabs(energiesAfter(Method::Heun, 0.1, 1000).last - 1.0253148001) < 5e-11);
    CHECK(std::fabs(energiesAfter(Method::RungeKutta4, 0.1, 1000).last - 0.9999861286) < 5e-11);
    const Energies semiImplicit = energiesAfter(Method::SemiImplicitEuler, 0.1, 1000);
    CHECK(std::fabs(semiImplicit.least - 0.95238) < 5e-6);
    CHECK(std::fabs(semiImplicit.most - 1.05263) < 5e-6);
    const Energies verlet = energiesAfter(Method::VelocityVerlet, 0.1, 1000);
    CHECK(std::fabs(verlet.least - 0.9975) < 5e-5);
    CHECK(verlet.most == 1.0);
    // and longer: no drift in a million steps
    CHECK(energiesAfter(Method::SemiImplicitEuler, 0.1, 1'000'000).most < 1 / (1 - 0.05) + 1e-9);
    CHECK(energiesAfter(Method::SemiImplicitEuler, 0.1, 1'000'000).least > 1 / (1 + 0.05) - 1e-9);
    CHECK(energiesAfter(Method::VelocityVerlet, 0.1, 1'000'000).least > 1 - 0.01 / 4 - 1e-9);
}

// The factors of the table to the power of 1,000 steps, at several z; RK4's and Dormand-Prince's to their next
// terms, which are below z^10 a step.
TEST_CASE("an oscillator's energy grows by 1 + z^2, 1 + z^4 / 4, 1 - z^6 / 72 + z^8 / 576 a step",
          "[integrate][facts]") {
    for (const double z : {0.001, 0.05, 0.1, 0.3}) {
        const auto after = [&](Method method) { return std::log(energiesAfter(method, z, 1000).last) / 1000; };
        CHECK(std::fabs(after(Method::ExplicitEuler) - std::log1p(z * z)) < 1e-14);
        CHECK(std::fabs(after(Method::Midpoint) - std::log1p(std::pow(z, 4) / 4)) < 1e-14);
        CHECK(std::fabs(after(Method::Heun) - std::log1p(std::pow(z, 4) / 4)) < 1e-14);
        CHECK(std::fabs(after(Method::RungeKutta4) - std::log1p(-std::pow(z, 6) / 72 + std::pow(z, 8) / 576)) < 1e-14);
        const double ofDormandPrince = std::log1p(-std::pow(z, 6) / 1800 + std::pow(z, 8) / 1600);
        CHECK(std::fabs(after(Method::DormandPrince) - ofDormandPrince) < 1e-14 + std::pow(z, 10) / 10'000);
    }
}

// Worked numbers of the integrators: fall 1 s, h = 0.1, and the table's free-fall errors -a h t / 2, +a h t / 2, 0.
TEST_CASE("1 s of free fall in steps of 0.1 s ends at -4.4145, -5.3955 and, five times, at -4.905 m",
          "[integrate][facts]") {
    const auto gravity = [](double, const Number&, const Number&) -> Number { return Number(-9.81); };
    for (const Method method : methods) {
        Phase<Number> phase{Number(0), Number(0)};
        for (int i = 0; i < 10; ++i) phase = stepOf<1>(method, gravity, 0.1 * i, phase, 0.1);
        const double end = method == Method::ExplicitEuler       ? -4.4145
                           : method == Method::SemiImplicitEuler ? -5.3955
                                                                 : -4.905;
        INFO(nameOf(method));
        CHECK(std::fabs(phase.position[0] - end) < 1e-14);
        CHECK(std::fabs(phase.velocity[0] + 9.81) < 1e-14);
    }
}

// Worked numbers of the integrators: measured global slopes at t = 10, N = 500 to 2000.
TEST_CASE("halving the step divides the error by 2 to the power of the order", "[integrate][facts]") {
    CHECK(std::fabs(slopeOf(Method::ExplicitEuler, 500, 1000) - 1.04) < 5e-3);
    CHECK(std::fabs(slopeOf(Method::ExplicitEuler, 1000, 2000) - 1.02) < 5e-3);
    CHECK(std::fabs(slopeOf(Method::SemiImplicitEuler, 500, 2000) - 1.01) < 5e-3);
    CHECK(std::fabs(slopeOf(Method::VelocityVerlet, 500, 2000) - 2.00) < 5e-3);
    CHECK(std::fabs(slopeOf(Method::Midpoint, 500, 2000) - 2.00) < 5e-3);
    CHECK(std::fabs(slopeOf(Method::Heun, 500, 2000) - 2.00) < 5e-3);
    CHECK(std::fabs(slopeOf(Method::RungeKutta4, 500, 2000) - 4.00) < 5e-3);
    CHECK(std::fabs(slopeOf(Method::DormandPrince, 125, 500) - 5.00) < 2e-2);
    for (const Method method : methods)
        std::cout << "integrate, " << nameOf(method)
                  << ": slope at t = 10, N = 250 to 500: " << slopeOf(method, 250, 500) << '\n';
}

// Just outside, the energy grows without bound; just inside, it never exceeds a bound: 1 / (1 - z / 2) of
// semi-implicit Euler, and of Verlet 1 / (1 - z^2 / 4). RK4 and Dormand-Prince lose.
TEST_CASE("an oscillator is stable just below the limits 2, 2, 2 sqrt(2) and 0.9972 and not just above",
          "[integrate][facts]") {
    CHECK(energiesAfter(Method::SemiImplicitEuler, 1.999, 100'000).most < 1 / (1 - 1.999 / 2) * (1 + 1e-6));
    CHECK(energiesAfter(Method::SemiImplicitEuler, 2.001, 10'000).last > 1e10);
    CHECK(energiesAfter(Method::VelocityVerlet, 1.999, 100'000).most < 1 / (1 - 1.999 * 1.999 / 4) * (1 + 1e-6));
    CHECK(energiesAfter(Method::VelocityVerlet, 2.001, 10'000).last > 1e10);
    CHECK(energiesAfter(Method::RungeKutta4, 2 * std::sqrt(2.0) - 0.001, 100'000).last < 1e-10);
    CHECK(energiesAfter(Method::RungeKutta4, 2 * std::sqrt(2.0) + 0.001, 100'000).last > 1e10);
    CHECK(energiesAfter(Method::DormandPrince, 0.9972 - 0.001, 100'000).last < 1);
    CHECK(energiesAfter(Method::DormandPrince, 0.9972 + 0.001, 100'000).last > 1);
    for (const double z : {1e-3, 0.01, 0.1}) {
        CHECK(energiesAfter(Method::ExplicitEuler, z, 1000).last > 1);
        CHECK(energiesAfter(Method::Midpoint, z, 10'000).last > 1);
        CHECK(energiesAfter(Method::Heun, z, 10'000).last > 1);
    }
}

// Worked numbers of the integrators: decay limits |h L|: Euler and RK2 2, RK4 2.785.
TEST_CASE("a decay is stable up to h L = 2, 2 and 2.785", "[integrate][facts]") {
    const auto euler = [](const auto& f, const Number& y, double h) { return explicitEulerStep(f, 0, y, h); };
    const auto midpoint = [](const auto& f, const Number& y, double h) { return midpointStep(f, 0, y, h); };
    const auto heun = [](const auto& f, const Number& y, double h) { return heunStep(f, 0, y, h); };
    const auto kutta = [](const auto& f, const Number& y, double h) { return rungeKutta4Step(f, 0, y, h); };
    CHECK(decayed(euler, 1.99) < 1e-6);
    CHECK(decayed(euler, 2.01) > 1e6);
    CHECK(decayed(midpoint, 1.99) < 1e-6);
    CHECK(decayed(midpoint, 2.01) > 1e6);
    CHECK(decayed(heun, 1.99) < 1e-6);
    CHECK(decayed(heun, 2.01) > 1e6);
    CHECK(decayed(kutta, 2.785) < 1);
    CHECK(decayed(kutta, 2.786) > 1);
}

// y' = t^2 + y^2, by hand, in halves and quarters that are exact.
TEST_CASE("Heun's step takes the mean of the slopes at both ends, the midpoint's the one between", "[integrate]") {
    const auto slope = [](double t, const Number& y) -> Number { return Number(t * t + y[0] * y[0]); };
    // k1 = 1 at (0, 1), k2 = 0.25 + 1.5^2 at (0.5, 1.5); in the middle 0.0625 + 1.25^2.
    CHECK(heunStep(slope, 0, Number(1), 0.5)[0] == 1 + 0.25 * (1 + 2.5));
    CHECK(midpointStep(slope, 0, Number(1), 0.5)[0] == 1 + 0.5 * 1.625);
    CHECK(heunStep(slope, 1, Number(2), -0.5)[0] == 2 - 0.25 * (5 + 0.5));
}

TEST_CASE("a state of dynamic size, and a matrix, give the bits of a vector of fixed size", "[integrate]") {
    const auto ofVector = [](double t, const Eigen::Vector2d& y) -> Eigen::Vector2d { return {y[1], t - y[0]}; };
    const auto ofDynamic = [](double t, const Eigen::VectorXd& y) -> Eigen::VectorXd {
        return Eigen::Vector2d(y[1], t - y[0]);
    };
    const auto ofMatrix = [](double t, const Eigen::RowVector2d& y) -> Eigen::RowVector2d { return {y[1], t - y[0]}; };
    Eigen::Vector2d fixed(1, 0.3);
    Eigen::VectorXd dynamic = fixed;
    Eigen::RowVector2d matrix = fixed.transpose();
    for (int i = 0; i < 50; ++i) {
        fixed = rungeKutta4Step(ofVector, 0.1 * i, midpointStep(ofVector, 0.1 * i, fixed, 0.1), 0.1);
        dynamic = rungeKutta4Step(ofDynamic, 0.1 * i, midpointStep(ofDynamic, 0.1 * i, dynamic, 0.1), 0.1);
        matrix = rungeKutta4Step(ofMatrix, 0.1 * i, midpointStep(ofMatrix, 0.1 * i, matrix, 0.1), 0.1);
    }
    CHECK(dynamic == fixed);
    CHECK(matrix.transpose() == fixed);
}

TEST_CASE("a step that is no number, and a derivative of another size, are refused by name", "[integrate]") {
    const Eigen::VectorXd state = Eigen::Vector2d(1, 0);
    const auto slope = [](double, const Eigen::VectorXd& y) -> Eigen::VectorXd { return y; };
    const auto longer = [](double, const Eigen::VectorXd&) -> Eigen::VectorXd { return Eigen::Vector3d(1, 2, 3); };
    CHECK_THROWS_WITH(explicitEulerStep(slope, 0, state, NAN), "step: nan is not finite");
    CHECK_THROWS_WITH(midpointStep(slope, INFINITY, state, 1), "time: inf is not finite");
    CHECK_THROWS_WITH(heunStep(slope, 0, state, INFINITY), "step: inf is not finite");
    CHECK_THROWS_WITH(heunStep(longer, 0, state, 1), "derivative: size 3 is not the state's, 2");
    CHECK_THROWS_WITH(rungeKutta4Step(longer, 0, state, 1), "derivative: size 3 is not the state's, 2");
    CHECK_THROWS_WITH(midpointStep(longer, 0, state, 1), "derivative: size 3 is not the state's, 2");
}
