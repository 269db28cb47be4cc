// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/floors/corner_watch.h>

#include <plumb/dynamics/contacts/contact_lane.h>
#include <plumb/dynamics/contacts/floors/flush_faces.h>

namespace plumb {

CornerWatch::CornerWatch(const ContactStore& contacts, const BodyStore& bodies, const Space& space, double dt)
    : contacts_(contacts), bodies_(bodies), space_(space), dt_(dt) {}

void CornerWatch::note(const PairBatch& batch, const ContactBatch& prepared, KeptLanes* kept, const FreshLanes& fresh) {
    if (!someAtCorner(fresh, batch.count)) return;
    for (std::size_t lane = 0; lane < batch.count; ++lane) {
        if (!isAtCorner(fresh, lane)) continue;
        const BodyIndex a = batch.pairs.bodyA[lane], b = batch.pairs.bodyB[lane];
        const int sides = floorSides(bodies_, a, b, dt_);
        const bool stays = kept != nullptr && isKept(*kept, lane);
        if (stays) kept->open[lane] &= sides | seenBit;
        if (sides == 0) continue;
        const Vec2f normal(prepared.normalX[lane], prepared.normalY[lane]);
        noted_.push_back(
            {batch.contacts[lane], a, b, sides, normal, manifoldAt(fresh, lane), stays ? kept : nullptr, lane});
    }
}

/// An arrival has no slot yet, so gather does not see it. Without it, the step in which a box is laid against another
/// would not know the floor. Only faces that lie on each other, with two points, cover something.
void CornerWatch::noteArrival(ContactIndex index, const FreshLanes& fresh, std::size_t lane) {
    if (fresh.count[lane] < 2) return;
    const ContactRecord& contact = contacts_[index];
    const BodyPlace& a = bodies_.place[contact.bodyA];
    const float x = fresh.normalX[lane], y = fresh.normalY[lane];
    arrivals_.push_back({contact.bodyA, contact.bodyB, {a.cos * x - a.sin * y, a.sin * x + a.cos * y}});
}

bool CornerWatch::isCovered(ContactIndex index, const Manifold& manifold) const {
    const ContactRecord& contact = contacts_[index];
    const int sides = floorSides(bodies_, contact.bodyA, contact.bodyB, dt_);
    return sides != 0 && isAtCoveredFace(contacts_, bodies_, space_, index, manifold, sides);
}

CornerFaces CornerWatch::facesOf(const Noted& noted) const {
    if (noted.kept == nullptr) return facesAt(contacts_, bodies_, space_, noted.contact, noted.manifold);
    CornerFaces& faces = noted.kept->faces[noted.lane];
    if (isUnknown(faces)) faces = facesAt(contacts_, bodies_, space_, noted.contact, noted.manifold);
    return faces;
}

/// On which bodies may the faces be covered, for all that is known? The cheap questions come first: does anything new
/// lie along the body, then along these faces; only what is left is searched for shapes.
int CornerWatch::sidesToAsk(const Noted& noted) const {
    const int open = noted.kept == nullptr ? 0 : noted.kept->open[noted.lane];
    const int sides = noted.sides & ((flush_.any(noted.a, (open & floorA) != 0) ? floorA : 0) |
                                     (flush_.any(noted.b, (open & floorB) != 0) ? floorB : 0));
    if (sides == 0) return 0;
    const CornerFaces faces = facesOf(noted);
    const bool onA = flush_.mayLieAlong(noted.a, noted.normal, faces.ofA, (open & floorA) != 0);
    const bool onB = flush_.mayLieAlong(noted.b, noted.normal, faces.ofB, (open & floorB) != 0);
    return sides & ((onA ? floorA : 0) | (onB ? floorB : 0));
}

bool CornerWatch::isCovered(const Noted& noted) const {
    const int sides = sidesToAsk(noted);
    if (noted.kept != nullptr) noted.kept->open[noted.lane] |= noted.sides;
    return sides != 0 && isAtCoveredFace(contacts_, bodies_, space_, noted.contact, noted.manifold, sides);
}

void CornerWatch::findCovered(ContactGraph& graph, StepList<ContactIndex>& covered) {
    if (noted_.empty()) return;
    flush_.gather(graph, bodies_);
    for (const Arrival& arrival : arrivals_) flush_.add(arrival.a, arrival.b, arrival.normal, true);
    for (const Noted& noted : noted_)
        if (isCovered(noted)) covered.push_back(noted.contact);
}

}  // namespace plumb
