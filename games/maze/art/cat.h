// SPDX-License-Identifier: MIT
// How does a hunter look, and what does its face tell?
#pragma once
#include <games/frame/canvas.h>
#include <games/maze/targets.h>

namespace plumb::games::maze {

enum class Mood { Rests, Hunts, Hastes, Frightened, Flashes, Eyes };

struct CatPose {
    Mood mood = Mood::Hunts;
    Direction looks = Direction::Left;
    double stride = 0;  ///< paws and tail go by that; anything that grows
};

/// Its middle at (0, 0), about 1.7 high. Place it with Canvas.place.
void drawCat(Canvas& canvas, Who who, const CatPose& pose);

}  // namespace plumb::games::maze
