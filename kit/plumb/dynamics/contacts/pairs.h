// SPDX-License-Identifier: MIT
// Which pairs of shapes become contacts?
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/impact/impact.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// What kind of pair two shapes are.
enum class PairKind {
    Nothing,    ///< no contact: joints forbid it, or neither body is dynamic
    Contact,    ///< a contact was added
    AtSleeper,  ///< a contact of a sleeping and a non-dynamic body was added: the caller must wake both
    AtSensor,   ///< no contact: one shape is a sensor, the caller passes the pair to the sensors
};

/// The pair with the lower id first. shift: of b [m].
ShiftedShapes inOrder(ProxyId a, ProxyId b, const Vec2& shift);
/// May the shapes touch: is none of them a sensor, is a body dynamic, and do no joints forbid it?
bool mayTouch(const BodyStore& bodies, const Space& space, const ShiftedShapes& pair);
/// The contact of a pair that has a dynamic body, or none.
ContactIndex findContact(const ContactStore& contacts, const BodyStore& bodies, const Space& space,
                         const ShiftedShapes& pair);
/// Adds a contact for a pair of shapes that may touch. It is near if one of the bodies is awake.
ContactIndex addContact(ContactStore& contacts, BodyStore& bodies, const Space& space, const ShiftedShapes& pair);
/// The same for two that come to meet in this step: the next search will not add them again.
ContactIndex addEarlyContact(ContactStore& contacts, BodyStore& bodies, const Space& space, const ShiftedShapes& pair);
/// Adds a contact for a pair of shapes, if the pair can have one.
PairKind addPair(ContactStore& contacts, BodyStore& bodies, const Space& space, const ShiftedShapes& pair);
/// The pairs of two bodies' shapes whose bounds overlapped in the last search for pairs; without sensors.
std::vector<ShiftedShapes> pairsOfBodies(const BodyStore& bodies, const Space& space, BodyIndex a, BodyIndex b);
/// The pairs of one shape whose bounds overlapped in the last search; without those that are contacts already.
std::vector<ShiftedShapes> pairsOfShape(const ContactStore& contacts, const BodyStore& bodies, const Space& space,
                                        ProxyId proxy);
/// Sets the contact's friction, restitution, rolling resistance and surface speed from its two materials.
void mixMaterials(const Space& space, ContactRecord& contact);

/// The law of impacts of a contact with its materials mixed.
inline ImpactLaw impactLawOf(const ContactRecord& contact) {
    return {contact.restitution, contact.friction, static_cast<double>(contact.surfaceSpeed)};
}

}  // namespace plumb
