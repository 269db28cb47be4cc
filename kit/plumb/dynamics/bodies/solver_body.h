// SPDX-License-Identifier: MIT
// What does the solver see of a body? Records of four floats, so that lanes can load them whole.
#pragma once
#include <cstdint>

namespace plumb {

/// What the solver reads and writes of a body's velocity: 16 bytes, mass included. Turning is scaled by the radius of
/// gyration's inverse, so that one inverse mass serves both:
///   rho^2 = (1/I) / (1/m), w = omega / rho, and an impulse P at r changes v by P/m and w by (rho r x P)/m.
struct SolverVelocity {
    float x = 0, y = 0;  ///< [m/s]
    float w = 0;         ///< omega / rho [m/s]
    float inverseMass = 0;
};

/// How far a body has come in this step; rotation as s/rho and (c - 1)/rho of the angle turned.
struct SolverDisplacement {
    float x = 0, y = 0;
    float sin = 0, cosMinus1 = 0;
};

/// The angle turned in this step, and what scales it.
struct SolverTurn {
    float angle = 0;  ///< [rad]
    float inverseGyration = 1, gyration = 1;
    float unused = 0;
};

/// What half a sub-step of gravity, forces and damping does to a velocity, field by field: v * keep + gain.
struct Kick {
    SolverVelocity gain{};
    SolverVelocity keep{1, 1, 1, 1};
};

/// The solver's records of all bodies, by slot; slot 0 stands for whatever nothing can move.
struct SolverBodies {
    SolverVelocity* velocity = nullptr;
    SolverVelocity* warm = nullptr;    ///< what the contacts' impulses, all together, do to the velocity
    SolverVelocity* before = nullptr;  ///< the velocity before the contacts were solved
    SolverDisplacement* displacement = nullptr;
    SolverTurn* turn = nullptr;
    const Kick* kick = nullptr;
};

/// One cache line: four rows of four floats. A place is the sum of two floats, high and low, so that the difference of
/// two is as exact as a float can be anywhere in the world.
struct alignas(64) BodyPlace {
    float highX = 0, highY = 0, lowX = 0, lowY = 0;  ///< centre of mass [m]
    float cos = 1, sin = 0;                          ///< of its angle
    float inverseGyration = 1;                       ///< inverse radius of gyration [1/m]
    float unused = 0;
    float shiftX = 0, shiftY = 0;  ///< of the centre in this step, if nothing is in the way [m]
    float turn = 0;                ///< how far turning takes its outline at most [m]
    float unused2 = 0;
    float pullX = 0, pullY = 0;  ///< speed that its acceleration gives it in half of this step [m/s]
    float unused3 = 0, unused4 = 0;
};

}  // namespace plumb
