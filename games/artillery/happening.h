// SPDX-License-Identifier: MIT
// What has happened that is to be seen, heard or counted?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb::games::artillery {

struct Happening {
    enum class Kind {
        TurnBegan,
        Turned,
        Walked,
        Charged,
        Hurry,  ///< another second of the last few
        Fired,
        Falling,  ///< a shell is past the top of its way
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
    double size = 0;   ///< of a blast its radius [m], of a thud its speed [m/s], of a charge its share [-]
    int crew = -1;     ///< whom it concerns
    int amount = 0;    ///< of harm, in points of health
    Vec2 along{0, 1};  ///< of a shot its direction
};

}  // namespace plumb::games::artillery
