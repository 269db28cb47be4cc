// SPDX-License-Identifier: MIT
#include <algorithm>
#include <new>
#include <stdexcept>
#include <string>

#include <plumb/dynamics/counts.h>
#include <plumb/dynamics/state/world_state.h>
#include <plumb/dynamics/world.h>
#include <plumb/math/check.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {

namespace {

/// Throws if a count does not fit the 32-bit indices.
void requireCountable(std::size_t count, const char* field) {
    constexpr std::size_t most = ~std::uint32_t{0} - 1;
    if (count > most) refuse(field, std::to_string(count) + " is more than " + std::to_string(most));
}

/// Reserves memory; if there is not enough, throws with the name of the field. Memory reserved before stays reserved.
template <class Reserve>
void makeRoom(std::size_t count, const char* field, Reserve&& reserve) {
    const std::string complaint = std::to_string(count) + " is more than there is memory for";
    try {
        reserve(count);
    } catch (const std::bad_alloc&) {
        refuse(field, complaint);
    } catch (const std::length_error&) {
        refuse(field, complaint);
    }
}

template <class... Vectors>
std::size_t sumOf(const Vectors&... vectors) {
    return (std::size_t{0} + ... + bytesOf(vectors));
}

/// Reserved memory counts, not only what is in use (bytesOf of arrays.h): the question is what the world takes.
std::size_t bytesOf(const BodyStore& b) {
    std::size_t bytes =
        sumOf(b.motion, b.record, b.links, b.apart, b.step, b.place, b.velocity, b.displacement, b.warm, b.before,
              b.turn, b.kick, b.flights, b.outOfRange, b.awake, b.kinematic, b.forced, b.free);
    for (const BodyLinks& links : b.links) bytes += sumOf(links.proxies, links.joints);
    for (const std::vector<BodyIndex>& apart : b.apart) bytes += sumOf(apart);
    return bytes;
}

std::size_t bytesOf(const ContactStore& c) {
    return sumOf(c.records, c.free, c.boxes, c.corners, c.moreCorners, c.leftOut, c.early, c.watched, c.withVerdict,
                 c.overlaps, c.impacts, c.nearBoxes.lanes, c.nearBoxes.contactOf, c.nearOthers.lanes,
                 c.nearOthers.contactOf);
}

std::size_t bytesOf(const ContactGraph& graph) {
    std::size_t bytes = 0;
    for (const Colour& colour : graph.colours)
        bytes += sumOf(colour.batches, colour.manifolds, colour.pairs, colour.kept, colour.contactOf);
    return bytes;
}

/// A node of a std::map holds its value, a colour and three pointers.
std::size_t bytesOf(const std::map<BodyIndex, Mass>& map) {
    return map.size() * (sizeof(std::pair<const BodyIndex, Mass>) + 4 * sizeof(void*));
}

std::size_t bytesOf(const JointStore& j) {
    return sumOf(j.records, j.loads, j.free, j.gears);
}

std::size_t bytesOf(const WorldEvents& e) {
    return sumOf(e.begins, e.ends, e.breaks, e.hits, e.quarantines, e.movers, e.sleepers, e.gone);
}

std::size_t bytesOf(const WorldState& w) {
    const SensorStore& s = w.sensors;
    return sizeof w + bytesOf(w.bodies) + w.space.bytes() + bytesOf(w.contacts) + bytesOf(w.graph) +
           bytesOf(w.parkedMass) + sumOf(s.sensors, s.pairs, s.inside, s.begins, s.ends) + bytesOf(w.joints) +
           w.jointSolver->bytes() + bytesOf(w.events) + sumOf(w.trajectories);
}

}  // namespace

/// Growing vectors in the middle of a game cost a copy each; this does it before. Checked first, all of them, so that a
/// bad number changes nothing.
void World::reserve(const Capacity& capacity) {
    requireCountable(capacity.bodies, "Capacity.bodies");
    requireCountable(capacity.shapes, "Capacity.shapes");
    requireCountable(capacity.contacts, "Capacity.contacts");
    requireCountable(capacity.joints, "Capacity.joints");
    WorldState& world = *state_;
    makeRoom(capacity.bodies, "Capacity.bodies", [&](std::size_t bodies) {
        world.bodies.reserve(bodies + 1);  // 1 for noBody
        world.events.movers.reserve(bodies);
    });
    makeRoom(capacity.shapes, "Capacity.shapes", [&](std::size_t shapes) {
        world.space.reserve(shapes);
        world.contacts.boxes.reserve(shapes);
        world.contacts.corners.reserve(shapes);
    });
    makeRoom(capacity.contacts, "Capacity.contacts", [&](std::size_t contacts) {
        world.contacts.records.reserve(contacts);
        world.contacts.free.reserve(contacts);
    });
    makeRoom(capacity.joints, "Capacity.joints", [&](std::size_t joints) {
        world.joints.records.reserve(joints);
        world.joints.loads.reserve(joints);
    });
}

/// Counted when asked, O(bodies + contacts), so that steps keep no numbers that few programs read. A shape of several
/// pieces counts once; colours are stored as two lists each, of boxes and of others.
WorldCounts World::counts() const {
    const WorldState& world = *state_;
    WorldCounts counts;
    for (const BodyRecord& record : world.bodies.record) counts.bodies += record.alive ? 1 : 0;
    for (const BodyLinks& links : world.bodies.links) {
        const std::vector<ProxyId>& proxies = links.proxies;
        for (std::size_t i = 0; i < proxies.size(); ++i) {
            const bool isNew = i == 0 || world.space[proxies[i]].number != world.space[proxies[i - 1]].number;
            counts.shapes += isNew ? 1 : 0;
        }
    }
    counts.awakeBodies = world.bodies.awake.size();
    counts.joints = joints().size();
    for (const ContactRecord& contact : world.contacts.records) {
        const bool alive = contact.state != ContactState::Free;
        counts.contacts += alive ? 1 : 0;
        counts.touchingContacts += alive && contact.touching ? 1 : 0;
    }
    for (std::size_t i = 0; i < world.graph.colours.size(); i += 2) {
        const bool used = !world.graph.colours[i].contactOf.empty() || !world.graph.colours[i + 1].contactOf.empty();
        counts.colours += used ? 1 : 0;
    }
    counts.bytes = bytesOf(world);
    return counts;
}

}  // namespace plumb
