// SPDX-License-Identifier: MIT
// Which properties does a world have from the start?
#pragma once
#include <plumb/dynamics/solver_settings.h>
#include <plumb/math/vec2.h>
#include <plumb/space/wrap.h>

namespace plumb {

struct WorldDef {
    Vec2 gravity{0, -9.81};  ///< [m/s^2]
    bool sleeping = true;    ///< may bodies at rest fall asleep, so that steps skip them?
    double hitSpeed = 1;     ///< a faster approach is a ContactHit, >= 0, may be infinite [m/s]
    Wrap wrap = {};          ///< width and height of the world, if it wraps around
    bool ledger = false;     ///< keep account of energy and momentum? Steps then take several times as long
    SolverSettings solver = {};
};

}  // namespace plumb
