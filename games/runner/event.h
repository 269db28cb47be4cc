// SPDX-License-Identifier: MIT
// Which events of a tick are drawn or heard?
#pragma once
#include <vector>

#include <games/frame/cue.h>
#include <plumb/math/vec2.h>

namespace plumb::games::runner {

enum class EventKind {
    Jumped,
    Landed,    ///< strength: the landing speed [m/s]
    Skidded,   ///< the hero turns round at high speed; strength: the new direction
    Stomped,   ///< strength: number of stomps since the hero left the floor, from 1
    Squashed,  ///< a walker, by a crate or by a block bumped from below
    Sprung,    ///< thrown up by a spring
    Coin,      ///< taken
    Sun,       ///< taken; strength: its number, from 0
    Oil,       ///< taken
    Bumped,    ///< from below, against a lamp that was lit before
    LampLit,   ///< strength: number of coins in it; 0: a drop of oil
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

/// The sounds that it makes.
std::vector<Cue> soundsOf(const Event& event);

}  // namespace plumb::games::runner
