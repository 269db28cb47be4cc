// SPDX-License-Identifier: MIT
// What happened on a stage in a tick, for ears and eyes?
#pragma once
#include <plumb/math/vec2.h>

namespace plumb::games::runner {

enum class EventKind {
    Jumped,
    Landed,    ///< strength: at which speed [m/s]
    Skidded,   ///< it turns round at full speed
    Stomped,   ///< strength: which one without touching the floor, from 1
    Squashed,  ///< something that walks, by a crate or off what is bumped from below
    Sprung,    ///< thrown up by a spring
    Coin,      ///< taken
    Sun,       ///< taken; strength: which, from 0
    Oil,       ///< taken
    Bumped,    ///< a lamp from below that was lit before
    LampLit,   ///< strength: its coins; 0: a drop of oil
    BrickBroke,
    LanternLit,
    Hurt,  ///< the flame is small now
    Died,
    Finished,  ///< the beacon is lit
};

struct Event {
    EventKind kind = EventKind::Jumped;
    Vec2 at{0, 0};  ///< [m]
    double strength = 0;
};

}  // namespace plumb::games::runner
