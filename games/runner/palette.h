// SPDX-License-Identifier: MIT
// Which colours has a level?
#pragma once
#include <games/frame/color.h>
#include <games/runner/level.h>

namespace plumb::games::runner {

struct Palette {
    Color skyHigh, skyLow;
    Color light;              ///< of sun or moon
    double lightX, lightY;    ///< where it stands, of the screen's width and height [-]
    Color far, middle, near;  ///< hills, one behind the other
    Color cloud;
    Color turf, turfLight;  ///< the rim of the ground
    Color soil, deep;       ///< under it, and far under it
    Color ledge;
    Color brick;
    Color metal;  ///< of snuffers
    Color coin;
    Color thorn;
    Color water;
    Color wood;
    Color dust;
    double dark;  ///< how much of the picture the night hides far from the flame [-]
};

const Palette& paletteOf(Sky sky);

}  // namespace plumb::games::runner
