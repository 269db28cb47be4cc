// SPDX-License-Identifier: MIT
// What is written over the picture?
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
    std::string rivals;   ///< who commands the other crew
    bool person = false;  ///< does somebody with buttons play the crew in turn?
    double seconds = 0;
};

void drawHud(Canvas& canvas, const Hud& hud);
/// Across the middle, over all, as an island is taken or lost.
void drawBanner(Canvas& canvas, const std::string& title, const std::string& line, const Color& color, double seconds);

}  // namespace plumb::games::artillery
