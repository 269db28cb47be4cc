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
    double time = 0;     ///< that has passed, the part of a tick with it [s]
    double between = 1;  ///< as Canvas::between()
    double stageTime() const { return view.stageTime(between); }

    Vec2 at(BodyId body) const { return trail.pose(stage.world(), body, between).position; }
};

void drawBackdrop(Canvas& canvas, const Scene& scene);  ///< sky, clouds, and hills that stay behind
// Each in the world's units.
void drawTiles(Canvas& canvas, const Scene& scene);
void drawPlaces(Canvas& canvas, const Scene& scene);  ///< lanterns, the beacon, springs
void drawLifts(Canvas& canvas, const Scene& scene);
void drawCrates(Canvas& canvas, const Scene& scene);
void drawTreasures(Canvas& canvas, const Scene& scene);
void drawFoes(Canvas& canvas, const Scene& scene);
void drawHero(Canvas& canvas, const Scene& scene);
void drawWater(Canvas& canvas, const Scene& scene);
void drawNight(Canvas& canvas, const Scene& scene);   ///< the dark that the flame keeps off
void drawLights(Canvas& canvas, const Scene& scene);  ///< what shines out of that dark
void drawLamps(Canvas& canvas, const Scene& scene);   ///< those of the tiles that are not lit yet

/// A small flame, its foot at a place; lean -1 to 1, size is its height [m].
void drawFlame(Canvas& canvas, const Vec2& foot, double size, double lean, double time);

/// What a player is told.
struct Hud {
    std::int64_t score = 0;
    int coins = 0, lives = 0, level = 1;
    double seconds = 0;
    std::vector<bool> suns;
    const char* profile = "";
};
void drawHud(Canvas& canvas, const Hud& hud);

/// A band over the upper part of the picture, above where the hero mostly is.
struct Card {
    std::string title;
    std::vector<std::string> lines;
};
/// As far drawn across as share says, 0 to 1; only then there are words on it.
void drawCard(Canvas& canvas, const Card& card, double share);
/// Darkness that closes around a place of the world: open 1, closed 0.
void drawIris(Canvas& canvas, const Vec2& at, double open);

}  // namespace plumb::games::runner
