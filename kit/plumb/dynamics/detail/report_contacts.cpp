// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/report_contacts.h>

#include <algorithm>
#include <vector>

namespace plumb {

namespace {

constexpr float apart = 1e-3f;  ///< what trembles this little does not end its touch [m]

struct TouchNow {
    bool pressed = false;
    float separation = apart;
    std::size_t point = 0;  ///< the nearest
};

TouchNow touchOf(const WorldState& world, const ContactRecord& contact) {
    TouchNow touch;
    const auto memory = world.graph.memoryOf(contact);
    const std::size_t count = static_cast<std::size_t>(world.graph.manifoldOf(contact).count);
    for (std::size_t p = 0; p < count; ++p) {
        touch.pressed = touch.pressed || memory[p].totalNormal > 0;
        const float separation = world.graph.separationOf(contact, p);
        if (separation >= touch.separation) continue;
        touch.separation = separation;
        touch.point = p;
    }
    return touch;
}

ContactBegin beginOf(const WorldState& world, const ContactRecord& contact, std::size_t point) {
    const Vec2 where = pointOf(world, contact, point), normal = normalOf(world, contact);
    return {world.idOfShape(contact.proxyA),
            world.idOfShape(contact.proxyB),
            world.def.wrap.place(where),
            normal,
            std::max(static_cast<double>(contact.approachSpeed), 0.0),
            tileTouched(world, contact, where, normal)};
}

/// Not 0 for the lanes in which a touch begins or ends, or is a hit. Without branches, so that compilers can make it
/// wide.
void markChanges(const ContactBatch& batch, const ManifoldLanes& manifolds, float hitSpeed,
                 Lanes<std::int32_t>& changed) {
    for (std::size_t lane = 0; lane < batchLanes; ++lane) {
        const std::int32_t count = manifolds.count[lane];
        const float first = count > 0 ? batch.points[0].separation[lane] : apart;
        const float second = count > 1 ? batch.points[1].separation[lane] : apart;
        const float nearest = first < second ? first : second;
        const std::int32_t pressed =
            (batch.points[0].totalNormal[lane] > 0 ? 1 : 0) | (batch.points[1].totalNormal[lane] > 0 ? 1 : 0);
        const std::int32_t begins = pressed | (nearest <= 0 ? 1 : 0);
        const std::int32_t ends = (1 - pressed) & (nearest >= apart ? 1 : 0);
        const std::int32_t hits = pressed & (manifolds.approachSpeed[lane] > hitSpeed ? 1 : 0);
        changed[lane] = (manifolds.touching[lane] != 0 ? ends : begins) | hits;
    }
}

void reportContact(WorldState& world, ContactRecord& contact) {
    const TouchNow touch = touchOf(world, contact);
    if (contact.colour >= 0 && touch.pressed && static_cast<double>(contact.approachSpeed) > world.def.hitSpeed)
        world.hits.push_back(hitOf(beginOf(world, contact, touch.point)));
    if (!contact.touching && (touch.pressed || touch.separation <= 0)) {
        contact.touching = true;
        world.begins.push_back(beginOf(world, contact, touch.point));
    } else if (contact.touching && !touch.pressed && touch.separation >= apart) {
        contact.touching = false;
        world.ends.push_back({world.idOfShape(contact.proxyA), world.idOfShape(contact.proxyB)});
    }
}

void reportBatch(WorldState& world, Colour& colour, std::size_t b) {
    const std::size_t first = b * batchLanes;
    const std::size_t count = std::min<std::size_t>(batchLanes, colour.contactOf.size() - first);
    Lanes<std::int32_t> changed;
    markChanges(colour.batches[b], colour.manifolds[b], static_cast<float>(world.def.hitSpeed), changed);
    for (std::size_t lane = 0; lane < count; ++lane) {
        if (changed[lane] == 0) continue;
        ContactRecord& contact = world.contacts.contacts[colour.contactOf[first + lane]];
        contact.approachSpeed = colour.manifolds[b].approachSpeed[lane];
        reportContact(world, contact);
        colour.manifolds[b].touching[lane] = contact.touching ? 1 : 0;
    }
}

/// Reports a contact that the solver does not have; false when there will be no more to report of it.
bool stillWatched(WorldState& world, ContactIndex index) {
    ContactRecord& contact = world.contacts.contacts[index];
    const bool near = contact.alive && contact.nearIndex != none;
    const bool told = contact.isolated && contact.memory[0].totalNormal > 0;  // by the impacts
    if (near && !told) reportContact(world, contact);
    contact.watched = near && (contact.touching || contact.manifold.count > 0);
    return contact.watched;
}

}  // namespace

void reportContacts(WorldState& world) {
    for (Colour& colour : world.graph.colours)
        for (std::size_t b = 0; b < colour.batches.size(); ++b) reportBatch(world, colour, b);
    std::erase_if(world.contacts.watched, [&world](ContactIndex index) { return !stillWatched(world, index); });
}

}  // namespace plumb
