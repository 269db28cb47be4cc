// SPDX-License-Identifier: MIT
// What is a world to be like?
#pragma once
#include <plumb/dynamics/solver_settings.h>
#include <plumb/math/vec2.h>
#include <plumb/space/wrap.h>

namespace plumb {

struct WorldDef {
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
    bool sleeping = true;    ///< may what rests be left out of the step?
    double hitSpeed = 1;     ///< what comes together faster is a ContactHit, >= 0, may be infinite [m/s]
    Wrap wrap = {};          ///< how wide and high the world is, if it goes on at its other side
    bool ledger = false;     ///< is account to be kept of energy and momentum? Steps then take several times as long
    SolverSettings solver = {};
};

}  // namespace plumb
