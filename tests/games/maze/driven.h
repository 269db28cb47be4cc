// SPDX-License-Identifier: MIT
// Which player plays the chase of a test?
#pragma once
#include <optional>

#include <games/maze/lookahead.h>

namespace plumb::test {

/// A chase with a player that looks a little ahead. A new life begins when it is caught. A cleared level begins again,
/// with the next seed.
class DrivenChase {
public:
    explicit DrivenChase(int level, std::uint64_t seed = 1,
                         const games::maze::LookaheadSettings& looks = {.frames = 80})
        : level_(level), seed_(seed), chase_(level, seed), lookahead_(looks) {}

    void step() {
        if (chase_.cleared()) chase_ = games::maze::Chase(level_, ++seed_);
        if (chase_.playerCaught()) chase_.beginLifeAfterDeath();
        if (++age_ > 8 || !(chase_.player().cell() == cell_)) {
            wanted_ = lookahead_.best(chase_);
            cell_ = chase_.player().cell();
            age_ = 0;
        }
        chase_.step(wanted_);
    }
    const games::maze::Chase& chase() const { return chase_; }

private:
    int level_;
    std::uint64_t seed_;
    games::maze::Chase chase_;
    games::maze::Lookahead lookahead_;
    Cell cell_{-1, -1};
    int age_ = 0;
    std::optional<Direction> wanted_;
};

}  // namespace plumb::test
