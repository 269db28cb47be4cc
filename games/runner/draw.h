// SPDX-License-Identifier: MIT
// How does a stage look?
#pragma once
#include <games/frame/canvas.h>
#include <games/frame/pose_trail.h>
#include <games/runner/palette.h>
#include <games/runner/stage.h>
#include <games/runner/view.h>

namespace plumb::games::runner {

struct Scene {
    const Stage& stage;
    const PoseTrail& trail;
    const View& view;
    const Palette& palette;
    double time = 0;     ///< elapsed, with the current fraction of a tick [s]
    double between = 1;  ///< the same as Canvas::between()
    Camera camera{};     ///< of the stage
    double stageTime() const { return view.stageTime(between); }

    Vec2 at(BodyId body) const { return trail.pose(stage.world(), body, between).position; }
};

void drawBackdrop(Canvas& canvas, const Scene& scene);  ///< sky, clouds and distant hills
// The next functions draw in world units.
void drawTiles(Canvas& canvas, const Scene& scene);
void drawPlaces(Canvas& canvas, const Scene& scene);  ///< lanterns, the beacon, springs
void drawLifts(Canvas& canvas, const Scene& scene);
void drawCrates(Canvas& canvas, const Scene& scene);
void drawTreasures(Canvas& canvas, const Scene& scene);
void drawFoes(Canvas& canvas, const Scene& scene);
void drawHero(Canvas& canvas, const Scene& scene);
void drawWater(Canvas& canvas, const Scene& scene);
void drawNight(Canvas& canvas, const Scene& scene);   ///< darkness outside the light of the flame
void drawLights(Canvas& canvas, const Scene& scene);  ///< lights that stay visible in the darkness
void drawLamps(Canvas& canvas, const Scene& scene);   ///< the lamp tiles that are not lit yet

/// A small flame with its foot at this place; lean: -1 to 1, size: its height [m].
void drawFlame(Canvas& canvas, const Vec2& foot, double size, double lean, double time);

/// The values shown at the top of the screen.
struct Hud {
    std::int64_t score = 0;
    int coins = 0, lives = 0, level = 1;
    double seconds = 0;
    std::vector<bool> suns;
    const char* profile = "";
};
void drawHud(Canvas& canvas, const Hud& hud);

/// A band of text across the upper part of the picture, above the usual place of the hero.
struct Card {
    std::string title;
    std::vector<std::string> lines;
};
/// share: the drawn part of the band's width, 0 to 1; the text appears only at 1.
void drawCard(Canvas& canvas, const Card& card, double share);
/// A dark screen with a round hole around a place of the world; open: 1 is no darkness, 0 is no hole.
void drawIris(Canvas& canvas, const Vec2& at, double open);

}  // namespace plumb::games::runner
