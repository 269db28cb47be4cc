// SPDX-License-Identifier: MIT
// How do gunners, crates and shells look?
#pragma once
#include <games/artillery/battle.h>
#include <games/artillery/palette.h>
#include <games/frame/canvas.h>
#include <games/frame/pose_trail.h>

namespace plumb::games::artillery {

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

}  // namespace plumb::games::artillery
