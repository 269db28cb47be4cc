// SPDX-License-Identifier: MIT
#include <plumb/dynamics/edit/step_edits.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/dynamics/contacts/crowd.h>
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

/// Pairs that edits or impacts have added since the last search are reported once more, and known by the list early; it
/// is sorted once, so each look-up costs O(log n). In a crowd, pairs that were left out come back first, as soon as
/// their bodies have room.
void addNewPairs(WorldState& w) {
    const SortedPairs& pairs = w.space.findNewPairs();
    const std::span<const Vec2> shifts = w.space.newPairShifts();
    Crowd crowd(w.contacts, w.bodies, w.space);
    if (!w.contacts.leftOut.empty())
        crowd.takeBack([&w](const ShiftedShapes& pair) {
            for (const ProxyId proxy : {pair.shapes.a, pair.shapes.b}) w.bodies.notePlaced(w.space[proxy].owner);
            w.contacts.early.push_back(pair.shapes);  // shapes that were edited meanwhile are found again below
            addPair(w, pair);
        });
    std::vector<Pair>& early = w.contacts.early;
    std::sort(early.begin(), early.end());
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const ShiftedShapes pair{pairs[i], shifts.empty() ? Vec2(0, 0) : shifts[i]};
        if (std::binary_search(early.begin(), early.end(), pairs[i]) &&
            findContact(w.contacts, w.bodies, w.space, pair) != none)
            continue;
        if (!crowd.leavesOut(pair)) addPair(w, pair);
    }
    early.clear();
}

/// Called twice a step: after load, for what edits and fields did, and at the end, for what the step did. Neighbours
/// wake, because what they lay on is gone. The body stays where its last finite state was. Test: "a body that overflows
/// is put in quarantine with one event, and its neighbours go on"
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
