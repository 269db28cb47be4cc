// SPDX-License-Identifier: MIT
// Who are the four hunters, and which cell does each go to?
#pragma once
#include <array>
#include <cstdint>

#include <games/maze/layout.h>

namespace plumb::games::maze {

/// The four hunters, in the kit's order. They differ only in the rule for their target cell; all go there by the kit's
/// nextDirection.
enum class Who : std::uint8_t {
    Chaser,    ///< goes where the player is
    Ambusher,  ///< goes where the player will be
    Flanker,   ///< tries to have the player between itself and the chaser
    Loner,     ///< comes near, then goes back to its corner
};
inline constexpr std::array<Who, 4> everyone{Who::Chaser, Who::Ambusher, Who::Flanker, Who::Loner};
constexpr std::size_t indexOf(Who who) {
    return static_cast<std::size_t>(who);
}

inline Cell chaseTarget(Who who, const HunterContext& question) {
    return hunterTarget(static_cast<int>(who), question, specialPlaces());
}
/// It is not in a lane, so a hunter never arrives: it moves in circles in that corner of the maze.
inline Cell scatterTarget(Who who) {
    return specialPlaces().corners[indexOf(who)];
}

}  // namespace plumb::games::maze
