// SPDX-License-Identifier: MIT
// May two shapes touch that have a rule or a one-way side?
//
// A rule is evaluated once, when the two come near each other; its result holds until they have parted. A one-way side
// is checked in every step, because a shape passes through it while the two are near. The other shape finds it solid if
// the contact normal is within 60 degrees of the one-way direction and the two do not overlap yet; at the end of a line
// the shape must also move against that direction, within 30 degrees. A contact that was solid stays solid, however
// deep a load presses it, until its normal leaves the 60 degrees, at the side or below.
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/math/detail/step_list.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// How two shapes meet.
struct Face {
    Vec2 normal{0, 1};      ///< from A to B, in the world [-]
    Vec2 velocity{0, 0};    ///< of B relative to A, where they meet [m/s]
    double separation = 0;  ///< negative if they overlap [m]
};
/// The Face of a manifold with at least one point, at the bodies' present places.
Face faceOf(const BodyStore& bodies, const ContactRecord& contact, const Manifold& manifold);

/// Has the shape a rule or a one-way side?
bool hasRule(const ShapeDef& shape);
/// Do the rules of both shapes allow a contact?
bool rulesAdmit(const BodyStore& bodies, const Proxy& a, const Proxy& b, const Face& face);
/// Does each shape with a one-way side find the other on that side? wasSolid: the contact was solid before.
bool comesFromOpenSide(const BodyStore& bodies, const Proxy& a, const Proxy& b, const Face& face, bool wasSolid);

/// Updates the verdict of a contact, and returns whether its shapes may touch.
bool isSolid(ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex contact,
             const Face& face);
/// Checks the contacts in the solver again. Returns those whose shapes may pass through each other now.
StepList<ContactIndex> findLetThrough(ContactStore& contacts, const ContactGraph& graph, const BodyStore& bodies,
                                      const Space& space);
/// Resets the verdicts of contacts that have parted in this step.
void dropVerdicts(ContactStore& contacts, const ContactGraph& graph);

}  // namespace plumb
