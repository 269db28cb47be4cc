// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/world_state.h>

#include <algorithm>

#include <plumb/dynamics/detail/fresh_lanes.h>
#include <plumb/dynamics/detail/quarantine.h>

namespace plumb {

void moveTo(WorldState& world, BodyIndex body, const BodyMotion& motion) {
    if (isSound(motion))
        world.bodies.motion[body] = motion;
    else
        quarantineLater(world, body);
}

Vec2 normalOf(const WorldState& world, const ContactRecord& contact) {
    return world.bodies.motion[contact.bodyA].rotation * Vec2(world.graph.manifoldOf(contact).normal.cast<double>());
}

Vec2 pointOf(const WorldState& world, const ContactRecord& contact, std::size_t point) {
    // The manifold is of the step's start, half way between the surfaces; but what was foreseen from farther off is
    // where the two were to meet, so on A's surface. That has gone with A, and B's is where the separation says.
    const Manifold m = world.graph.manifoldOf(contact);
    const ManifoldPoint& p = m.points[point];
    const float nearest = m.count == 2 ? std::min(m.points[0].separation, m.points[1].separation) : p.separation;
    const double begun = nearest > contactMargin ? 0 : static_cast<double>(p.separation);
    const BodyMotion& a = world.bodies.motion[contact.bodyA];
    const Vec2 told = a.center + a.rotation * Vec2(p.position.cast<double>());
    const double closed = static_cast<double>(world.graph.separationOf(contact, point)) - begun;
    return told + normalOf(world, contact) * (0.5 * closed);
}

void removeContact(WorldState& world, ContactIndex index) {
    const ContactRecord& contact = world.contacts.contacts[index];
    if (contact.touching) world.ends.push_back({world.idOfShape(contact.proxyA), world.idOfShape(contact.proxyB)});
    world.graph.remove(world.bodies, world.contacts, index);
    world.contacts.remove(world.bodies, index);
}

}  // namespace plumb
