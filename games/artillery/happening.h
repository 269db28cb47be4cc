// SPDX-License-Identifier: MIT
// Which events of a battle are drawn, heard or scored?
#pragma once
#include <vector>

#include <games/frame/cue.h>
#include <plumb/math/vec2.h>

namespace plumb::games::artillery {

struct Happening {
    enum class Kind {
        TurnBegan,
        Turned,
        Walked,
        Charged,
        Hurry,  ///< once per second, in the last seconds of a turn
        Fired,
        Falling,  ///< a shell has passed the top of its path
        Bounced,
        Exploded,
        Splashed,
        Hurt,
        Died,
        Thud,
        Tide,
        Over
    };
    Kind kind = Kind::Thud;
    Vec2 at{0, 0};     ///< [m]
    double size = 0;   ///< radius of a blast [m], speed of a thud [m/s], share of the full charge [-]
    int crew = -1;     ///< the crew that it concerns
    int amount = 0;    ///< damage, in points of health
    Vec2 along{0, 1};  ///< direction of a shot
};

/// The sounds that it makes.
std::vector<Cue> cuesOf(const Happening& happening);

}  // namespace plumb::games::artillery
