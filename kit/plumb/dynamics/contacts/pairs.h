// SPDX-License-Identifier: MIT
// Which shapes have come near each other?
#pragma once
#include <vector>

#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/space/space.h>

namespace plumb {

/// Two shapes whose bounds have come to overlap, b shifted by whole rounds of the world.
struct ShiftedShapes {
    Pair shapes;
    Vec2 shift{0, 0};  ///< [m]
};

/// What a pair is, and what follows from it.
enum class PairKind {
    Nothing,    ///< kept apart, or neither can be pushed
    Contact,    ///< has been added to the contacts
    AtSleeper,  ///< the same, between a sleeper and what nothing pushes: something was put there, and both are to wake
    AtSensor,   ///< one is a sensor: for whoever watches sensors
};

/// Makes a contact of a pair, if it is to be one.
PairKind addPair(ContactStore& contacts, BodyStore& bodies, const Space& space, const ShiftedShapes& pair);
/// The pairs of two bodies' shapes whose bounds overlapped at the last look for pairs; without sensors.
std::vector<ShiftedShapes> pairsOfBodies(const BodyStore& bodies, const Space& space, BodyIndex a, BodyIndex b);
/// The pairs of one shape, likewise; without those that are contacts.
std::vector<ShiftedShapes> pairsOfShape(const ContactStore& contacts, const BodyStore& bodies, const Space& space,
                                        ProxyId proxy);
/// Works out what two shapes' materials are together.
void mixMaterials(const Space& space, ContactRecord& contact);

}  // namespace plumb
