// SPDX-License-Identifier: MIT
// How are the cats, the mouse, and what they eat drawn?
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

struct MousePose {
    double angle = 0;   ///< of its nose, from +x towards +y [rad]
    double stride = 0;  ///< how far it has run; moves feet and tail [tiles]
    bool still = false;
    bool blinks = false;
};

/// Seen from above. Its middle is at (0, 0), and it is about 1.6 long without the tail. Place it with Canvas.place.
void drawMouse(Canvas& canvas, const MousePose& pose);
/// The caught mouse disappears. share: of the time that this takes, 0 to 1.
void drawLostMouse(Canvas& canvas, double angle, double share);

void drawCrumb(Canvas& canvas, const Vec2& at);
/// pulse 0 to 1: how much it glows.
void drawCheese(Canvas& canvas, const Vec2& at, double pulse);
/// Kind 0 to 7, as in the kit's ArcadeFruit: a blueberry, a hazelnut, a mushroom, a pear, a pot of honey, a cake, a
/// fish bone that the cats left, a golden bell. About 1.5 high round (0, 0).
void drawFruit(Canvas& canvas, int kind);

}  // namespace plumb::games::maze
