// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/sort_out.h>

#include <algorithm>
#include <map>

#include <plumb/dynamics/detail/impacts.h>
#include <plumb/dynamics/detail/narrow_phase.h>

namespace plumb {

namespace {

/// Joined bodies and those with a contact that does not bounce clear are the solver's.
bool isConstrained(const WorldState& world, BodyIndex body) {
    const BodyRecord& record = world.bodies.record[body];
    return record.type == BodyType::Dynamic && (record.actingJoints > 0 || record.solverContacts > record.doubtful);
}

bool isConstrained(const WorldState& world, const ContactRecord& contact) {
    return isConstrained(world, contact.bodyA) || isConstrained(world, contact.bodyB);
}

/// What would bounce clear of the other if it were alone with it.
std::vector<ContactIndex> findCandidates(WorldState& world) {
    std::vector<ContactIndex> candidates;
    for (const Colour& colour : world.graph.colours) {
        for (std::size_t b = 0; b < colour.batches.size(); ++b) {
            if (!colour.batches[b].bounces) continue;
            for (std::size_t lane = 0; lane < batchLanes; ++lane)
                if (colour.manifolds[b].clear[lane] != 0) candidates.push_back(colour.contactOf[b * batchLanes + lane]);
        }
    }
    for (const ContactIndex index : candidates) {
        ++world.bodies.record[world.contacts.contacts[index].bodyA].doubtful;
        ++world.bodies.record[world.contacts.contacts[index].bodyB].doubtful;
    }
    return candidates;
}

/// Leaves the solver what does not pass; and what hangs on a body of the solver's is the solver's too.
template <class Test>
void keepOnly(WorldState& world, std::vector<ContactIndex>& candidates, Test&& test) {
    for (bool changed = true; changed;) {
        const std::size_t removed = std::erase_if(candidates, [&](ContactIndex index) {
            const ContactRecord& contact = world.contacts.contacts[index];
            if (!isConstrained(world, contact) && test(contact)) return false;
            --world.bodies.record[contact.bodyA].doubtful;
            --world.bodies.record[contact.bodyB].doubtful;
            return true;
        });
        changed = removed > 0;
    }
}

/// What a bouncing body may come to in the rest of the step, after an impact, is watched as well.
void addWatched(WorldState& world, std::vector<ContactIndex>& candidates) {
    const std::size_t count = candidates.size();
    for (std::size_t i = 0; i < count; ++i) world.contacts.contacts[candidates[i]].isolated = true;
    for (std::size_t i = 0; i < count; ++i) {
        const ContactRecord& candidate = world.contacts.contacts[candidates[i]];
        for (const BodyIndex body : {candidate.bodyA, candidate.bodyB}) {
            if (!world.bodies.isDynamic(body)) continue;
            forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
                ContactRecord& contact = world.contacts.contacts[index];
                const bool free =
                    bodiesReady(world, contact) && !isConstrained(world, contact) && !letsPass(contact.verdict);
                if (contact.isolated || !free) return;
                contact.isolated = true;
                candidates.push_back(index);
            });
        }
    }
}

/// Splits the candidates into groups that share no body that can be pushed; in the order of their first contact.
std::vector<std::vector<ContactIndex>> groupsOf(const WorldState& world, const std::vector<ContactIndex>& candidates) {
    std::map<BodyIndex, std::size_t> groupOf;
    std::vector<std::vector<ContactIndex>> groups;
    for (const ContactIndex index : candidates) {
        const ContactRecord& contact = world.contacts.contacts[index];
        const std::size_t fresh = groups.size();
        groups.push_back({index});
        for (const BodyIndex body : {contact.bodyA, contact.bodyB}) {
            if (!world.bodies.isDynamic(body)) continue;
            const auto [known, isNew] = groupOf.try_emplace(body, fresh);
            const std::size_t old = known->second;
            if (isNew || old == fresh) continue;
            groups[fresh].insert(groups[fresh].end(), groups[old].begin(), groups[old].end());
            groups[old].clear();
            for (auto& [member, group] : groupOf)
                if (group == old) group = fresh;
        }
    }
    return groups;
}

/// The impacts have moved its bodies: the solver has nothing to do with it in this step.
void leaveToImpacts(WorldState& world, ContactIndex index) {
    ContactRecord& contact = world.contacts.contacts[index];
    const std::array<PointMemory, 2> told = contact.memory;
    world.graph.remove(world.bodies, world.contacts, index);
    world.contacts.addNear(index);
    contact.memory = told;
    contact.rollImpulse = 0;
}

void flyGroup(WorldState& world, std::span<const ContactIndex> group, double dt) {
    for (const ContactIndex index : group) world.contacts.contacts[index].memory = {};
    const bool flown = flyThroughImpacts(world, group, dt);
    for (const ContactIndex index : group) {
        if (flown)
            leaveToImpacts(world, index);
        else
            world.contacts.contacts[index].isolated = false;
    }
}

}  // namespace

void sortOutContacts(WorldState& world, double dt) {
    for (const ContactIndex index : world.isolated) world.contacts.contacts[index].isolated = false;
    world.isolated.clear();
    std::vector<ContactIndex> candidates = findCandidates(world);
    if (candidates.empty()) return;
    const std::vector<ContactIndex> doubtful = candidates;
    keepOnly(world, candidates, [](const ContactRecord&) { return true; });
    keepOnly(world, candidates, [&](const ContactRecord& contact) { return bouncesClear(world, contact, dt); });
    addWatched(world, candidates);
    world.isolated = candidates;
    for (const std::vector<ContactIndex>& group : groupsOf(world, candidates))
        if (!group.empty()) flyGroup(world, group, dt);
    for (const ContactIndex index : doubtful) {
        world.bodies.record[world.contacts.contacts[index].bodyA].doubtful = 0;
        world.bodies.record[world.contacts.contacts[index].bodyB].doubtful = 0;
    }
}

}  // namespace plumb
