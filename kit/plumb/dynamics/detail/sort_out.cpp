// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/sort_out.h>

#include <algorithm>
#include <map>

#include <plumb/dynamics/detail/impacts.h>

namespace plumb {

namespace {

void constrain(WorldState& world, BodyIndex body) {
    if (world.bodies.isDynamic(body)) world.bodies.record[body].constrained = true;
}

bool isConstrained(const WorldState& world, const ContactRecord& contact) {
    return world.bodies.record[contact.bodyA].constrained || world.bodies.record[contact.bodyB].constrained;
}

/// Can anything come of it in this step? Not with a sleeper: what might touch one has woken it.
bool bodiesReady(const WorldState& world, const ContactRecord& contact) {
    const auto ready = [&world](BodyIndex body) {
        return world.bodies.record[body].awake || !world.bodies.isDynamic(body);
    };
    return ready(contact.bodyA) && ready(contact.bodyB);
}

bool isAwake(const WorldState& world, const ContactRecord& contact) {
    return contact.manifold.count > 0 && bodiesReady(world, contact);
}

/// Joined bodies and those with a contact that does not bounce clear are the solver's.
std::vector<ContactIndex> findCandidates(WorldState& world, double dt) {
    for (const BodyIndex body : world.bodies.awake) {
        BodyRecord& record = world.bodies.record[body];
        record.constrained = record.type == BodyType::Dynamic && !record.joints.empty();
    }
    std::vector<ContactIndex> candidates;
    for (const ContactIndex index : world.contacts.active) {
        ContactRecord& contact = world.contacts.contacts[index];
        contact.isolated = isAwake(world, contact) && bouncesClear(world, contact, dt);
        if (contact.isolated) {
            candidates.push_back(index);
        } else if (isAwake(world, contact)) {
            constrain(world, contact.bodyA);
            constrain(world, contact.bodyB);
        }
    }
    return candidates;
}

void giveToSolver(WorldState& world, ContactRecord& contact) {
    contact.isolated = false;
    constrain(world, contact.bodyA);
    constrain(world, contact.bodyB);
}

/// What hangs on a body of the solver's is the solver's too.
void spreadConstraints(WorldState& world, std::vector<ContactIndex>& candidates) {
    for (bool changed = true; changed;) {
        changed = false;
        std::erase_if(candidates, [&](ContactIndex index) {
            ContactRecord& contact = world.contacts.contacts[index];
            if (!isConstrained(world, contact)) return false;
            giveToSolver(world, contact);
            changed = true;
            return true;
        });
    }
}

/// What a bouncing body may come to in the rest of the step, after an impact, is watched as well.
void addWatched(WorldState& world, std::vector<ContactIndex>& candidates) {
    const std::size_t count = candidates.size();
    for (std::size_t i = 0; i < count; ++i) {
        const ContactRecord& candidate = world.contacts.contacts[candidates[i]];
        for (const BodyIndex body : {candidate.bodyA, candidate.bodyB}) {
            if (!world.bodies.isDynamic(body)) continue;
            forEachContact(world.bodies, world.contacts, body, [&](ContactIndex index) {
                ContactRecord& contact = world.contacts.contacts[index];
                const bool free = bodiesReady(world, contact) && !isConstrained(world, contact);
                if (contact.isolated || contact.restitution == 0 || !free) return;
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

void updateGraph(WorldState& world) {
    for (const ContactIndex index : world.contacts.active) {
        ContactRecord& contact = world.contacts.contacts[index];
        const bool wanted = isAwake(world, contact) && !contact.isolated;
        if (wanted && contact.colour < 0) world.graph.add(world.bodies, world.contacts, index);
        if (!wanted && contact.colour >= 0) world.graph.remove(world.bodies, world.contacts, index);
    }
}

}  // namespace

void sortOutContacts(WorldState& world, double dt) {
    std::vector<ContactIndex> candidates = findCandidates(world, dt);
    spreadConstraints(world, candidates);
    addWatched(world, candidates);
    for (const std::vector<ContactIndex>& group : groupsOf(world, candidates)) {
        if (group.empty() || flyThroughImpacts(world, group, dt)) continue;
        for (const ContactIndex index : group) {
            ContactRecord& contact = world.contacts.contacts[index];
            contact.isolated = false;
            if (contact.manifold.count > 0) giveToSolver(world, contact);
        }
    }
    updateGraph(world);
}

}  // namespace plumb
