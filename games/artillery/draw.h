// SPDX-License-Identifier: MIT
// How is a battle drawn: sky, sea and earth, gunners and shells, aim lines, and the chart of the island?
#pragma once
#include <array>
#include <vector>

#include <games/artillery/arrangement.h>
#include <games/artillery/battle.h>
#include <games/artillery/eye.h>
#include <games/artillery/palette.h>
#include <games/frame/canvas.h>
#include <games/frame/pose_trail.h>

namespace plumb::games::artillery {

/// Sky, sun, clouds, gulls or stars, far islands and the far sea, each with the parallax of its distance. drift: how
/// far the wind has blown so far [m].
void drawBackdrop(Canvas& canvas, const Camera& camera, const Palette& palette, double seconds, double drift);
/// These two use the canvas's current camera.
void drawEarth(Canvas& canvas, const Terrain& terrain, const Palette& palette);
void drawSea(Canvas& canvas, double level, const Palette& palette, double seconds);

struct Figures {
    const Battle& battle;
    const PoseTrail& trail;
    double seconds = 0;
    double recoil = 0;  ///< of the current gunner's barrel; 1 just after a shot [-]
};

void drawProps(Canvas& canvas, const Figures& figures);
void drawGunners(Canvas& canvas, const Figures& figures);
void drawTags(Canvas& canvas, const Figures& figures);  ///< health, and whose turn it is
void drawShell(Canvas& canvas, const Figures& figures);

/// Only a gunner's head, for the crews' panels; in any units.
void drawHead(Canvas& canvas, const Vec2& at, double radius, int crew, const Vec2& gaze);

inline constexpr int shortLine = 52;  ///< [ticks]
inline constexpr int fullLine = 540;

/// Draws the kit's forecast of the shell for this many ticks, at most up to the explosion. The forecast is made here,
/// from the current world.
void drawAimLine(Canvas& canvas, const Battle& battle, int ticks, double seconds);

/// The path of each crew's last shell.
class Traces {
public:
    void update(const Battle& battle);  ///< one tick
    void draw(Canvas& canvas, int crew) const;

private:
    std::array<std::vector<Vec2>, 2> points_;
};

/// A small picture of the island with its gunners, the shell and a frame around what is seen, in units of the screen.
/// seen: the visible part of the world.
void drawChart(Canvas& canvas, const Battle& battle, const Palette& palette, const Aabb& seen, double top);

}  // namespace plumb::games::artillery
