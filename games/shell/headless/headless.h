// SPDX-License-Identifier: MIT
// How does a game run without a window?
#pragma once
#include <functional>
#include <iosfwd>
#include <string>

#include <games/frame/record.h>
#include <games/shell/options.h>

namespace plumb::games {

/// Runs until the source ends, the round is won or lost, or options.ticks have passed. A record is played to its end,
/// whether its rounds are won or lost. Writes one line of JSON. Returns the record of the buttons.
Record runHeadless(const GameInfo& info, const SessionSetup& setup, Source& source, const ProgramOptions& options,
                   std::ostream& out);

}  // namespace plumb::games
