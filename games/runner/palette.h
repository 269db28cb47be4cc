// SPDX-License-Identifier: MIT
// Which colours does a level have?
#pragma once
#include <games/frame/color.h>
#include <games/runner/level.h>

namespace plumb::games::runner {

struct Palette {
    Color skyHigh, skyLow;
    Color light;              ///< of the sun or the moon
    double lightX, lightY;    ///< its place, as a share of the screen's width and height [-]
    Color far, middle, near;  ///< hills, one behind the other
    Color cloud;
    Color turf, turfLight;  ///< the rim of the ground
    Color soil, deep;       ///< just under the turf, and deep under it
    Color ledge;
    Color brick;
    Color metal;  ///< of snuffers
    Color coin;
    Color thorn;
    Color water;
    Color wood;
    Color dust;
    double dark;  ///< opacity of the night far from the flame; 0: no night [-]
};

const Palette& paletteOf(Sky sky);

}  // namespace plumb::games::runner
