// SPDX-License-Identifier: MIT
// Which direction do the keys that are held or were just tapped ask for?
#pragma once
#include <optional>
#include <vector>

#include <games/frame/hash.h>
#include <games/frame/input.h>
#include <plumb/movers/grid_direction.h>

namespace plumb::games::maze {

/// The name of the action that steers in this direction.
const char* actionOf(Direction direction);

/// If several keys are held, the last one pressed counts. A tap is remembered for 0.3 s: the mouse still turns if the
/// key is released before the corner.
class Steering {
public:
    std::optional<Direction> update(const Input& input);
    void addTo(Hash& hash) const;

private:
    std::vector<Direction> held_;  ///< in the order pressed
    std::optional<Direction> tapped_;
    int memory_ = 0;  ///< how long the tap is still remembered [ticks]
};

}  // namespace plumb::games::maze
