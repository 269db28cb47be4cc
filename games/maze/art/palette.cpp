// SPDX-License-Identifier: MIT
#include <games/maze/art/palette.h>

namespace plumb::games::maze {

Theme theme() {
    return {.background = night,
            .panel = Color::hex(0x1b2550),
            .text = paper,
            .quiet = Color::hex(0xa9b3d6),
            .accent = cheese};
}

}  // namespace plumb::games::maze
