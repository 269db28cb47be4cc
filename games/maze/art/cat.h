// SPDX-License-Identifier: MIT
// How is a hunter drawn, and how does its face show its mood?
#pragma once
#include <games/frame/canvas.h>
#include <games/maze/targets.h>

namespace plumb::games::maze {

enum class Mood { Rests, Hunts, Hastes, Frightened, Flashes, Eyes };

struct CatPose {
    Mood mood = Mood::Hunts;
    Direction looks = Direction::Left;
    double stride = 0;  ///< moves paws and tail; any value that grows
};

/// Its middle is at (0, 0), and it is about 1.7 high. Place it with Canvas.place.
void drawCat(Canvas& canvas, Who who, const CatPose& pose);

}  // namespace plumb::games::maze
