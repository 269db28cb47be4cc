// SPDX-License-Identifier: MIT
// Where is a world's energy, and where did it come from and go? And its momentum?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

/// What is there now, and all that came in (positive) or went out since the world was made:
/// kinetic + gravitational + spring = edits + forces + drivers + motors + friction + impacts + damping + breaking +
/// solver but for rounding. All in [J].
struct EnergyLedger {
    double kinetic = 0;
    double gravitational = 0;  ///< -m s g.x of each dynamic body, s its gravity scale; 0 at the world's origin
    double spring = 0;         ///< k x^2 / 2 of each joint's springs

    double edits = 0;     ///< by calls between steps: bodies added, removed, moved, pushed by impulses, gravity, joints
    double forces = 0;    ///< by Body.applyForce and applyTorque
    double drivers = 0;   ///< by kinematic bodies, and by belts
    double motors = 0;    ///< of joints
    double friction = 0;  ///< and rolling resistance
    double impacts = 0;  ///< what normal forces took from what came together, a restitution below 1, and joints' limits
    double damping = 0;  ///< of bodies and of joints' springs
    double breaking = 0;  ///< what springs held that broke
    double solver =
        0;  ///< all that no law of the world accounts for: overlap pushed out, gaps closed, finite steps, sleep

    double stored() const { return kinetic + gravitational + spring; }
    double gained() const {
        return edits + forces + drivers + motors + friction + impacts + damping + breaking + solver;
    }
};

/// The same for linear momentum: momentum = edits + gravity + forces + ground + damping + solver, in [N s].
struct MomentumLedger {
    Vec2 momentum{0, 0};

    Vec2 edits{0, 0};
    Vec2 gravity{0, 0};
    Vec2 forces{0, 0};
    Vec2 ground{0, 0};  ///< by contacts and joints with what is static or kinematic
    Vec2 damping{0, 0};
    Vec2 solver{0, 0};  ///< rounding, sleep, and what was stopped short

    Vec2 gained() const { return edits + gravity + forces + ground + damping + solver; }
};

struct Ledger {
    EnergyLedger energy;
    MomentumLedger momentum;
};

}  // namespace plumb
