// SPDX-License-Identifier: MIT
// When may the next hunter leave the house?
#pragma once
#include <array>
#include <optional>

#include <games/frame/hash.h>
#include <games/maze/level_rules.h>
#include <games/maze/targets.h>

namespace plumb::games::maze {

/// Who waits in the house, by Who. The first of them in the order of Who is the next to leave.
using Waiting = std::array<bool, 4>;

/// Every hunter counts the dots eaten while it is next. After a death one counter counts for all, until it has let the
/// last out. And if no dot is eaten for a while, the next one leaves anyway.
/// Source: The Pac-Man Dossier, chapter 2, "Home Sweet Home".
class HouseCounters {
public:
    void beginLevel() { *this = {}; }
    void beginLifeAfterDeath();

    void dotEaten(const Waiting& waiting);
    /// Once a frame: who leaves, if anyone.
    std::optional<Who> next(const Waiting& waiting, const LevelRules& rules);

    bool countsForAll() const { return forAll_; }
    int dotsOf(Who who) const { return dots_[indexOf(who)]; }
    int dotsForAll() const { return dotsForAll_; }
    void addTo(Hash& hash) const;

private:
    bool mayLeave(Who who, const LevelRules& rules) const;

    std::array<int, 4> dots_{};  ///< by Who
    int dotsForAll_ = 0;
    int framesWithoutDot_ = 0;
    bool forAll_ = false;
};

}  // namespace plumb::games::maze
