// SPDX-License-Identifier: MIT
// Which battles make up a game, and how are they scored?
#pragma once
#include <optional>
#include <string>

#include <games/artillery/battle.h>
#include <games/artillery/commander.h>
#include <games/frame/game.h>

namespace plumb::games::artillery {

/// Either one battle on each stage's island, each against a stronger rival; or a single battle, against a rival of a
/// given strength or a friend at the same keyboard.
class Match {
public:
    /// rival: "weak-to-strong", "weak", "fair", "strong" or "friend". Throws std::invalid_argument on any other value.
    Match(std::uint64_t seed, const std::string& rival);

    /// One tick; orders: given by a person with buttons. Returns what happened.
    std::vector<Happening> update(const Orders& orders);

    const Battle& battle() const { return battle_; }
    int stage() const { return stage_; }
    const std::string& rival() const { return rival_; }  ///< in this stage: the name of a strength, or "friend"
    bool isPersonsTurn() const { return !commander_ || battle_.crew() == 0; }
    Progress progress() const { return {outcome_, score_}; }
    int sinceOver() const { return sinceOver_; }  ///< since the battle ended [ticks]; the next one begins after a pause
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
    std::optional<Commander> commander_;  ///< plays the right crew; empty: a person plays it
    std::int64_t score_ = 0;
    int sinceOver_ = 0;
    Outcome outcome_ = Outcome::Running;
};

}  // namespace plumb::games::artillery
