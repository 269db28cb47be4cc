// SPDX-License-Identifier: MIT
// What was a game's program told when it was started?
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
    std::int64_t at = 0;  ///< after so many ticks
};

struct ProgramOptions {
    std::optional<std::uint64_t> seed{};  ///< none: another each time for a keyboard, else 1
    PlayedBy player = PlayedBy::Keyboard;
    std::string recordFile{}, replayFile{};  ///< empty: none
    bool headless = false;
    std::optional<std::int64_t> ticks{};  ///< stop after
    std::vector<Screenshot> screenshots{};
    PixelSize size{};
    bool debug = false;
    bool times = false;  ///< one line on them at the end
    std::map<std::string, std::string> gameOptions{};
    std::string help{};  ///< not empty: to be printed, and nothing else done
};

/// args without the program's name. Throws std::exception with one line on what was not wanted.
ProgramOptions parseOptions(std::span<const std::string> args, const GameInfo& info);

}  // namespace plumb::games
