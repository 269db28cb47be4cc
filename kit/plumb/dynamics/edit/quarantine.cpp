// SPDX-License-Identifier: MIT
#include <plumb/dynamics/edit/quarantine.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/dynamics/edit/body_shapes.h>
#include <plumb/dynamics/edit/edits.h>

namespace plumb {

namespace {

/// Removes, among the ends from an index on, those of touches that began in this same step, together with their begins:
/// users read ends before begins, so such a pair would be misunderstood.
void dropEndsOfNewTouches(WorldState& world, std::size_t from) {
    const auto isOfNewTouch = [&world](const ContactEnd& end) {
        const auto begin =
            std::find_if(world.events.begins.begin(), world.events.begins.end(),
                         [&end](const ContactBegin& b) { return b.shapeA == end.shapeA && b.shapeB == end.shapeB; });
        if (begin == world.events.begins.end()) return false;
        world.events.begins.erase(begin);
        return true;
    };
    const auto first = world.events.ends.begin() + static_cast<std::ptrdiff_t>(from);
    world.events.ends.erase(std::remove_if(first, world.events.ends.end(), isOfNewTouch), world.events.ends.end());
}

/// A body whose numbers ran away within the step has no place where it hit.
void dropHitsOfNoPlace(WorldEvents& events) {
    std::erase_if(events.hits,
                  [](const ContactHit& hit) { return !hit.point.allFinite() || !std::isfinite(hit.approachSpeed); });
}

}  // namespace

void quarantine(WorldState& world) {
    const std::vector<BodyIndex> leaving = std::move(world.bodies.outOfRange);
    world.bodies.outOfRange.clear();
    for (const BodyIndex body : leaving) {
        wakeNeighbours(world, body);
        if (world.bodies.record[body].enabled) {
            const std::size_t firstNewEnd = world.events.ends.size();
            hideShapes(world, body);
            dropEndsOfNewTouches(world, firstNewEnd);
        }
        world.bodies.putToSleep(body);
        for (const JointIndex joint : world.bodies.links[body].joints)
            world.joints.loads[joint] = {};  // its load was not a finite number
        world.bodies.motion[body].velocity.setZero();
        world.bodies.motion[body].angularVelocity = 0;
        world.bodies.rest(body);
        world.events.quarantines.push_back({world.bodies.idOf(body)});
    }
    if (!leaving.empty()) dropHitsOfNoPlace(world.events);
}

}  // namespace plumb
