// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/joint_contacts.h>

namespace plumb {

namespace {

ContactBatch& batchOf(ContactGraph& graph, const ContactRecord& contact) {
    return graph.colours[contact.colour].batches[contact.slot / batchLanes];
}

Vec2 normalOf(const ContactGraph& graph, const ContactRecord& contact) {
    const ContactBatch& batch = graph.colours[contact.colour].batches[contact.slot / batchLanes];
    const std::size_t lane = contact.slot % batchLanes;
    return {static_cast<double>(batch.normalX[lane]), static_cast<double>(batch.normalY[lane])};
}

}  // namespace

std::vector<JointedContact> findJointedContacts(JointIslands& islands, const ContactGraph& graph,
                                                const ContactStore& contacts, const BodyStore& bodies) {
    std::vector<JointedContact> found;
    for (const JointIsland& island : islands.islands) {
        if (island.isSwept() || !island.batch->mayChange(island.lane)) continue;
        for (std::size_t node = 0; node < island.bodies.size(); ++node)
            forEachContact(bodies, contacts, island.bodies[node], [&](ContactIndex index) {
                const ContactRecord& contact = contacts[index];
                if (!contact.isSolved()) return;
                found.push_back({island.batch, island.lane, index, {}});
                const double sign = contact.bodyB == island.bodies[node] ? 1 : -1;
                island.batch->addNormal(island.lane, node, sign * normalOf(graph, contact));
            });
    }
    return found;
}

void noteStart(std::vector<JointedContact>& jointed, const ContactGraph& graph, const ContactStore& contacts) {
    for (JointedContact& one : jointed) {
        const ContactRecord& contact = contacts[one.contact];
        one.start = givenBy(graph.colours[contact.colour].batches[contact.slot / batchLanes],
                            contact.slot % batchLanes);
    }
}

void takeBack(const std::vector<JointedContact>& jointed, ContactGraph& graph, const ContactStore& contacts,
              BodyStore& bodies) {
    for (const JointedContact& one : jointed) {
        if (!one.batch->hasChanged(one.lane)) continue;
        const ContactRecord& contact = contacts[one.contact];
        takeBackLane(batchOf(graph, contact), contact.slot % batchLanes, bodies.solverBodies(), one.start);
    }
}

void solveContactsAgain(const std::vector<JointedContact>& jointed, ContactGraph& graph, const ContactStore& contacts,
                        BodyStore& bodies, const HalfPass& pass) {
    const SolverBodies solverBodies = bodies.solverBodies();
    for (const JointedContact& one : jointed) {
        if (!one.batch->hasChanged(one.lane)) continue;
        const ContactRecord& contact = contacts[one.contact];
        const int colour = colourAt(contact.colour);
        const bool ground = colour >= fixedColour && colour != overflowColour;
        const ContactPass& with = ground ? pass.groundContacts : pass.contacts;
        ContactBatch& batch = batchOf(graph, contact);
        const std::size_t lane = contact.slot % batchLanes;
        if (pass.correct)
            solveLane(batch, lane, solverBodies, with);
        else
            relaxLane(batch, lane, solverBodies, with, one.start);
    }
}

}  // namespace plumb
