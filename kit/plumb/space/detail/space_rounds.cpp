// SPDX-License-Identifier: MIT
// Where do shapes stand in the hierarchies of a space that wraps? The part of Space that answers.
#include <algorithm>
#include <tuple>

#include <plumb/space/space.h>

namespace plumb {

namespace {

/// What goes so fast that its box reaches into more rounds than this along an axis is met in these alone [-].
constexpr double mostImages = 16;

}  // namespace

Aabb Space::imageBox(ProxyId id) const {
    return shifted(around::spare(placed_[rounds_[id].real].box), -wrap_.lengthOf(roundsOf(id)));
}

bool Space::isWhole(ProxyId id) const {
    if (!wrap_.any()) return true;
    const Aabb& box = placed_[id].box;
    return (wrap_.roundOf(box.upper) - wrap_.roundOf(box.lower)).maxCoeff() < mostImages;
}

/// An image of a shape that has moved has moved as well; what it does not need any more goes.
void Space::seatImages(ProxyId id) {
    const Aabb box = placed_[id].box;
    const Vec2 first = wrap_.roundOf(box.lower);
    const Vec2 last = (wrap_.roundOf(around::spare(box).upper) - first).cwiseMin(Vec2(mostImages - 1, mostImages - 1));
    rounds_[id].first = first;
    std::vector<ProxyId> old = std::move(rounds_[id].images), now;
    around::forEachRound({0, 0}, last, [&](const Vec2& image) {
        if (image.isZero(0)) return;
        const auto same = [&](ProxyId other) { return rounds_[other].image == image; };
        const auto known = std::find_if(old.begin(), old.end(), same);
        const bool isNew = known == old.end();
        const ProxyId member = isNew ? acquire() : *known;
        if (!isNew) old.erase(known);
        if (rounds_.size() <= member) rounds_.resize(member + std::size_t{1});
        if (isNew) rounds_[member] = {id, image, {0, 0}, {}};
        seats_[member].fixed = seats_[id].fixed;
        seats_[member].moved = true;
        moved_.push_back(member);
        now.push_back(member);
    });
    rounds_[id].images = std::move(old);
    dropImages(id);
    rounds_[id].images = std::move(now);
}

void Space::dropImages(ProxyId id) {
    for (const ProxyId image : rounds_[id].images) {
        leave(image);
        seats_[image].moved = false;
        free_.push_back(image);
    }
    rounds_[id].images.clear();
}

/// Two members of the hierarchies that may overlap: each pair of shapes and each shift of theirs is taken once, where
/// along each axis one of the two is no image.
void Space::takeShifted(ProxyId memberA, ProxyId memberB) {
    const ProxyId a = rounds_[memberA].real, b = rounds_[memberB].real;
    if (!mayPair(gates_[a], gates_[b])) return;
    if (rounds_[memberA].image.cwiseMin(rounds_[memberB].image).maxCoeff() > 0) return;
    const bool ordered = a < b;
    const Vec2 inA = roundsOf(memberA), inB = roundsOf(memberB);
    const ShiftedPair found{{std::min(a, b), std::max(a, b)}, ordered ? Vec2(inA - inB) : Vec2(inB - inA)};
    const Vec2 shift = wrap_.lengthOf(found.rounds);
    if (!boxesOverlap(found.pair.a, found.pair.b, shift)) return;
    if (!previousBoxesOverlap(found.pair.a, found.pair.b, shift)) shiftedPairs_.push_back(found);
}

void Space::sortShiftedPairs() {
    std::sort(shiftedPairs_.begin(), shiftedPairs_.end(), [](const ShiftedPair& p, const ShiftedPair& q) {
        const auto rank = [](const ShiftedPair& s) {
            return std::tuple(s.pair.a, s.pair.b, s.rounds.y(), s.rounds.x());
        };
        return rank(p) < rank(q);
    });
    for (const ShiftedPair& found : shiftedPairs_) {
        pairs_.push_back(found.pair);
        pairShifts_.push_back(wrap_.lengthOf(found.rounds));
    }
    shiftedPairs_.clear();
}

}  // namespace plumb
