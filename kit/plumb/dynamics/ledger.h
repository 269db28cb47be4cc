// SPDX-License-Identifier: MIT
// In which forms does a world hold its energy and momentum, and where did they come from and go?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb {

/// The world's present energy, and all energy that came in (positive) or went out since the world was made:
/// kinetic + gravitational + spring + fields = edits + forces + drivers + motors + friction + impacts + damping +
/// breaking + solver, except for rounding. All in [J].
struct EnergyLedger {
    double kinetic = 0;
    double gravitational = 0;  ///< -m s g.x of each dynamic body, s its gravity scale; 0 at the world's origin
    double spring = 0;         ///< k x^2 / 2 of each joint's springs
    double fields = 0;  ///< of bodies in fields without a region that have a potential: all except drag and friction

    /// By calls between steps: bodies added, removed, moved or pushed by impulses; changes of gravity, joints, fields.
    double edits = 0;
    double forces = 0;    ///< by Body.applyForce and applyTorque, and by fields that act in a region only
    double drivers = 0;   ///< by kinematic bodies, and by belts
    double motors = 0;    ///< of joints
    double friction = 0;  ///< with rolling resistance, and the ground's friction in a view from above
    double impacts = 0;   ///< lost in collisions with a restitution below 1, and at joints' limits
    double damping = 0;   ///< of bodies and of joints' springs; drag, and the energy that wind and flow give
    double breaking = 0;  ///< energy of springs that broke
    double solver =
        0;  ///< all changes without a physical cause: overlap pushed out, gaps closed, finite steps, falling asleep

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
    Vec2 fields{0, 0};  ///< except drag and friction
    Vec2 forces{0, 0};
    Vec2 ground{0, 0};   ///< by contacts and joints with static or kinematic bodies; the ground's friction
    Vec2 damping{0, 0};  ///< with drag
    Vec2 solver{0, 0};   ///< rounding and sleep

    Vec2 gained() const { return edits + gravity + fields + forces + ground + damping + solver; }
};

struct Ledger {
    EnergyLedger energy;
    MomentumLedger momentum;
};

}  // namespace plumb
