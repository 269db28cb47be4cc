// SPDX-License-Identifier: MIT
// Which way does the player want to go, of all keys that are held or were just tapped?
#pragma once
#include <optional>
#include <vector>

#include <games/frame/hash.h>
#include <games/frame/input.h>
#include <plumb/movers/grid_direction.h>

namespace plumb::games::maze {

/// The name of the action that steers there.
const char* actionOf(Direction direction);

/// Of keys held together the one pressed last counts. A tap is remembered for a moment: whoever lets go before the
/// corner still turns.
class Steering {
public:
    std::optional<Direction> update(const Input& input);
    void addTo(Hash& hash) const;

private:
    std::vector<Direction> held_;  ///< as they were pressed
    std::optional<Direction> tapped_;
    int memory_ = 0;  ///< of the tap [ticks]
};

}  // namespace plumb::games::maze
