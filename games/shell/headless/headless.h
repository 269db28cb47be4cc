// SPDX-License-Identifier: MIT
// How does a game run without a window?
#pragma once
#include <functional>
#include <iosfwd>
#include <string>

#include <games/frame/record.h>
#include <games/shell/options.h>

namespace plumb::games {

/// Runs until the source has no more, the round is won or lost (but not of a record, which is played to its end), or
/// so many ticks have passed. Writes one line of JSON. Returns what was pressed.
Record runHeadless(const GameInfo& info, const SessionSetup& setup, Source& source, const ProgramOptions& options,
                   std::ostream& out);

}  // namespace plumb::games
