// SPDX-License-Identifier: MIT
// Which directions lead out of a cell?
#pragma once
#include <array>
#include <cstdint>
#include <numbers>

#include <plumb/math/vec2.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

/// Along a lane of a grid. In the order of priority of the arcade.
enum class Direction : std::uint8_t { Up, Left, Down, Right };

inline constexpr std::array<Direction, 4> allDirections{Direction::Up, Direction::Left, Direction::Down,
                                                        Direction::Right};

constexpr Direction opposite(Direction direction) {
    return static_cast<Direction>((static_cast<int>(direction) + 2) % 4);
}
/// Up, right, down, left, up.
constexpr Direction clockwise(Direction direction) {
    return static_cast<Direction>((static_cast<int>(direction) + 3) % 4);
}
constexpr bool isHorizontal(Direction direction) {
    return direction == Direction::Left || direction == Direction::Right;
}
/// Is it to the right or up, in the direction of growing coordinates?
constexpr bool isForward(Direction direction) {
    return direction == Direction::Right || direction == Direction::Up;
}
/// The cell next to this one, not wrapped.
constexpr Cell neighbourOf(Cell cell, Direction direction) {
    const int step = isForward(direction) ? 1 : -1;
    return isHorizontal(direction) ? Cell{cell.column + step, cell.row} : Cell{cell.column, cell.row + step};
}
/// The unit vector.
inline Vec2 unitOf(Direction direction) {
    const double step = isForward(direction) ? 1 : -1;
    return isHorizontal(direction) ? Vec2(step, 0) : Vec2(0, step);
}
/// From +x, in (-pi, pi] [rad].
constexpr double angleOf(Direction direction) {
    constexpr double pi = std::numbers::pi;
    switch (direction) {
        case Direction::Up: return pi / 2;
        case Direction::Left: return pi;
        case Direction::Down: return -pi / 2;
        case Direction::Right: return 0;
    }
    return 0;
}

}  // namespace plumb
