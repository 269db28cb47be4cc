// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/machine_contacts.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/joints/joint_islands.h>

namespace plumb {

namespace {

/// The answers of all machines are at most this many velocities, and the machines at most so many. More, such as a heap
/// of dolls, would take too long: they are solved in turn with their contacts.
constexpr std::size_t mostAnswers = 50000, mostMachines = 8;
constexpr std::size_t rowsPerContact = 4;
/// A machine with more contacts than this is rather a vessel or a stirrer than something that stands on them; its
/// contacts are solved with all others, which takes less time.
constexpr std::size_t mostContacts = 16, contactsPerBody = 6;

ContactBatch& batchOf(ContactGraph& graph, const ContactRecord& contact) {
    return graph.colours[contact.colour].batches[contact.slot / batchLanes];
}

bool hasPoint(const ContactGraph& graph, const ContactRecord& contact) {
    const ContactBatch& batch = graph.colours[contact.colour].batches[contact.slot / batchLanes];
    const std::size_t lane = contact.slot % batchLanes;
    return batch.points[0].normalMass[lane] > 0 || batch.points[1].normalMass[lane] > 0;
}

/// Calls visit(contact) for the contacts of an island's bodies that touch, once or, inside of the island, twice.
template <class Visit>
void forEachTouch(const ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                  const JointIsland& island, Visit&& visit) {
    for (const BodyIndex body : island.bodies) {
        if (bodies.links[body].solverContacts == 0) continue;
        forEachContact(bodies, contacts, body, [&](ContactIndex index) {
            if (contacts[index].isSolved() && hasPoint(graph, contacts[index])) visit(index, body);
        });
    }
}

class Taking {
public:
    Taking(const ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies)
        : graph_(graph), contacts_(contacts), bodies_(bodies) {}

    MachineContacts take(JointIslands& islands) {
        for (JointIsland& island : islands.islands) island.trial.wanted = !island.isSwept() && isAffordable(island);
        if (machines_ > mostMachines)
            for (JointIsland& island : islands.islands) island.trial.wanted = false;
        for (JointIsland& island : islands.islands)
            if (island.trial.wanted) addPart(island);
        for (const JointIsland& island : islands.islands)
            if (island.trial.wanted) addContacts(island);
        return std::move(found_);
    }

private:
    bool isAffordable(const JointIsland& island) {
        const std::size_t most = mostContacts + contactsPerBody * island.bodies.size();
        std::size_t touches = 0;
        for (const BodyIndex body : island.bodies) touches += bodies_.links[body].solverContacts;
        if (touches == 0 || touches > most) return false;
        touches = 0;
        forEachTouch(graph_, contacts_, bodies_, island, [&](ContactIndex, BodyIndex) { ++touches; });
        const std::size_t answers = touches * rowsPerContact * island.bodies.size();
        if (touches == 0 || answers_ + answers > mostAnswers) return false;
        answers_ += answers;
        ++machines_;
        return true;
    }

    void addPart(JointIsland& island) {
        for (std::size_t node = 0; node < island.bodies.size(); ++node)
            sides_[island.bodies[node]] = {static_cast<std::uint32_t>(found_.parts.size()),
                                           static_cast<std::uint32_t>(node)};
        found_.parts.push_back({&island, noBody});
    }

    void addContacts(const JointIsland& island) {
        forEachTouch(graph_, contacts_, bodies_, island, [&](ContactIndex index, BodyIndex body) {
            const ContactRecord& contact = contacts_[index];
            if (contact.bodyB == body && isOfMachine(contact.bodyA)) return;  // found at the other body
            MachineContact& taken = found_.contacts.emplace_back();
            taken.contact = index;
            taken.a = sideOf(contact.bodyA);
            taken.b = sideOf(contact.bodyB);
        });
    }

    bool isOfMachine(BodyIndex body) const {
        const auto side = sides_.find(body);
        return side != sides_.end() && found_.parts[side->second.part].island != nullptr;
    }

    MachineContact::Side sideOf(BodyIndex body) {
        if (!bodies_.canMove(body)) return {};
        const auto [side, isNew] =
            sides_.try_emplace(body, MachineContact::Side{static_cast<std::uint32_t>(found_.parts.size()), 0});
        if (isNew) found_.parts.push_back({nullptr, body});
        return side->second;
    }

    const ContactGraph& graph_;
    const ContactStore& contacts_;
    const BodyStore& bodies_;
    MachineContacts found_;
    std::map<BodyIndex, MachineContact::Side> sides_;
    std::size_t answers_ = 0, machines_ = 0;
};

}  // namespace

MachineContacts takeMachineContacts(const ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                    JointIslands& islands) {
    return Taking(graph, contacts, bodies).take(islands);
}

void hideMachineContacts(ContactGraph& graph, const ContactStore& contacts, MachineContacts& machines) {
    for (MachineContact& hidden : machines.contacts) {
        const ContactRecord& contact = contacts[hidden.contact];
        ContactBatch& batch = batchOf(graph, contact);
        const std::size_t lane = contact.slot % batchLanes;
        const auto hide = [lane](float& kept, Lanes<float>& lanes) {
            kept = lanes[lane];
            lanes[lane] = 0;
        };
        for (std::size_t p = 0; p < 2; ++p) {
            PointLanes& point = batch.points[p];
            hide(hidden.normal[p], point.normalImpulse);
            hide(hidden.tangent[p], point.tangentImpulse);
            hide(hidden.normalMass[p], point.normalMass);
            hide(hidden.tangentMass[p], point.tangentMass);
        }
        hide(hidden.roll, batch.rollImpulse);
        hide(hidden.rollMass, batch.rollMass);
    }
}

}  // namespace plumb
