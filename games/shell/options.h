// SPDX-License-Identifier: MIT
// Which options does the command line of a game's program set?
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <games/frame/game.h>

namespace plumb::games {

enum class PlayedBy { Nobody, Keyboard, Computer, Record };

struct Screenshot {
    std::string file;
    std::int64_t at = 0;  ///< after this number of ticks
};

struct ProgramOptions {
    std::optional<std::uint64_t> seed{};  ///< empty: a random one for a keyboard, otherwise 1
    PlayedBy player = PlayedBy::Keyboard;
    std::string recordFile{}, replayFile{};  ///< empty: no file
    bool headless = false;
    std::optional<std::int64_t> ticks{};  ///< stop after this number
    std::vector<Screenshot> screenshots{};
    PixelSize size{};
    bool debug = false;
    bool times = false;  ///< print one line with the times at the end
    std::map<std::string, std::string> gameOptions{};
    std::string help{};  ///< not empty: print it and do nothing else
};

/// args: without the program's name. Throws std::exception with one line that says what is wrong.
ProgramOptions parseOptions(std::span<const std::string> args, const GameInfo& info);

}  // namespace plumb::games
