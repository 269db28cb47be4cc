// SPDX-License-Identifier: MIT
// How does a game run in a window?
#pragma once
#include <iosfwd>

#include <games/frame/record.h>
#include <games/shell/options.h>

namespace plumb::games {

/// Runs until the window is closed, the player quits, the source has no more, or so many ticks have passed. source:
/// null for keyboard and gamepads. Returns what was pressed. Throws std::runtime_error when there is no display.
/// F1 shows what the kit sees, F2 how long ticks and frames take, F3 writes a picture, F4 is silence, F11 fills the
/// display.
Record runDesktop(const GameInfo& info, const SessionSetup& setup, Source* source, const ProgramOptions& options,
                  std::ostream& out);

}  // namespace plumb::games
