// SPDX-License-Identifier: MIT
// Which colours does the game use?
#pragma once
#include <array>

#include <games/frame/game.h>
#include <games/maze/targets.h>

namespace plumb::games::maze {

// A garden at night: dark teal hedges with moonlit rims, and warm light on the animals.
inline constexpr Color night = Color::hex(0x080b1b);
inline constexpr Color groove = Color::hex(0x11183a);
inline constexpr Color hedgeFlash = Color::hex(0xf4ffe9);
inline constexpr Color wood = Color::hex(0xd9a066);
inline constexpr Color crumb = Color::hex(0xf7e3b5);
inline constexpr Color cheese = Color::hex(0xffd34f);
inline constexpr Color fur = Color::hex(0xf3ecdf);
inline constexpr Color furShade = Color::hex(0xc9bcb0);
inline constexpr Color skin = Color::hex(0xff9fae);
inline constexpr Color ink = Color::hex(0x1a1530);
inline constexpr Color paper = Color::hex(0xf5f1e6);
inline constexpr Color quiet = Color::hex(0x8f9bc4);
inline constexpr Color scared = Color::hex(0x3b55e0);
inline constexpr Color scaredLight = Color::hex(0xf2f4ff);

struct GardenLook {
    Color lawn, hedge, rim;
};

/// One for each level; after the last the first again.
inline constexpr std::array<GardenLook, 6> gardens{{
    {Color::hex(0x11183a), Color::hex(0x17414a), Color::hex(0x46b39a)},  // box trees
    {Color::hex(0x1a1438), Color::hex(0x3a2a63), Color::hex(0x9a7fe0)},  // lavender
    {Color::hex(0x16192e), Color::hex(0x4a3222), Color::hex(0xd08a48)},  // beeches in autumn
    {Color::hex(0x0e1c3c), Color::hex(0x23456e), Color::hex(0x8cc4f0)},  // hoar frost
    {Color::hex(0x1c1430), Color::hex(0x54243f), Color::hex(0xe07a9c)},  // roses
    {Color::hex(0x101c2c), Color::hex(0x2b4a22), Color::hex(0x9ccb52)},  // moss
}};
constexpr const GardenLook& gardenOf(int level) {
    return gardens[static_cast<std::size_t>(level - 1) % gardens.size()];
}

struct CatLook {
    Color fur;
    Color dark;  ///< ears and stripes
    const char* name;
    const char* habit;
};

inline constexpr std::array<CatLook, 4> cats{{
    {Color::hex(0xff5a4a), Color::hex(0xa82a2c), "Rusty", "runs after you"},
    {Color::hex(0xff9ad2), Color::hex(0xb8508f), "Pearl", "cuts you off"},
    {Color::hex(0x55d3f2), Color::hex(0x2480a8), "Misty", "comes from behind"},
    {Color::hex(0xffb03b), Color::hex(0xb36a12), "Biscuit", "shy when near"},
}};
constexpr const CatLook& lookOf(Who who) {
    return cats[indexOf(who)];
}

inline Theme theme() {
    return {.background = night,
            .panel = Color::hex(0x1b2550),
            .text = paper,
            .quiet = Color::hex(0xa9b3d6),
            .accent = cheese};
}

}  // namespace plumb::games::maze
