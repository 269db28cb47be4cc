// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/floors/flush_sides.h>

#include <bit>
#include <cmath>

namespace plumb {

namespace {

/// Of the circle [-]: one for each bit of a word, so that what lies along a body is one number, and a question about it
/// one AND. Each is 5.6 degrees wide.
constexpr int sectors = 64;

/// The sector of a direction, without an arc tangent: the angle comes from the place on the square |x| + |y| = 1, and a
/// cubic correction, right to 0.2 degrees.
int sectorOf(float x, float y) {
    const float place = std::fabs(y) / (std::fabs(x) + std::fabs(y)) - 0.5f;  // from -1/2 to 1/2 in a quarter
    const float quarters = 0.5f + place * (1.25f - place * place);
    const float half = x < 0 ? 2 - quarters : quarters;
    return static_cast<int>((y < 0 ? 4 - half : half) * (sectors / 4)) % sectors;
}

std::uint64_t sideOf(int sector) {
    return std::rotl(std::uint64_t{1}, sector);
}

/// A sector and its neighbours: three roundings are in a sector that is known relative to a normal.
std::uint64_t sidesAbout(int sector) {
    return std::rotl(std::uint64_t{0b11111}, sector - 2);
}

/// A manifold that is used again has not moved since it was seen: what lay along a face then was asked about then.
bool wasSeen(KeptLanes& kept, std::size_t lane) {
    const bool was = isKept(kept, lane) && (kept.open[lane] & seenBit) != 0;
    kept.open[lane] |= seenBit;
    return was;
}

}  // namespace

std::uint8_t faceFrom(const Vec2f& normal, const Vec2f& face) {
    const int between = sectorOf(face.x(), face.y()) - sectorOf(normal.x(), normal.y());
    return static_cast<std::uint8_t>(1 + (between + sectors) % sectors);
}

/// O(contacts in the solver + bodies), once a step, and only in a step in which some contact at a corner was noted.
void FlushSides::gather(ContactGraph& graph, const BodyStore& bodies) {
    sides_.assign(bodies.record.size(), {});
    for (std::size_t index = 0; index < graph.colours.size(); ++index)
        addColour(graph.colours[index], !isOfBoxes(index));
    // What lies along a fixed body need not touch it, so no contact tells of it: all its sides count.
    constexpr std::uint64_t whole = ~std::uint64_t{0};
    for (std::size_t body = 0; body < sides_.size(); ++body)
        if (bodies.velocity[body].inverseMass == 0) sides_[body] = {whole, whole};
}

void FlushSides::addColour(Colour& colour, bool areKept) {
    for (std::size_t slot = 0; slot < colour.contactOf.size(); ++slot) {
        const std::size_t batch = slot / batchLanes, lane = slot % batchLanes;
        if (colour.manifolds[batch].count[lane] < 2) continue;
        const ContactBatch& contacts = colour.batches[batch];
        const bool moved = !areKept || !wasSeen(colour.kept[batch], lane);
        add(contacts.bodyA[lane], contacts.bodyB[lane], {contacts.normalX[lane], contacts.normalY[lane]}, moved);
    }
}

void FlushSides::add(BodyIndex a, BodyIndex b, const Vec2f& normal, bool moved) {
    const std::uint64_t onA = sideOf(sectorOf(normal.x(), normal.y()));
    // Seen from B, the other body lies in the opposite direction.
    const std::uint64_t onB = std::rotl(onA, sectors / 2);
    sides_[a].all |= onA;
    sides_[b].all |= onB;
    if (!moved) return;
    sides_[a].moved |= onA;
    sides_[b].moved |= onB;
}

bool FlushSides::mayLieAlong(BodyIndex body, const Vec2f& normal, const std::uint8_t (&faces)[2], bool onlyNew) const {
    const int from = sectorOf(normal.x(), normal.y()) - 1;
    std::uint64_t asked = 0;
    for (const std::uint8_t face : faces)
        if (face != 0) asked |= sidesAbout(from + face);
    return (of(body, onlyNew) & asked) != 0;
}

}  // namespace plumb
