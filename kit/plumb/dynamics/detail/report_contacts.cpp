// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/report_contacts.h>

#include <algorithm>

namespace plumb {

namespace {

constexpr float apart = 1e-3f;  ///< what trembles this little does not end its touch [m]

struct Touch {
    bool pressed = false;
    float separation = apart;
    std::size_t point = 0;  ///< the nearest
};

Touch touchOf(const WorldState& world, const ContactRecord& contact) {
    Touch touch;
    const auto memory = world.graph.memoryOf(contact);
    for (std::size_t p = 0; p < static_cast<std::size_t>(contact.manifold.count); ++p) {
        touch.pressed = touch.pressed || memory[p].totalNormal > 0;
        const float separation = world.graph.separationOf(contact, p);
        if (separation >= touch.separation) continue;
        touch.separation = separation;
        touch.point = p;
    }
    return touch;
}

ContactBegin beginOf(const WorldState& world, const ContactRecord& contact, std::size_t point) {
    return {world.idOf(contact.bodyA), world.idOf(contact.bodyB), pointOf(world, contact, point),
            normalOf(world, contact), std::max(contact.approachSpeed, 0.0)};
}

}  // namespace

void reportContacts(WorldState& world) {
    for (const ContactIndex index : world.contacts.active) {
        ContactRecord& contact = world.contacts.contacts[index];
        if (contact.isolated && contact.memory[0].totalNormal > 0) continue;  // the impacts have told
        const Touch touch = touchOf(world, contact);
        if (!contact.touching && (touch.pressed || touch.separation <= 0)) {
            contact.touching = true;
            world.begins.push_back(beginOf(world, contact, touch.point));
        } else if (contact.touching && !touch.pressed && touch.separation >= apart) {
            contact.touching = false;
            world.ends.push_back({world.idOf(contact.bodyA), world.idOf(contact.bodyB)});
        }
    }
}

}  // namespace plumb
