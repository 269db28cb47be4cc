// SPDX-License-Identifier: MIT
#include <games/maze/steering.h>

namespace plumb::games::maze {
namespace {

constexpr int tapTicks = 18;  ///< the mouse runs about three tiles in this time

}  // namespace

const char* actionOf(Direction direction) {
    switch (direction) {
        case Direction::Up: return "up";
        case Direction::Left: return "left";
        case Direction::Down: return "down";
        case Direction::Right: break;
    }
    return "right";
}

std::optional<Direction> Steering::update(const Input& input) {
    for (const Direction direction : allDirections) {
        const char* action = actionOf(direction);
        std::erase_if(held_, [&](Direction other) { return other == direction && !input.held(action); });
        if (!input.pressed(action)) continue;
        held_.push_back(direction);
        tapped_ = direction;
        memory_ = tapTicks;
    }
    if (!held_.empty()) return held_.back();
    if (memory_ == 0) return std::nullopt;
    --memory_;
    return tapped_;
}

void Steering::addTo(Hash& hash) const {
    for (const Direction direction : held_) hash.add(static_cast<int>(direction));
    hash.add(tapped_ ? static_cast<int>(*tapped_) : -1).add(memory_);
}

}  // namespace plumb::games::maze
