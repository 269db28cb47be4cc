// SPDX-License-Identifier: MIT
// Which buttons control the hero?
#pragma once
#include <vector>

#include <games/frame/action.h>
#include <plumb/movers/platform_mover.h>

namespace plumb::games::runner {

/// Bits of Buttons, in the order of actions().
inline constexpr Buttons leftButton = 1, rightButton = 2, jumpButton = 4, runButton = 8, downButton = 16;

std::vector<Action> actions();

/// The same buttons as input of the kit's mover.
PlatformInput platformInput(Buttons buttons);

}  // namespace plumb::games::runner
