// SPDX-License-Identifier: MIT
// Which battles make a game, and what are they worth?
#pragma once
#include <optional>
#include <string>

#include <games/artillery/battle.h>
#include <games/artillery/commander.h>
#include <games/frame/game.h>

namespace plumb::games::artillery {

/// One battle after the other on the stages' islands, against stronger and stronger rivals; or a single one against a
/// rival of a given strength, or a friend at the same keyboard.
class Match {
public:
    /// rival: "ladder", "weak", "fair", "strong" or "friend"; throws std::invalid_argument on another.
    Match(std::uint64_t seed, const std::string& rival);

    /// One tick: of the orders somebody gives with buttons. Returns what happened.
    std::vector<Happening> update(const Orders& orders);

    const Battle& battle() const { return battle_; }
    int stage() const { return stage_; }
    const std::string& rival() const { return rival_; }  ///< of this stage: a strength, or "friend"
    bool isPersonsTurn() const { return !commander_ || battle_.crew() == 0; }
    Progress progress() const { return {outcome_, score_}; }
    int sinceOver() const { return sinceOver_; }  ///< of the battle [ticks]; the next comes when it was seen
    bool isLast() const { return !ladder_ || stage_ + 1 == static_cast<int>(stages.size()); }
    void addTo(Hash& hash) const;

private:
    Battle newBattle();
    void count(const Happening& happening);
    void goOn();

    bool ladder_;
    std::string rival_;
    Random seeds_;
    int stage_ = 0;
    Battle battle_;
    std::optional<Commander> commander_;  ///< of the right crew; none: somebody plays it
    std::int64_t score_ = 0;
    int sinceOver_ = 0;
    Outcome outcome_ = Outcome::Running;
};

}  // namespace plumb::games::artillery
