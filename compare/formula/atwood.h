// SPDX-License-Identifier: MIT
// How do two weights on one rope over a wheel move?
#pragma once

namespace plumb::compare {

/// The rope and the wheel have no mass, and there is no friction.
struct AtwoodMachine {
    double massA = 1, massB = 2;  ///< [kg]
    double gravity = 9.81;        ///< [m/s^2]
    double ratio = 1;             ///< r, of a block and tackle: A rises by r times the descent of B [-]
};

/// a = g (mB - r mA) / (r^2 mA + mB), of B downward; A goes upward at r a [m/s^2].
/// Source: Atwood 1784; the rope pulls both equally. Exact while it is taut.
/// Test: "3 kg beside 2 kg fall at 1.962 m/s^2 and pull the rope with 23.544 N"
inline double accelerationOf(const AtwoodMachine& machine) {
    const double r = machine.ratio;
    return machine.gravity * (machine.massB - r * machine.massA) / (r * r * machine.massA + machine.massB);
}

/// T = (1 + r) g mA mB / (r^2 mA + mB) in A's part of the rope; B's part pulls with r T [N].
inline double tensionOf(const AtwoodMachine& machine) {
    const double r = machine.ratio;
    return (1 + r) * machine.gravity * machine.massA * machine.massB / (r * r * machine.massA + machine.massB);
}

}  // namespace plumb::compare
