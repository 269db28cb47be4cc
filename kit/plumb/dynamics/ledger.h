// SPDX-License-Identifier: MIT
// Where is a world's energy, and where did it come from and go? And its momentum?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

/// What is there now, and all that came in (positive) or went out since the world was made:
/// kinetic + gravitational + spring + fields = edits + forces + drivers + motors + friction + impacts + damping +
/// breaking + solver, but for rounding. All in [J].
struct EnergyLedger {
    double kinetic = 0;
    double gravitational = 0;  ///< -m s g.x of each dynamic body, s its gravity scale; 0 at the world's origin
    double spring = 0;         ///< k x^2 / 2 of each joint's springs
    double fields = 0;  ///< of bodies in fields of the whole world that have a potential: all but drag and friction

    /// By calls between steps: what was added, removed, moved, pushed by impulses; gravity, joints, fields.
    double edits = 0;
    double forces = 0;    ///< by Body.applyForce and applyTorque, and by fields that act in a region only
    double drivers = 0;   ///< by kinematic bodies, and by belts
    double motors = 0;    ///< of joints
    double friction = 0;  ///< and rolling resistance, and that of the ground seen from above
    double impacts = 0;  ///< what normal forces took from what came together, a restitution below 1, and joints' limits
    double damping = 0;  ///< of bodies and of joints' springs; drag, and what wind and flow give
    double breaking = 0;  ///< what springs held that broke
    double solver =
        0;  ///< all that no law of the world accounts for: overlap pushed out, gaps closed, finite steps, sleep

    double stored() const { return kinetic + gravitational + spring + fields; }
    double gained() const {
        return edits + forces + drivers + motors + friction + impacts + damping + breaking + solver;
    }
};

/// The same for linear momentum: momentum = edits + gravity + fields + forces + ground + damping + solver, in [N s].
struct MomentumLedger {
    Vec2 momentum{0, 0};

    Vec2 edits{0, 0};
    Vec2 gravity{0, 0};
    Vec2 fields{0, 0};  ///< but for drag and friction
    Vec2 forces{0, 0};
    Vec2 ground{0, 0};   ///< by contacts and joints with what is static or kinematic; friction seen from above
    Vec2 damping{0, 0};  ///< and drag
    Vec2 solver{0, 0};   ///< rounding, sleep, and what was stopped short

    Vec2 gained() const { return edits + gravity + fields + forces + ground + damping + solver; }
};

struct Ledger {
    EnergyLedger energy;
    MomentumLedger momentum;
};

}  // namespace plumb
