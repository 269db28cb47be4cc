// SPDX-License-Identifier: MIT
#include <plumb/dynamics/edit/edits.h>

#include <plumb/dynamics/fields/field_scope.h>
#include <plumb/dynamics/islands/sleep.h>
#include <plumb/dynamics/islands/wake.h>
#include <plumb/dynamics/sensors/sensors.h>

namespace plumb {

void wakeIsland(WorldState& world, BodyIndex body) {
    wakeIsland(world.bodies, world.contacts, world.joints, body);
}

void wakeNeighbours(WorldState& world, BodyIndex body) {
    wakeNeighbours(world.bodies, world.contacts, world.joints, body);
}

void sleepIsland(WorldState& world, BodyIndex body) {
    sleepIsland({world.bodies, world.graph, world.contacts, world.joints, world.space}, body);
}

/// The end event is added here, because ids of its shapes may be gone when the next step reports it.
void removeContact(WorldState& world, ContactIndex index) {
    const ContactRecord& contact = world.contacts[index];
    if (contact.touching)
        world.events.ends.push_back({world.idOfShape(contact.proxyA), world.idOfShape(contact.proxyB)});
    removeContact(world.graph, world.contacts, world.bodies, index);
}

void renewContact(WorldState& world, ContactIndex contact) {
    renewContact(world.graph, world.contacts, world.bodies, contact);
}

/// For pairs from the broad phase and from edits. What a call has put into a sleeping body must wake it
/// (PairKind::AtSleeper).
void addPair(WorldState& world, const ShiftedShapes& pair) {
    const PairKind kind = addPair(world.contacts, world.bodies, world.space, pair);
    if (kind == PairKind::AtSensor) addSensorPair(world.sensors, world.space, pair.shapes, pair.shift);
    if (kind != PairKind::AtSleeper) return;
    wakeIsland(world, world.space[pair.shapes.a].owner);
    wakeIsland(world, world.space[pair.shapes.b].owner);
}

void addPairs(WorldState& world, std::span<const ShiftedShapes> pairs) {
    for (const ShiftedShapes& pair : pairs) {
        for (const ProxyId proxy : {pair.shapes.a, pair.shapes.b}) world.bodies.notePlaced(world.space[proxy].owner);
        addPair(world, pair);
    }
}

/// The body that carries a magnet is drawn by what it draws, so it wakes, too.
void wakeInfluenced(WorldState& world, const FieldRecord& field) {
    const FieldStores view{world.fields, world.bodies, world.space};
    StepList<BodyIndex> influenced = view.fields.solver->influencedBy(view, field);
    if (const auto* magnet = std::get_if<Magnet>(&field.def.law))
        if (isCarried(*magnet, view)) influenced.push_back(magnet->body.index);
    for (const BodyIndex body : influenced) wakeIsland(world, body);
}

void wakeInfluencedByMagnetsOn(WorldState& world, BodyIndex body) {
    for (const FieldRecord& field : world.fields.records)
        if (field.alive && isCarriedBy(field.def.law, body)) wakeInfluenced(world, field);
}

}  // namespace plumb
