// SPDX-License-Identifier: MIT
// Which pairs are new? The part of Space that answers, step by step.
#include <algorithm>

#include <plumb/broad/detail/block_search.h>
#include <plumb/space/space.h>

namespace plumb {

namespace {

/// When more than one in so many were placed anew, all are taken to be: block against block is cheaper by then.
constexpr std::uint32_t fewOf = 4;
/// An order is made anew when one in so many was added or taken out since, and in small crowds some more.
constexpr std::uint32_t changedOf = 4;
constexpr std::uint32_t changedAnyway = 64;
/// And when its blocks have grown by this factor, seen every few looks; and in any case when each member was placed
/// anew so often, as what mixes while it draws together does not grow.
constexpr double loosened = 1.1;
constexpr std::uint32_t looksBetweenChecks = 4;
constexpr std::uint64_t placingsBetweenSorts = 32;
/// What was not placed in so many looks rests; seen every few looks, and acted upon when it is one in so many.
constexpr std::uint32_t looksToRest = 64;
constexpr std::uint32_t looksBetweenRests = 32;
constexpr std::uint32_t restingOf = 8;
/// Floats tell a millimetre this far from their origin [m].
constexpr double far = 8192;
/// What was put farther away is not followed: seen from there, all else would lie beyond the floats [m].
constexpr double farthest = 1e16;
constexpr std::uint32_t looksBetweenOrigins = 64;
/// Boxes stand in the order that shapes were added in, and are read in another: asked for so many ahead.
constexpr std::uint32_t boxesAhead = 24;

void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
    __builtin_prefetch(address);
#endif
}

}  // namespace

void Space::seatMoved() {
    for (std::size_t i = 0; i < moved_.size(); ++i) {  // images are added to them
        const ProxyId id = moved_[i];
        Seat& seat = seats_[id];
        seat.listed = false;
        if (!seat.moved) continue;
        if (!wrap_.any() || rounds_[id].real == id) ++work_.placed;
        seat.lastPlaced = look_;
        const Home home = seat.fixed ? Home::Fixed : Home::Moving;
        Crowd& crowd = crowdOf(home);
        if (seat.home != home) {
            leave(id);
            enter(id, home);
        } else if (seat.fresh) {
            crowd.tree.forgetPrevious(seat.slot);
        }
        ++crowd.moved;
        if (wrap_.any() && rounds_[id].real == id) seatImages(id);
    }
}

/// Floats are counted from near what moves, wherever that is in the world.
void Space::follow() {
    const Aabb box = seatBox(moved_[moved_.size() / 2]);
    const Vec2 center = 0.5 * box.lower + 0.5 * box.upper;
    const double away = center.lpNorm<Eigen::Infinity>();
    if (!(away < farthest) || (center - origin_).lpNorm<Eigen::Infinity>() < far) return;
    if (originLook_ != 0 && look_ - originLook_ < looksBetweenOrigins) return;
    origin_ = center;
    originLook_ = look_;
    for (Crowd& crowd : crowds_) fill(crowd);
}

void Space::fill(Crowd& crowd) {
    const BoundsRounding rounded(origin_);
    const std::span<const std::uint32_t> members = crowd.tree.members();
    for (std::uint32_t slot = 0; slot < members.size(); ++slot) {
        if (members[slot] == BlockTree::noMember) continue;
        crowd.tree.put(slot, rounded(seatBox(members[slot])));
        if (!wrap_.any()) crowd.tree.putPrevious(slot, rounded(previousBox(members[slot])));
    }
    crowd.refit = true;
}

void Space::sort(Crowd& crowd) {
    sortBoxes_.clear();
    unsorted_.clear();
    for (const ProxyId id : crowd.tree.members()) {
        if (id == BlockTree::noMember) continue;
        unsorted_.push_back(id);
        sortBoxes_.push_back(seatBox(id));
    }
    sorted_.clear();
    for (const std::uint32_t i : mortonSort_(sortBoxes_, BlockTree::width)) sorted_.push_back(unsorted_[i]);
    crowd.tree.assign(sorted_);
    for (std::uint32_t slot = 0; slot < sorted_.size(); ++slot) seats_[sorted_[slot]].slot = slot;
    fill(crowd);
    crowd.changes = 0;
    crowd.placings = 0;
    crowd.loose = false;
    work_.sorted += crowd.tree.memberCount();
}

void Space::putMoved(Crowd& crowd) {
    const BoundsRounding rounded(origin_);
    if (crowd.allMoved) {
        const std::span<const std::uint32_t> members = crowd.tree.members();
        for (std::uint32_t slot = 0; slot < members.size(); ++slot) {
            const std::size_t ahead = slot + std::size_t{boxesAhead};
            if (ahead < members.size() && members[ahead] != BlockTree::noMember) prefetch(&placed_[members[ahead]]);
            if (members[slot] == BlockTree::noMember) continue;
            crowd.tree.put(slot, rounded(seatBox(members[slot])));
            if (wrap_.any()) crowd.tree.forgetPrevious(slot);
        }
        crowd.tree.touchAll();
        return;
    }
    for (const ProxyId id : moved_) {
        const Seat& seat = seats_[id];
        if (!seat.moved || &crowdOf(seat.home) != &crowd) continue;
        crowd.tree.put(seat.slot, rounded(seatBox(id)));
        if (wrap_.any()) crowd.tree.forgetPrevious(seat.slot);  // its round may be another: the boxes themselves tell
        crowd.tree.touch(seat.slot);
    }
}

