// SPDX-License-Identifier: MIT
// What can fill a cell of a tile map?
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb {

/// How much of its cell a tile fills. Slopes rise (Up) or fall (Down) to the right. A gentle one, whose name in games
/// is "22.5 degrees" though it rises by one in two (26.57), comes in two halves: Low fills less than half of its cell.
enum class TileForm : std::uint8_t {
    Empty,
    Full,
    SlopeUp,
    SlopeDown,
    GentleUpLow,
    GentleUpHigh,
    GentleDownHigh,
    GentleDownLow,
};

enum class TileKind : std::uint8_t {
    Solid,
    OneWay,  ///< its top only, to what comes from above, not from the side
    Hazard,  ///< solid; whoever meets it can tell
    Sensor,  ///< touches nothing, and tells what overlaps it
};

struct Tile {
    TileForm form = TileForm::Empty;
    TileKind kind = TileKind::Solid;
    bool hanging = false;   ///< the form upside down: it fills its cell from above
    std::uint32_t tag = 0;  ///< whatever its owner wants to know it by
    friend bool operator==(const Tile&, const Tile&) = default;
};

inline bool isEmpty(const Tile& tile) {
    return tile.form == TileForm::Empty;
}
/// Does it stop what comes from any side?
inline bool isSolid(const Tile& tile) {
    return !isEmpty(tile) && (tile.kind == TileKind::Solid || tile.kind == TileKind::Hazard);
}

/// The outline of what fills the cell, counter-clockwise, in a cell from (0, 0) to (1, 1); no corners when empty.
std::vector<Vec2> cornersOf(const Tile& tile);

}  // namespace plumb
