// SPDX-License-Identifier: MIT
#include <games/maze/steering.h>

#include <games/maze/maze_game.h>

#include "catch.h"

namespace {

using namespace plumb;
using namespace plumb::games;
using namespace plumb::games::maze;

/// Holds keys for one tick at a time, and returns the direction that results.
struct Hand {
    std::optional<Direction> hold(std::vector<Direction> keys) {
        Buttons now = 0;
        for (const Direction key : keys) now |= Buttons{1} << static_cast<int>(key);
        const Input input(actions, now, before);
        before = now;
        return steering.update(input);
    }

    ActionList actions = withMenuActions(info().actions);
    Steering steering;
    Buttons before = 0;
};

}  // namespace

TEST_CASE("each direction has an action with its name, and both have the same index", "[games][maze]") {
    for (const Direction direction : allDirections) {
        Hand hand;
        CHECK(hand.hold({direction}) == direction);
        CHECK(hand.actions.indexOf(actionOf(direction)) == static_cast<int>(direction));
    }
}

TEST_CASE("of two held keys the later one counts, when it is released, the earlier one counts again", "[games][maze]") {
    Hand hand;
    CHECK(hand.hold({}) == std::nullopt);
    CHECK(hand.hold({Direction::Left}) == Direction::Left);
    CHECK(hand.hold({Direction::Left, Direction::Up}) == Direction::Up);
    CHECK(hand.hold({Direction::Left, Direction::Up}) == Direction::Up);
    CHECK(hand.hold({Direction::Left}) == Direction::Left);
    CHECK(hand.hold({Direction::Left, Direction::Right}) == Direction::Right);
    CHECK(hand.hold({Direction::Right}) == Direction::Right);
}

// 18 ticks at 100 % are 22.5 pixels, nearly three tiles.
TEST_CASE("a tap is remembered for 0.3 s, 18 ticks, after the key was released", "[games][maze]") {
    Hand hand;
    CHECK(hand.hold({Direction::Down}) == Direction::Down);
    for (int tick = 0; tick < 18; ++tick) CHECK(hand.hold({}) == Direction::Down);
    CHECK(hand.hold({}) == std::nullopt);
}
