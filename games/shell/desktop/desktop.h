// SPDX-License-Identifier: MIT
// How does a game run in a window?
#pragma once
#include <iosfwd>

#include <games/frame/record.h>
#include <games/shell/options.h>

namespace plumb::games {

/// Runs until the window is closed, the player quits, the source ends, or options.ticks have passed. source: null for
/// keyboard and gamepads. Returns the record of the buttons. Throws std::runtime_error when there is no display.
/// F1 shows the debug view, F2 the times of ticks and frames; F3 writes a picture; F4 turns the sound off and on; F11
/// fills the display.
Record runDesktop(const GameInfo& info, const SessionSetup& setup, Source* source, const ProgramOptions& options,
                  std::ostream& out);

}  // namespace plumb::games
