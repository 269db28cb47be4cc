// SPDX-License-Identifier: MIT
// How is what was pressed kept, so that it can be played again?
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <games/frame/source.h>

namespace plumb::games {

/// The same buttons for so many ticks.
struct Run {
    std::int64_t ticks = 1;
    Buttons buttons = 0;
    friend bool operator==(const Run&, const Run&) = default;
};

/// All buttons from a program's start to its end. As text, which a person can write too:
///   plumb-record 1 maze
///   seed 7
///   option strength strong
///   30 -
///   1 confirm
///   45 left+fire
///   end 1f00c0ffee00d00d
/// A line has a number of ticks, and the actions of these ticks, or - for none. # begins a comment, but not in the line
/// of an option. The line end has the hash of the session; it may be left out.
struct Record {
    std::string game;
    std::uint64_t seed = 1;
    std::map<std::string, std::string> options{};
    std::vector<Run> runs{};
    std::optional<std::uint64_t> hash{};

    void add(Buttons buttons);  ///< one tick more
    std::int64_t ticks() const;
};

std::string textOf(const Record& record, const ActionList& actions);

/// name: of the file, for messages. Throws std::invalid_argument with "<name>:<line>: <what it holds> <what was
/// wanted>", also for a record of another game.
Record readRecord(std::string_view text, const std::string& name, const GameInfo& info);

std::unique_ptr<Source> recordSource(Record record);

}  // namespace plumb::games
