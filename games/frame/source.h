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
    /// Of the session's next tick; none: there are no more.
    virtual std::optional<Buttons> next(const Session& session) = 0;
};

/// The game's own computer player, round after round; it starts each by itself. Throws std::invalid_argument when the
/// game has none.
std::unique_ptr<Source> computerSource(const GameInfo& info);

}  // namespace plumb::games
