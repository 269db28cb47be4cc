// SPDX-License-Identifier: MIT
// Which orders does the computer give its crew?
#pragma once
#include <vector>

#include <games/artillery/battle.h>
#include <games/artillery/gunnery.h>

namespace plumb::games::artillery {

/// Plans one shot per turn. Of all firing solutions for all enemies, it takes the most valuable one whose forecast
/// finds nothing in the way. It examines one enemy or one forecast per tick, as if it were thinking. Then it adds a
/// random error to the aim, and gives the same orders that a person would have to give.
class Commander {
public:
    Commander(int crew, const Strength& strength, std::uint64_t seed);

    Orders decide(const Battle& battle);
    void forget() { turn_ = 0; }  ///< call it when a new battle begins, which counts its turns from 1
    /// The planned aim, without the random error; empty until a shot is planned.
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
    std::vector<Choice> choices_;  ///< once sorted, the best one is last
    std::size_t listed_ = 0;       ///< number of gunners examined so far
    int tried_ = 0;
    double bestMiss_ = 0;
    std::optional<Aim> best_, meant_, wanted_;
    int weapon_ = 0, held_ = 0;
    Orders last_;
};

}  // namespace plumb::games::artillery
