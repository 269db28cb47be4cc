// SPDX-License-Identifier: MIT
#include <games/artillery/palette.h>

namespace plumb::games::artillery {
namespace {

constexpr Color hex(std::uint32_t rgb) {
    return Color::hex(rgb);
}

constexpr std::array<Palette, 3> palettes{{
    {hex(0x4aa3d8), hex(0x9fd8e8), hex(0xfff0cf), hex(0xfff7d6), -11,           25,
     2.6,           false,         hex(0xffffff), hex(0x8fc3cf), hex(0x6aa6b4), hex(0x62bcc9),
     hex(0x1f7f9c), hex(0xeafcff), hex(0xa9744a), hex(0x4e2f35), hex(0x5c3326), hex(0x5fae4b),
     hex(0xa8d95f), hex(0x40302c)},
    {hex(0x3b2a63), hex(0xc4567a), hex(0xffb25c), hex(0xffe2a0), 15,
     8.5,           4.4,           false,         hex(0xf08a86), hex(0x9a4a78),
     hex(0x6a3568), hex(0xd0758a), hex(0x4b2f73), hex(0xffd9b8), hex(0x8a4a4e),
     hex(0x2f1c3c), hex(0x42203c), hex(0xb98a3a), hex(0xf2c24e), hex(0x2a1a2c)},
    {hex(0x0c1230),
     hex(0x1f2d5c),
     hex(0x4a5f9a),
     hex(0xf2f3dc),
     11,
     25,
     2.3,
     true,
     hex(0x2c3a6b),
     hex(0x1d2a57),
     hex(0x17214a),
     hex(0x32497f),
     hex(0x14274f),
     hex(0xb9d4ff),
     hex(0x4a4b6e),
     hex(0x161631),
     hex(0x202044),
     hex(0x3f7a72),
     hex(0x6fb79a),
     hex(0x2b2947)},
}};

}  // namespace

const Palette& paletteOf(int stage) {
    return palettes[static_cast<std::size_t>(stage) % palettes.size()];
}

}  // namespace plumb::games::artillery
