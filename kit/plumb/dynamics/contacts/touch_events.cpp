// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/touch_events.h>

#include <algorithm>
#include <utility>

namespace plumb {

namespace {

constexpr float apart = 1e-3f;  ///< jitter smaller than this does not end a touch [m]

struct TouchNow {
    bool pressed = false;
    float separation = apart;
    std::size_t point = 0;  ///< index of the nearest point
};

/// The sum of a point's normal impulses tells whether the shapes have pressed in the step: a body that bounces is apart
/// again at its end.
TouchNow touchOf(const ContactGraph& graph, const ContactRecord& contact) {
    TouchNow touch;
    const auto memory = graph.memoryOf(contact);
    const std::size_t count = static_cast<std::size_t>(graph.manifoldOf(contact).count);
    for (std::size_t p = 0; p < count; ++p) {
        touch.pressed = touch.pressed || memory[p].totalNormal > 0;
        const float separation = graph.separationOf(contact, p);
        if (separation >= touch.separation) continue;
        touch.separation = separation;
        touch.point = p;
    }
    return touch;
}

/// Sets changed to a value other than 0 in the lanes in which a touch begins or ends, or is a hit. There are no
/// branches, so that compilers can vectorize the loop: nearly all contacts of a heap have no event, and must not cost a
/// look at their records.
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

/// Checks the contacts one after the other and collects their events.
class TouchSearch {
public:
    TouchSearch(ContactGraph& graph, ContactStore& contacts, const BodyStore& bodies, double hitSpeed)
        : graph_(graph), contacts_(contacts), bodies_(bodies), hitSpeed_(hitSpeed) {}

    void searchBatch(Colour& colour, std::size_t b) {
        const std::size_t first = b * batchLanes;
        const std::size_t count = std::min<std::size_t>(batchLanes, colour.contactOf.size() - first);
        Lanes<std::int32_t> changed;
        markChanges(colour.batches[b], colour.manifolds[b], static_cast<float>(hitSpeed_), changed);
        for (std::size_t lane = 0; lane < count; ++lane) {
            if (changed[lane] == 0) continue;
            ContactRecord& contact = contacts_[colour.contactOf[first + lane]];
            contact.approachSpeed = colour.manifolds[b].approachSpeed[lane];
            search(contact);
            colour.manifolds[b].touching[lane] = contact.touching ? 1 : 0;
        }
    }

    /// Checks a contact that is not in the solver; false if it can have no more events.
    bool searchWatched(ContactIndex index) {
        ContactRecord& contact = contacts_[index];
        // The impacts have reported the contact already.
        const bool reported = contact.state == ContactState::Impact && contact.memory[0].totalNormal > 0;
        if (contact.isNear() && !reported) search(contact);
        contact.watched = contact.isNear() && (contact.touching || contact.manifold.count > 0);
        return contact.watched;
    }

    TouchEvents events;

private:
    /// Two bounds in place of one: a touch begins at 0 and ends at apart. With a single one, what jitters on the
    /// ground would begin and end in every other step.
    void search(ContactRecord& contact) {
        const TouchNow touch = touchOf(graph_, contact);
        if (contact.isSolved() && touch.pressed && static_cast<double>(contact.approachSpeed) > hitSpeed_)
            events.hits.push_back(beginOf(contact, touch.point));
        if (!contact.touching && (touch.pressed || touch.separation <= 0)) {
            contact.touching = true;
            events.begins.push_back(beginOf(contact, touch.point));
        } else if (contact.touching && !touch.pressed && touch.separation >= apart) {
            contact.touching = false;
            events.ends.push_back({contact.proxyA, contact.proxyB});
        }
    }

    ShapeTouch beginOf(const ContactRecord& contact, std::size_t point) const {
        return {contact.proxyA,
                contact.proxyB,
                contact.shift,
                pointOf(graph_, bodies_, contact, point),
                normalOf(graph_, bodies_, contact),
                std::max(static_cast<double>(contact.approachSpeed), 0.0)};
    }

    ContactGraph& graph_;
    ContactStore& contacts_;
    const BodyStore& bodies_;
    double hitSpeed_;
};

}  // namespace

/// O(contacts in the solver) in vectors, and O(watched contacts). Called after the bodies have moved: the solver's
/// separations are those at the step's end.
TouchEvents findTouchEvents(ContactGraph& graph, ContactStore& contacts, const BodyStore& bodies, double hitSpeed) {
    TouchSearch search(graph, contacts, bodies, hitSpeed);
    for (Colour& colour : graph.colours)
        for (std::size_t b = 0; b < colour.batches.size(); ++b) search.searchBatch(colour, b);
    std::erase_if(contacts.watched, [&search](ContactIndex index) { return !search.searchWatched(index); });
    return std::move(search.events);
}

}  // namespace plumb
