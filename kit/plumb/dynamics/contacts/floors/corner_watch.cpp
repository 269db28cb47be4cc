// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/floors/corner_watch.h>

#include <algorithm>

#include <plumb/dynamics/contacts/floors/flush_faces.h>

namespace plumb {

namespace {

/// A bit of KeptLanes.open beside floorA and floorB: the contact has been noted since it was collided.
constexpr std::int32_t seen = 4;

}  // namespace

CornerWatch::CornerWatch(const ContactStore& contacts, const BodyStore& bodies, const Space& space, double dt)
    : contacts_(contacts), bodies_(bodies), space_(space), dt_(dt) {}

void CornerWatch::note(const PairBatch& batch, KeptLanes* kept, const FreshLanes& fresh) {
    if (kept == nullptr && !someAtCorner(fresh, batch.count)) return;
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
        const BodyIndex a = batch.pairs.bodyA[lane], b = batch.pairs.bodyB[lane];
        const bool corner = isAtCorner(fresh, lane);
        std::int32_t* open = kept != nullptr && isKept(*kept, lane) ? &kept->open[lane] : nullptr;
        const bool moves = kept != nullptr && (open == nullptr || *open == 0);
        if (moves && !hasDisc(batch.pairs, lane) && mayCover(a, b, corner)) mark(a, b);
        if (open != nullptr && *open == 0) *open = seen;
        if (!corner) continue;
        const int sides = floorSides(bodies_, a, b, dt_);
        if (sides == 0) continue;
        // A fixed body's other contacts do not matter (see flush_faces.h).
        const auto loose = [this](BodyIndex body) { return bodies_.velocity[body].inverseMass > 0 ? body : noBody; };
        noted_.push_back({batch.contacts[lane], loose(a), loose(b), sides, open});
    }
}

/// What covers a loose body's face lies along it. What covers a fixed one's touches the body that slides, at any place.
bool CornerWatch::mayCover(BodyIndex a, BodyIndex b, bool atCorner) const {
    return !atCorner || bodies_.velocity[a].inverseMass == 0 || bodies_.velocity[b].inverseMass == 0;
}

void CornerWatch::mark(BodyIndex a, BodyIndex b) {
    if (moved_.empty()) moved_.resize(bodies_.record.size());
    moved_[a] = moved_[b] = 1;
}

void CornerWatch::markMoved(const ContactRecord& contact) {
    mark(contact.bodyA, contact.bodyB);
}

/// The manifolds of boxes are not kept: it is not known whether they moved.
void CornerWatch::markBoxes(const ContactGraph& graph) {
    for (std::size_t index = 0; index < graph.colours.size(); ++index)
        if (isOfBoxes(index))
            for (const ContactIndex contact : graph.colours[index].contactOf) markMoved(contacts_[contact]);
}

bool CornerWatch::hasMoved(const Noted& noted) const {
    return !moved_.empty() && (moved_[noted.a] != 0 || moved_[noted.b] != 0);
}

bool CornerWatch::isCovered(ContactIndex index, const Manifold& manifold) const {
    const ContactRecord& contact = contacts_[index];
    const int sides = floorSides(bodies_, contact.bodyA, contact.bodyB, dt_);
    return sides != 0 && isAtCoveredFace(contacts_, bodies_, space_, index, manifold, sides);
}

void CornerWatch::findCovered(const ContactGraph& graph, std::vector<ContactIndex>& covered) {
    const bool someKept = std::any_of(noted_.begin(), noted_.end(), [](const Noted& n) { return n.open != nullptr; });
    if (someKept) markBoxes(graph);
    for (const ContactIndex index : contacts_.withVerdict) markMoved(contacts_[index]);
    if (!moved_.empty()) moved_[noBody] = 0;
    for (const Noted& noted : noted_) {
        int sides = noted.sides;
        if (noted.open != nullptr) {
            if (hasMoved(noted)) *noted.open = seen;
            sides &= ~*noted.open;
            *noted.open |= sides;
        }
        if (sides != 0 && isAtCoveredFace(contacts_, bodies_, space_, noted.contact,
                                          graph.manifoldOf(contacts_[noted.contact]), sides))
            covered.push_back(noted.contact);
    }
}

}  // namespace plumb
