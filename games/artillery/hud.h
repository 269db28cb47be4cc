// SPDX-License-Identifier: MIT
// Which texts and bars are drawn over the picture?
#pragma once
#include <string>

#include <games/artillery/arrangement.h>
#include <games/artillery/match.h>
#include <games/artillery/palette.h>
#include <games/frame/canvas.h>

namespace plumb::games::artillery {

struct Hud {
    const Match& match;
    std::string stage;   ///< the island's name
    std::string rivals;  ///< who plays the other crew
    int answer = 0;      ///< how long the sign of the turn still answers a press [ticks]
    double seconds = 0;

    const Battle& battle() const { return match.battle(); }
};

void drawHud(Canvas& canvas, const Hud& hud, const Arrangement& arrangement);
/// A band across the middle, on top of everything, when a battle is won or lost.
void drawBanner(Canvas& canvas, const std::string& title, const std::string& line, const Color& color, double seconds);

}  // namespace plumb::games::artillery
