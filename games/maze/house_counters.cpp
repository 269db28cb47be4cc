// SPDX-License-Identifier: MIT
#include <games/maze/house_counters.h>

#include <algorithm>

namespace plumb::games::maze {
namespace {

std::optional<Who> firstOf(const Waiting& waiting) {
    const auto found = std::find(waiting.begin(), waiting.end(), true);
    if (found == waiting.end()) return std::nullopt;
    return everyone[static_cast<std::size_t>(found - waiting.begin())];
}

/// The tables do not contain the chaser, because it never waits.
template <typename Limits>
int limitOf(Who who, const Limits& limits) {
    return who == Who::Chaser ? 0 : limits[indexOf(who) - 1];
}

}  // namespace

void HouseCounters::beginLifeAfterDeath() {
    forAll_ = true;
    dotsForAll_ = 0;
    framesWithoutDot_ = 0;
}

void HouseCounters::dotEaten(const Waiting& waiting) {
    framesWithoutDot_ = 0;
    if (!forAll_) {
        if (const std::optional<Who> first = firstOf(waiting)) ++dots_[indexOf(*first)];
        return;
    }
    ++dotsForAll_;
    // When the limit of the loner is reached and it is at home, each hunter counts for itself again, also the loner.
    if (waiting[indexOf(Who::Loner)] && dotsForAll_ == limitOf(Who::Loner, ArcadeProfile{}.houseLimitsAfterDeath))
        forAll_ = false;
}

std::optional<Who> HouseCounters::next(const Waiting& waiting, const LevelRules& rules) {
    const std::optional<Who> first = firstOf(waiting);
    const bool waitedLong = ++framesWithoutDot_ >= rules.noDotFrames;
    if (waitedLong) framesWithoutDot_ = 0;
    if (!first || (!waitedLong && !mayLeave(*first, rules))) return std::nullopt;
    return first;
}

bool HouseCounters::mayLeave(Who who, const LevelRules& rules) const {
    if (!forAll_) return dotsOf(who) >= limitOf(who, rules.house.limits);
    return dotsForAll_ == limitOf(who, ArcadeProfile{}.houseLimitsAfterDeath);
}

void HouseCounters::addTo(Hash& hash) const {
    for (const int dots : dots_) hash.add(dots);
    hash.add(dotsForAll_).add(framesWithoutDot_).add(forAll_);
}

}  // namespace plumb::games::maze
