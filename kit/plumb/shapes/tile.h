// SPDX-License-Identifier: MIT
// What can be in a cell of a tile map?
#pragma once
#include <cstdint>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb {

/// How much of its cell a tile fills. Slopes rise (Up) or fall (Down) to the right. A gentle slope, called "22.5
/// degrees" in games although it rises by one in two (26.57), has two halves: Low fills less than half of its cell.
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
    OneWay,  ///< solid at its top only, for bodies that come from above, not from the side
    Hazard,  ///< solid; contacts with it are reported as hazards
    Sensor,  ///< has no contacts, but reports what overlaps it
};

struct Tile {
    TileForm form = TileForm::Empty;
    TileKind kind = TileKind::Solid;
    bool upsideDown = false;  ///< mirrored vertically: it fills its cell from above
    std::uint32_t tag = 0;    ///< free for the user
    friend bool operator==(const Tile&, const Tile&) = default;
};

inline bool isEmpty(const Tile& tile) {
    return tile.form == TileForm::Empty;
}
/// Is it solid from all sides?
inline bool isSolid(const Tile& tile) {
    return !isEmpty(tile) && (tile.kind == TileKind::Solid || tile.kind == TileKind::Hazard);
}

/// The outline of the filled area, counter-clockwise, in a cell from (0, 0) to (1, 1); no corners when empty.
std::vector<Vec2> cornersOf(const Tile& tile);

}  // namespace plumb
