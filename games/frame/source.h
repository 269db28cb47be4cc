// SPDX-License-Identifier: MIT
// Where do a session's buttons come from?
#pragma once
#include <memory>
#include <optional>

#include <games/frame/session.h>

namespace plumb::games {

/// A keyboard, a record, or the computer.
class Source {
public:
    virtual ~Source() = default;
    /// The buttons of the session's next tick; empty at the end of the source.
    virtual std::optional<Buttons> next(const Session& session) = 0;
};

/// The game's own computer player. It plays round after round and starts each round itself. Throws
/// std::invalid_argument when the game has no computer player.
std::unique_ptr<Source> computerSource(const GameInfo& info);

}  // namespace plumb::games
