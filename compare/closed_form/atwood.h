// SPDX-License-Identifier: MIT
// How do two weights move that hang on one rope over a wheel?
#pragma once

namespace plumb::compare {

/// The rope and the wheel weigh nothing, and nothing rubs.
struct AtwoodMachine {
    double massA = 1, massB = 2;  ///< [kg]
    double gravity = 9.81;        ///< [m/s^2]
};

/// a = g (mB - mA) / (mA + mB), of B downward and of A upward [m/s^2].
/// Source: Atwood 1784; the rope pulls both alike. Exact while it is taut.
/// Test: "3 kg beside 2 kg fall at 1.962 m/s^2 and pull the rope with 23.544 N"
double accelerationOf(const AtwoodMachine& machine);

/// T = 2 g mA mB / (mA + mB) [N].
double tensionOf(const AtwoodMachine& machine);

}  // namespace plumb::compare
