// SPDX-License-Identifier: MIT
// What is shown behind the title?
#pragma once
#include <memory>
#include <optional>

#include <games/frame/game.h>

namespace plumb::games {

/// Rounds of the game, played by its computer player; or what the game draws there instead (GameInfo.drawTitle).
class TitleShow {
public:
    /// info must outlive it.
    explicit TitleShow(const GameInfo& info) : info_(&info) {}

    void update();  ///< one tick
    void draw(Canvas& canvas) const;

private:
    void begin();

    const GameInfo* info_;
    std::optional<ActionList> actions_;
    std::unique_ptr<Game> game_;
    std::unique_ptr<Player> player_;
    Buttons before_ = 0;
    std::int64_t ticks_ = 0;
    std::uint64_t seed_ = 0;
};

}  // namespace plumb::games
