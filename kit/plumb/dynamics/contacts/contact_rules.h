// SPDX-License-Identifier: MIT
// May two shapes touch that have a rule or a one-way side?
//
// A rule is asked when the two come near, and its answer holds until they have parted. A one-way side is looked at
// anew in each step, for it is passed through while the two are near: solid is what comes from within 60 degrees of
// its direction and does not overlap yet, and at the end of a line comes down onto it, within 30 degrees; what was
// solid stays so, however deep a load presses it, until it has slid off to the side or below.
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/space/space.h>

namespace plumb {

/// How two shapes come to meet.
struct Face {
    Vec2 normal{0, 1};      ///< from A to B, in the world [-]
    Vec2 velocity{0, 0};    ///< of B against A, where they meet [m/s]
    double separation = 0;  ///< negative when they overlap [m]
};
/// Of a manifold with a point, where the bodies are now.
Face faceOf(const BodyStore& bodies, const ContactRecord& contact, const Manifold& manifold);

bool hasRule(const ShapeDef& shape);
/// What both shapes' rules say, and whether one comes from the open side of the other.
bool rulesAdmit(const BodyStore& bodies, const Proxy& a, const Proxy& b, const Face& face);
bool comesFromOpenSide(const BodyStore& bodies, const Proxy& a, const Proxy& b, const Face& face, bool wasSolid);

/// Finds the verdict on a contact, and says whether the two may touch.
bool isSolid(ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex contact,
             const Face& face);
/// Looks again at the contacts that the solver has: those that are let through by now.
std::vector<ContactIndex> findLetThrough(ContactStore& contacts, const ContactGraph& graph, const BodyStore& bodies,
                                         const Space& space);
/// Contacts that have parted in this step have no verdict any more.
void dropVerdicts(ContactStore& contacts, const ContactGraph& graph);

}  // namespace plumb
