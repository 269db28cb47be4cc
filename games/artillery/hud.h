// SPDX-License-Identifier: MIT
// Which texts and bars are drawn over the picture?
#pragma once
#include <string>

#include <games/artillery/battle.h>
#include <games/artillery/palette.h>
#include <games/frame/canvas.h>

namespace plumb::games::artillery {

struct Hud {
    const Battle& battle;
    std::int64_t score = 0;
    std::string stage;    ///< the island's name
    std::string rivals;   ///< who plays the other crew
    bool person = false;  ///< does a person play the crew whose turn it is?
    double seconds = 0;
};

void drawHud(Canvas& canvas, const Hud& hud);
/// A band across the middle, on top of everything, when a battle is won or lost.
void drawBanner(Canvas& canvas, const std::string& title, const std::string& line, const Color& color, double seconds);

}  // namespace plumb::games::artillery