bool Space::isStale(const Crowd& crowd) const {
    const std::uint64_t members = crowd.tree.memberCount();
    if (crowd.changes * std::uint64_t{changedOf} > members + changedAnyway) return true;
    if (crowd.placings > placingsBetweenSorts * members) return true;
    return crowd.loose;
}

void Space::bringUp(Crowd& crowd) {
    const bool sorting = isStale(crowd);
    if (sorting) sort(crowd);
    crowd.allMoved = crowd.moved * std::uint64_t{fewOf} > crowd.tree.memberCount();
    crowd.placings += crowd.moved;
    if (crowd.moved > 0) putMoved(crowd);
    if (crowd.refit || crowd.allMoved)
        crowd.tree.refitAll();
    else if (crowd.moved > 0)
        crowd.tree.refitTouched();
    crowd.refit = false;
    if (sorting)
        crowd.looseness = crowd.tree.looseness();
    else if (crowd.moved > 0 && look_ % looksBetweenChecks == 0)
        crowd.loose = crowd.tree.looseness() > loosened * crowd.looseness;
}

/// Whose slots are the pairs that come in.
struct Space::Finding {
    Space& space;
    std::span<const std::uint32_t> from, in;

    static void take(void* receiver, const SlotPair* pairs, std::uint32_t count) {
        const Finding& finding = *static_cast<const Finding*>(receiver);
        Space& space = finding.space;
        for (const SlotPair& pair : std::span(pairs, count)) {
            const ProxyId a = finding.from[pair.a];
            const ProxyId b = finding.in[pair.b];
            if (space.wrap_.any()) {
                space.takeShifted(a, b);
                continue;
            }
            if (!mayPair(space.gates_[a], space.gates_[b])) continue;
            if (!space.boxesOverlap(a, b) || space.previousBoxesOverlap(a, b)) continue;
            space.pairs_.push_back({std::min(a, b), std::max(a, b)});
        }
    }
};

void Space::find(const Crowd& from, const Crowd& in, bool otherHasAsked) {
    Finding finding{*this, from.tree.members(), in.tree.members()};
    BlockSearch search{from.tree.view(), from.tree.touchedBlocks(), in.tree.view(), BlockSearch::Another,
                       from.allMoved};
    if (&from == &in)
        search.is = BlockSearch::Itself;
    else if (otherHasAsked)
        search.is = BlockSearch::AnotherThatAsks;
    const SearchWork done = searchBlocks(search, {&Finding::take, &finding}, lanes_);
    work_.blockTests += done.blocks;
    work_.boxTests += done.boxes;
}

void Space::findAll() {
    const Crowd& moving = crowdOf(Home::Moving);
    const Crowd& resting = crowdOf(Home::Resting);
    const Crowd& fixed = crowdOf(Home::Fixed);
    find(moving, moving);
    find(moving, resting);
    find(moving, fixed);
    find(fixed, moving, true);
    find(fixed, resting);
}

void Space::sortPairs() {
    if (wrap_.any()) {
        sortShiftedPairs();
        return;
    }
    pairSort_(pairs_, [](const Pair& pair) { return std::uint64_t{pair.a} << 32 | pair.b; });
}

void Space::settle() {
    for (Crowd& crowd : crowds_) {
        crowd.tree.settle();
        crowd.moved = 0;
    }
    for (const ProxyId id : moved_) seats_[id].moved = seats_[id].fresh = false;
    moved_.clear();
}

void Space::letRest() {
    if (look_ % looksBetweenRests != 0) return;
    Crowd& moving = crowdOf(Home::Moving);
    Crowd& resting = crowdOf(Home::Resting);
    unsorted_.clear();
    for (const ProxyId id : moving.tree.members())
        if (id != BlockTree::noMember && look_ - seats_[id].lastPlaced > looksToRest) unsorted_.push_back(id);
    if (unsorted_.size() * restingOf < moving.tree.memberCount()) return;
    const BoundsRounding rounded(origin_);
    for (const ProxyId id : unsorted_) {
        leave(id);
        enter(id, Home::Resting);
        resting.tree.put(seats_[id].slot, rounded(seatBox(id)));
        resting.tree.touch(seats_[id].slot);
    }
    resting.tree.refitTouched();
    resting.tree.settle();
}

const SortedPairs& Space::takeNewPairs() {
    pairs_.clear();
    pairShifts_.clear();
    work_ = {};
    if (moved_.empty()) return pairs_;
    ++look_;
    seatMoved();
    follow();
    for (Crowd& crowd : crowds_) bringUp(crowd);
    findAll();
    sortPairs();
    settle();
    letRest();
    return pairs_;
}

}  // namespace plumb
