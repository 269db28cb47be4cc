// SPDX-License-Identifier: MIT
// Which colours does an island have at its time of day?
#pragma once
#include <array>
#include <string_view>

#include <games/frame/color.h>

namespace plumb::games::artillery {

struct Palette {
    Color skyTop, skyMiddle, skyLow;
    Color sun;                     ///< or moon
    double sunX, sunY, sunRadius;  ///< [m]
    bool stars;
    Color cloud;
    Color farHills, nearHills;
    Color farSea, sea, foam;
    Color earthTop, earthDeep, layer;  ///< layer is drawn over both
    Color turf, turfLight, burnt;
};
const Palette& paletteOf(int stage);

inline constexpr Color ink = Color::hex(0x1d1630);
inline constexpr Color paper = Color::hex(0xfff4df);
inline constexpr Color skin = Color::hex(0xffd3a6);
inline constexpr Color gold = Color::hex(0xffc94a);
inline constexpr std::array<Color, 2> crewColors{Color::hex(0xef4b3b), Color::hex(0x19b5b0)};
inline constexpr std::array<std::string_view, 2> crewNames{"Embers", "Tides"};
inline const Color& crewColor(int crew) {
    return crewColors[crew == 0 ? 0 : 1];
}

}  // namespace plumb::games::artillery
