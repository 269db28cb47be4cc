// SPDX-License-Identifier: MIT
// When may the next hunter leave the house?
#pragma once
#include <array>
#include <optional>

#include <games/frame/hash.h>
#include <games/maze/level_rules.h>
#include <games/maze/targets.h>

namespace plumb::games::maze {

/// Which hunters wait in the house, indexed by Who. The first of them in the order of Who is the next to leave.
using Waiting = std::array<bool, 4>;

/// Each hunter counts the dots eaten while it is the next to leave. After a death one shared counter counts for all. It
/// stops when it reaches the limit of the loner while the loner is at home. If no dot is eaten for noDotFrames, the
/// next hunter leaves anyway.
/// Source: The Pac-Man Dossier, chapter 2, "Home Sweet Home".
class HouseCounters {
public:
    void beginLevel() { *this = {}; }
    void beginLifeAfterDeath();

    void dotEaten(const Waiting& waiting);
    /// Call it once a frame. Returns the hunter that leaves, if any.
    std::optional<Who> next(const Waiting& waiting, const LevelRules& rules);

    bool countsForAll() const { return forAll_; }
    int dotsOf(Who who) const { return dots_[indexOf(who)]; }
    int dotsForAll() const { return dotsForAll_; }
    void addTo(Hash& hash) const;

private:
    bool mayLeave(Who who, const LevelRules& rules) const;

    std::array<int, 4> dots_{};  ///< indexed by Who
    int dotsForAll_ = 0;
    int framesWithoutDot_ = 0;
    bool forAll_ = false;
};

}  // namespace plumb::games::maze
