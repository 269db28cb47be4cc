// SPDX-License-Identifier: MIT
// What does the computer tell its crew?
#pragma once
#include <vector>

#include <games/artillery/battle.h>
#include <games/artillery/gunnery.h>

namespace plumb::games::artillery {

/// Plans one shot a turn: of all firing solutions for all enemies the one worth most that the forecast does not find
/// something in the way of. Looks at one enemy or one forecast a tick, as if it thought. Then it adds its hand's error,
/// and gives the orders that a person would have to give as well.
class Commander {
public:
    Commander(int crew, const Strength& strength, std::uint64_t seed);

    Orders decide(const Battle& battle);
    void forget() { turn_ = 0; }  ///< when another battle begins, whose turns are counted anew
    /// What it meant to fire, before the error of its hand; none before it has planned one.
    const std::optional<Aim>& meant() const { return meant_; }
    void addTo(Hash& hash) const;

private:
    struct Choice {
        FireSolution solution;
        Vec2 target;
        double worth = 0;
    };
    void listChoices(const Battle& battle, const Gunner& enemy);
    void tryNext(const Battle& battle);
    void think(const Battle& battle);
    void settleOn(const Aim& aim, int weapon);
    Orders steer(const Battle& battle);

    int crew_;
    Strength strength_;
    Random random_;
    int turn_ = 0;
    std::vector<Choice> choices_;  ///< the best last
    std::size_t listed_ = 0;       ///< of the gunners: whether enemies, and then how to hit them
    int tried_ = 0;
    double bestMiss_ = 0;
    std::optional<Aim> best_, meant_, wanted_;
    int weapon_ = 0, held_ = 0;
    Orders last_;
};

}  // namespace plumb::games::artillery
