// SPDX-License-Identifier: MIT
// Which data of a body does the solver use? Records of four floats, so that one vector operation loads a whole record.
//
// A body's velocity has two companions, because contacts are warm-started: each half sub-step adds to it the changes
// that contacts have made so far. Their change in the last half is velocity - before; kickBodies adds it to warm. So
// whoever changes velocity, and is not a contact, changes before, too: else the change counts as a contact's, and is
// applied again in the next half. addVelocity and setVelocity do both (solver_velocity.h); swept joints are followed by
// markBodies, and when a swept island moves, the difference of the two is kept (swept_pieces.h). warm is written by
// kickBodies, by gatherWarmStart at the step's start, and by joints when they read what contacts have changed;
// setSolverMass scales all three.
#pragma once
#include <cstdint>
#include <limits>

#include <plumb/math/detail/wide.h>

namespace plumb {

/// A body's velocity in the solver: 16 bytes, with the inverse mass. The angular velocity is divided by rho, the
/// inverse of the radius of gyration k, so that one inverse mass serves translation and rotation:
///   rho^2 = 1/k^2 = (1/I) / (1/m), w = omega / rho, and an impulse P at r changes v by P/m and w by (rho r x P)/m.
/// rho inverse radius of gyration [1/m], I moment of inertia [kg m^2], m mass [kg], omega angular velocity [rad/s], r
/// from the centre of mass [m], P impulse [N s]
struct SolverVelocity {
    float x = 0, y = 0;  ///< [m/s]
    float w = 0;         ///< omega / rho [m/s]
    float inverseMass = 0;
};

/// A body's displacement in this step [m]. Of the angle turned, sin is the sine divided by rho, and cosMinus1 is the
/// cosine minus 1, divided by rho.
struct SolverDisplacement {
    float x = 0, y = 0;
    float sin = 0, cosMinus1 = 0;
};

/// The angle turned in this step, the radius of gyration that scales it, and what is fast for the body.
struct SolverTurn {
    float angle = 0;                          ///< [rad]
    float inverseGyration = 1, gyration = 1;  ///< rho [1/m] and 1/rho [m]
    /// A body may move far for its size in a sub-step if x^2 + y^2 + w^2 of its velocity is more than this [m^2/s^2].
    float farSpeedSquared = std::numeric_limits<float>::infinity();
};

/// The effect of gravity, forces and damping on a velocity in half a sub-step, for each component: v * keep + gain.
struct Kick {
    SolverVelocity gain{};
    SolverVelocity keep{1, 1, 1, 1};
};

/// The solver's records of all bodies, by slot. Slot 0 stands for everything that cannot be moved.
struct SolverBodies {
    SolverVelocity* velocity = nullptr;
    SolverVelocity* warm = nullptr;    ///< velocity change by all warm-start impulses of the body's contacts
    SolverVelocity* before = nullptr;  ///< the velocity without what contacts have changed since
    SolverDisplacement* displacement = nullptr;
    SolverTurn* turn = nullptr;
    const Kick* kick = nullptr;
};

}  // namespace plumb
