// SPDX-License-Identifier: MIT
#include <games/maze/computer.h>

#include <algorithm>

#include <games/maze/lanes.h>
#include <games/maze/lookahead.h>
#include <games/maze/maze_game.h>

namespace plumb::games::maze {
namespace {

constexpr int patience = 10;  ///< longest time between two looks ahead [frames]
constexpr int safe = 12;      ///< farther than this from all hunters, it looks ahead at crossings only [tiles]

bool isSafe(const Chase& chase) {
    return std::none_of(chase.hunters().begin(), chase.hunters().end(), [&](const Hunter& hunter) {
        return hunter.canMeet() && lanes().distance(hunter.cell(), chase.player().cell()) <= safe;
    });
}

/// The way on, if there is only one.
std::optional<Direction> onlyWay(const GridMover& player) {
    const std::vector<Direction>& exits = lanes().exits(player.cell());
    if (exits.size() != 2) return std::nullopt;
    return exits[0] == opposite(player.heading()) ? exits[1] : exits[0];
}

/// Looks ahead each time it enters another cell, and holds the chosen key until the next time.
class Computer final : public Player {
public:
    Buttons decide(const Game& game) override {
        const auto& maze = dynamic_cast<const MazeGame&>(game);
        if (maze.phase() != Phase::Play) return 0;
        const Chase& chase = maze.chase();
        if (chase.frozen()) return buttons();
        if (++age_ >= patience || !(cell_ == chase.player().cell())) {
            const std::optional<Direction> way = isSafe(chase) ? onlyWay(chase.player()) : std::nullopt;
            choice_ = way ? way : lookahead_.best(chase);
            cell_ = chase.player().cell();
            age_ = 0;
        }
        return buttons();
    }

private:
    /// The game's actions are the four directions, in the kit's order.
    Buttons buttons() const { return choice_ ? Buttons{1} << static_cast<int>(*choice_) : 0; }

    Lookahead lookahead_;
    Cell cell_{-1, -1};
    int age_ = 0;
    std::optional<Direction> choice_;
};

}  // namespace

std::unique_ptr<Player> computerPlayer() {
    return std::make_unique<Computer>();
}

}  // namespace plumb::games::maze
