// SPDX-License-Identifier: MIT
#include <games/runner/palette.h>

namespace plumb::games::runner {
namespace {

// clang-format off
const Palette dawn{
    .skyHigh = Color::hex(0x5a6fb5), .skyLow = Color::hex(0xffd9b0),
    .light = Color::hex(0xfff1cf), .lightX = 0.72, .lightY = 0.5,
    .far = Color::hex(0xb9a0c4), .middle = Color::hex(0x8d86b4), .near = Color::hex(0x5f7a8f),
    .cloud = Color::hex(0xffeadd).faded(0.75),
    .turf = Color::hex(0x5fa35a), .turfLight = Color::hex(0x9fd27a),
    .soil = Color::hex(0x7a4f45), .deep = Color::hex(0x3d2a39),
    .ledge = Color::hex(0xc98f5a), .brick = Color::hex(0xc4694a), .metal = Color::hex(0x59627c),
    .coin = Color::hex(0xffd24a), .thorn = Color::hex(0x7c2f56), .water = Color::hex(0x4f8fb8),
    .wood = Color::hex(0xc08a52), .dust = Color::hex(0xf3e3cf), .dark = 0};
const Palette noon{
    .skyHigh = Color::hex(0x2f9bc4), .skyLow = Color::hex(0xe6f3d8),
    .light = Color::hex(0xffffff), .lightX = 0.28, .lightY = 0.2,
    .far = Color::hex(0xe0bf94), .middle = Color::hex(0xcf966a), .near = Color::hex(0xa96a52),
    .cloud = Color::hex(0xffffff).faded(0.85),
    .turf = Color::hex(0xe0a552), .turfLight = Color::hex(0xffd98a),
    .soil = Color::hex(0xa5563f), .deep = Color::hex(0x552a33),
    .ledge = Color::hex(0x8a6a58), .brick = Color::hex(0x8f5f9c), .metal = Color::hex(0x46586b),
    .coin = Color::hex(0xfff07a), .thorn = Color::hex(0x3b4a3a), .water = Color::hex(0x2e86a0),
    .wood = Color::hex(0x9c6b43), .dust = Color::hex(0xffe9c4), .dark = 0};
const Palette night{
    .skyHigh = Color::hex(0x0c1030), .skyLow = Color::hex(0x35396f),
    .light = Color::hex(0xe8ecff), .lightX = 0.8, .lightY = 0.22,
    .far = Color::hex(0x2b2f63), .middle = Color::hex(0x212452), .near = Color::hex(0x171a40),
    .cloud = Color::hex(0x8f97d6).faded(0.18),
    .turf = Color::hex(0x2f8f86), .turfLight = Color::hex(0x62d0b4),
    .soil = Color::hex(0x4a4a86), .deep = Color::hex(0x1b1b45),
    .ledge = Color::hex(0x8a6fa8), .brick = Color::hex(0x7a4f8f), .metal = Color::hex(0x8a93b8),
    .coin = Color::hex(0xffd24a), .thorn = Color::hex(0xb0356b), .water = Color::hex(0x26568f),
    .wood = Color::hex(0x8f6a5c), .dust = Color::hex(0xb9bfe8), .dark = 0.42};
// clang-format on

}  // namespace

const Palette& paletteOf(Sky sky) {
    switch (sky) {
        case Sky::Dawn: return dawn;
        case Sky::Noon: return noon;
        case Sky::Night: break;
    }
    return night;
}

}  // namespace plumb::games::runner
