// SPDX-License-Identifier: MIT
// What do all bodies, contacts or events of a world look like as one list of numbers?
#pragma once
#include <vector>

#include <plumb/dynamics/world.h>

namespace plumb::web {

enum class Rows {
    Poses,       ///< x, y, angle at 3 times the index of a body; NaN where none is
    Velocities,  ///< vx, vy, angular velocity, likewise
    Contacts,    ///< a row a point, see contactColumns in runtime.js
    Events,      ///< a row an event, see eventColumns in runtime.js
};

void allRows(const World& world, Rows rows, std::vector<double>& out);

}  // namespace plumb::web
