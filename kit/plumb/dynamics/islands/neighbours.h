// SPDX-License-Identifier: MIT
// Which bodies are connected with a body by a touching contact or a joint, and so are in the same island?
#pragma once
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

/// Is test(other) true for a dynamic body that touches this one or is joined to it? Asks no more of them after that;
/// may ask some more than once.
template <class Test>
bool anyNeighbour(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints, BodyIndex body,
                  Test&& test) {
    const bool touched = anyContact(bodies, contacts, body, [&](ContactIndex index) {
        const BodyIndex other = otherOf(contacts[index], body);
        return contacts[index].touching && bodies.canMove(other) && test(other);
    });
    if (touched) return true;
    bool found = false;
    for (const JointIndex joint : bodies.links[body].joints)
        if (joints[joint].acts())
            forEachBody(joints, joint, [&](BodyIndex other) {
                found = found || (other != body && bodies.canMove(other) && test(other));
            });
    return found;
}

/// Calls visit(other) for each of them.
template <class Visit>
void forEachNeighbour(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints, BodyIndex body,
                      Visit&& visit) {
    anyNeighbour(bodies, contacts, joints, body, [&](BodyIndex other) {
        visit(other);
        return false;
    });
}

}  // namespace plumb
