// SPDX-License-Identifier: MIT
// Which bodies are connected with a body by a touching contact or a joint, and so are in the same island?
#pragma once
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/joints/joint_bodies.h>

namespace plumb {

/// Calls visit(other) for each dynamic body that touches this one or is joined to it; possibly more than once.
template <class Visit>
void forEachNeighbour(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints, BodyIndex body,
                      Visit&& visit) {
    forEachContact(bodies, contacts, body, [&](ContactIndex index) {
        const BodyIndex other = otherOf(contacts[index], body);
        if (contacts[index].touching && bodies.canMove(other)) visit(other);
    });
    for (const JointIndex joint : bodies.links[body].joints) {
        if (!joints[joint].acts()) continue;
        forEachBody(joints, joint, [&](BodyIndex other) {
            if (other != body && bodies.canMove(other)) visit(other);
        });
    }
}

}  // namespace plumb
