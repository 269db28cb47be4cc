// SPDX-License-Identifier: MIT
// Who are the four, and where does each want to be?
#pragma once
#include <array>
#include <cstdint>

#include <games/maze/layout.h>

namespace plumb::games::maze {

/// Four characters, in the kit's order. Each is nothing but a rule for one cell, its target; all go there by the kit's
/// nextDirection.
enum class Who : std::uint8_t {
    Chaser,    ///< goes where the player is
    Ambusher,  ///< goes where the player will be
    Flanker,   ///< takes the player between itself and the chaser
    Loner,     ///< comes near, and takes fright
};
inline constexpr std::array<Who, 4> everyone{Who::Chaser, Who::Ambusher, Who::Flanker, Who::Loner};
constexpr std::size_t indexOf(Who who) {
    return static_cast<std::size_t>(who);
}

inline Cell chaseTarget(Who who, const HunterContext& question) {
    return hunterTarget(static_cast<int>(who), question, specialPlaces());
}
/// Outside of the lanes, so that a hunter goes round and round the corner that is nearest.
inline Cell scatterTarget(Who who) {
    return specialPlaces().corners[indexOf(who)];
}

}  // namespace plumb::games::maze
