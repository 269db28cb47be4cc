// SPDX-License-Identifier: MIT
#include <games/runner/computer.h>

#include <deque>
#include <optional>

#include <games/runner/runner.h>
#include <games/runner/way_search.h>

namespace plumb::games::runner {
namespace {

/// Presses the buttons from findWay(), and searches again after the last of them.
class Computer final : public Player {
public:
    Buttons decide(const Game& game) override {
        const auto& runner = dynamic_cast<const Runner&>(game);
        if (!runner.isPlaying()) {
            way_.clear();
            return last_ = 0;
        }
        const Stage& stage = runner.stage();
        if (level_ != &stage.level()) {
            level_ = &stage.level();
            field_.emplace(*level_);
        }
        if (way_.empty() || stage.ticks() != expected_) {
            const std::vector<Buttons> found = findWay(stage, last_, *field_);
            way_.assign(found.begin(), found.end());
        }
        expected_ = stage.ticks() + 1;
        last_ = way_.front();
        way_.pop_front();
        return last_;
    }

private:
    const Level* level_ = nullptr;
    std::optional<WayField> field_;
    std::deque<Buttons> way_;
    std::int64_t expected_ = 0;
    Buttons last_ = 0;
};

}  // namespace

std::unique_ptr<Player> computer(const GameSetup&) {
    return std::make_unique<Computer>();
}

}  // namespace plumb::games::runner
