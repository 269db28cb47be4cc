// SPDX-License-Identifier: MIT
#include <algorithm>

#include <plumb/dynamics/state/world_state.h>
#include <plumb/dynamics/world.h>

namespace plumb {

std::span<const ContactBegin> World::contactBegins() const {
    return state_->events.begins;
}

std::span<const ContactEnd> World::contactEnds() const {
    return {state_->events.ends.data(), state_->events.reportedEnds};
}

std::span<const ContactHit> World::contactHits() const {
    return state_->events.hits;
}

std::span<const SensorBegin> World::sensorBegins() const {
    return state_->sensors.begins;
}

std::span<const SensorEnd> World::sensorEnds() const {
    return state_->sensors.ends;
}

std::span<const Quarantined> World::quarantines() const {
    return state_->events.quarantines;
}

/// In the order of slots, which does not depend on the order of the list awake. A body that was removed since the step
/// has no pose any more. O(n log n).
std::vector<BodyMoved> World::moves() const {
    const auto sorted = [](std::vector<BodyIndex> bodies) {
        std::sort(bodies.begin(), bodies.end());
        return bodies;
    };
    const std::vector<BodyIndex> sleepers = sorted(state_->events.sleepers), gone = sorted(state_->events.gone);
    std::vector<BodyMoved> moves;
    for (const BodyIndex body : sorted(state_->events.movers)) {
        if (std::binary_search(gone.begin(), gone.end(), body)) continue;
        const bool sleeps = std::binary_search(sleepers.begin(), sleepers.end(), body);
        const Transform pose = state_->bodies.pose(body);
        moves.push_back({state_->bodies.idOf(body), {state_->bodies.wrap.place(pose.position), pose.rotation}, sleeps});
    }
    return moves;
}

}  // namespace plumb
