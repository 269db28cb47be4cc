// SPDX-License-Identifier: MIT
// Which pairs are new? The part of Space that finds them, step by step.
#include <algorithm>

#include <plumb/broad/detail/block_search.h>
#include <plumb/broad/detail/block_search_wide.h>
#include <plumb/space/detail/space.h>

namespace plumb {

namespace {

/// When more than one in so many moved, all count as moved: testing block against block is cheaper by then.
constexpr std::uint32_t allMovedOneIn = 4;
/// The order of a tree is made again when one in so many shapes was added or removed since, plus a constant for small
/// trees.
constexpr std::uint32_t resortOneIn = 4;
constexpr std::uint32_t resortSlack = 64;
/// It is also made again when its blocks have grown by this factor, which is checked every few updates, and when each
/// shape has moved so often on average: shapes that mix while they draw together do not make blocks grow.
constexpr double maxGrowth = 1.1;
constexpr std::uint32_t updatesBetweenChecks = 4;
constexpr std::uint64_t movesBetweenSorts = 32;
/// A shape that has not moved for so many updates is resting. This is checked every few updates; resting shapes change
/// trees when they are one in so many.
constexpr std::uint32_t updatesToRest = 64;
constexpr std::uint32_t updatesBetweenRests = 32;
constexpr std::uint32_t restingOneIn = 8;
/// A float tells millimetres apart up to this distance from the origin [m].
constexpr double recenterDistance = 8192;
/// The origin does not follow shapes that are farther away: seen from there, everything else would be beyond the range
/// of float [m].
constexpr double maxOrigin = 1e16;
constexpr std::uint32_t updatesBetweenOrigins = 64;
/// Boxes are stored in the order in which shapes were added, and read in another order: prefetched so many ahead.
constexpr std::uint32_t prefetchDistance = 24;

void prefetch([[maybe_unused]] const void* address) {
#if defined(__GNUC__)
    __builtin_prefetch(address);
#endif
}

}  // namespace

void Space::updateEntries() {
    for (std::size_t i = 0; i < moved_.size(); ++i) {  // images are added to them
        const ProxyId id = moved_[i];
        TreeEntry& entry = entries_[id];
        entry.inMovedList = false;
        if (!entry.moved) continue;
        if (!wrap_.any() || imageRecords_[id].original == id) ++work_.placed;
        entry.lastUpdate = update_;
        const PartitionId partitionId = entry.fixed ? PartitionId::Fixed : PartitionId::Moving;
        Partition& partition = partitionOf(partitionId);
        if (entry.partitionId != partitionId) {
            leave(id);
            enter(id, partitionId);
        } else if (entry.isNew) {
            partition.tree.clearPrevious(entry.slot);
        }
        ++partition.movedCount;
        if (wrap_.any() && imageRecords_[id].original == id) updateImages(id);
    }
}

/// Float coordinates count from near the shapes that move, wherever they are in the world.
void Space::recenterOrigin() {
    const Aabb box = treeBox(moved_[moved_.size() / 2]);
    const Vec2 center = 0.5 * box.lower + 0.5 * box.upper;
    const double away = center.cwiseAbs().maxCoeff();
    if (!(away < maxOrigin) || (center - origin_).cwiseAbs().maxCoeff() < recenterDistance) return;
    if (originUpdate_ != 0 && update_ - originUpdate_ < updatesBetweenOrigins) return;
    origin_ = center;
    originUpdate_ = update_;
    for (Partition& partition : partitions_) refillBoxes(partition);
}

void Space::refillBoxes(Partition& partition) {
    const BoundsRounding rounded(origin_);
    const std::span<const std::uint32_t> members = partition.tree.members();
    for (std::uint32_t slot = 0; slot < members.size(); ++slot) {
        if (members[slot] == BlockTree::noMember) continue;
        partition.tree.put(slot, rounded(treeBox(members[slot])));
        if (!wrap_.any()) partition.tree.putPrevious(slot, rounded(previousBox(members[slot])));
    }
    partition.needsRefit = true;
}

void Space::sort(Partition& partition) {
    sortBoxes_.clear();
    unsorted_.clear();
    for (const ProxyId id : partition.tree.members()) {
        if (id == BlockTree::noMember) continue;
        unsorted_.push_back(id);
        sortBoxes_.push_back(treeBox(id));
    }
    sorted_.clear();
    for (const std::uint32_t i : mortonSort_(sortBoxes_, BlockTree::width)) sorted_.push_back(unsorted_[i]);
    partition.tree.assign(sorted_);
    for (std::uint32_t slot = 0; slot < sorted_.size(); ++slot) entries_[sorted_[slot]].slot = slot;
    refillBoxes(partition);
    partition.changes = 0;
    partition.moves = 0;
    partition.grown = false;
    work_.sorted += partition.tree.memberCount();
}

void Space::putMovedBoxes(Partition& partition) {
    const BoundsRounding rounded(origin_);
    if (partition.allMoved) {
        const std::span<const std::uint32_t> members = partition.tree.members();
        for (std::uint32_t slot = 0; slot < members.size(); ++slot) {
            const std::size_t ahead = slot + std::size_t{prefetchDistance};
            if (ahead < members.size() && members[ahead] != BlockTree::noMember) prefetch(&boxes_[members[ahead]]);
            if (members[slot] == BlockTree::noMember) continue;
            partition.tree.put(slot, rounded(treeBox(members[slot])));
            if (wrap_.any()) partition.tree.clearPrevious(slot);
        }
        partition.tree.markAllDirty();
        return;
    }
    for (const ProxyId id : moved_) {
        const TreeEntry& entry = entries_[id];
        if (!entry.moved || &partitionOf(entry.partitionId) != &partition) continue;
        partition.tree.put(entry.slot, rounded(treeBox(id)));
        if (wrap_.any()) partition.tree.clearPrevious(entry.slot);  // it may be in another image now
        partition.tree.markDirty(entry.slot);
    }
}

bool Space::isStale(const Partition& partition) const {
    const std::uint64_t members = partition.tree.memberCount();
    if (partition.changes * std::uint64_t{resortOneIn} > members + resortSlack) return true;
    if (partition.moves > movesBetweenSorts * members) return true;
    return partition.grown;
}

void Space::updateTree(Partition& partition) {
    const bool sorting = isStale(partition);
    if (sorting) sort(partition);
    partition.allMoved = partition.movedCount * std::uint64_t{allMovedOneIn} > partition.tree.memberCount();
    partition.moves += partition.movedCount;
    if (partition.movedCount > 0) putMovedBoxes(partition);
    if (partition.needsRefit || partition.allMoved)
        partition.tree.refitAll();
    else if (partition.movedCount > 0)
        partition.tree.refitDirty();
    partition.needsRefit = false;
    if (sorting)
        partition.halfPerimeterSum = partition.tree.halfPerimeterSum();
    else if (partition.movedCount > 0 && update_ % updatesBetweenChecks == 0)
        partition.grown = partition.tree.halfPerimeterSum() > maxGrowth * partition.halfPerimeterSum;
}

/// Receives the pairs of slots, and turns slots into proxies.
struct Space::PairSink {
    Space& space;
    std::span<const std::uint32_t> from, in;

    static void take(void* receiver, const SlotPair* pairs, std::uint32_t count) {
        const PairSink& sink = *static_cast<const PairSink*>(receiver);
        Space& space = sink.space;
        for (const SlotPair& pair : std::span(pairs, count)) {
            const ProxyId a = sink.from[pair.a];
            const ProxyId b = sink.in[pair.b];
            if (space.wrap_.any()) {
                space.addShiftedPair(a, b);
                continue;
            }
            if (!mayPair(space.filterKeys_[a], space.filterKeys_[b])) continue;
            if (!space.boxesOverlap(a, b) || space.previousBoxesOverlap(a, b)) continue;
            space.pairs_.push_back({std::min(a, b), std::max(a, b)});
        }
    }
};

void Space::searchPairs(const Partition& from, const Partition& in, bool otherSearched) {
    PairSink sink{*this, from.tree.members(), in.tree.members()};
    BlockSearch search{from.tree.view(), from.tree.dirtyBlocks(), in.tree.view(), BlockSearch::Other, from.allMoved};
    if (&from == &in)
        search.target = BlockSearch::Self;
    else if (otherSearched)
        search.target = BlockSearch::OtherSearchesToo;
    const SearchWork done = searchBlocks(search, {&PairSink::take, &sink}, lanes_);
    work_.blockTests += done.blocks;
    work_.boxTests += done.boxes;
}

void Space::searchAllPairs() {
    if (pairable_ == 0) return;
    const Partition& moving = partitionOf(PartitionId::Moving);
    const Partition& resting = partitionOf(PartitionId::Resting);
    const Partition& fixed = partitionOf(PartitionId::Fixed);
    searchPairs(moving, moving);
    searchPairs(moving, resting);
    searchPairs(moving, fixed);
    searchPairs(fixed, moving, true);
    searchPairs(fixed, resting);
}

void Space::sortPairs() {
    if (wrap_.any()) {
        sortShiftedPairs();
        return;
    }
    pairSort_(pairs_, [](const Pair& pair) { return std::uint64_t{pair.a} << 32 | pair.b; });
}

void Space::finishUpdate() {
    for (Partition& partition : partitions_) {
        partition.tree.storePrevious();
        partition.movedCount = 0;
    }
    for (const ProxyId id : moved_) entries_[id].moved = entries_[id].isNew = false;
    moved_.clear();
}

void Space::moveRestingBoxes() {
    if (update_ % updatesBetweenRests != 0) return;
    Partition& moving = partitionOf(PartitionId::Moving);
    Partition& resting = partitionOf(PartitionId::Resting);
    unsorted_.clear();
    for (const ProxyId id : moving.tree.members())
        if (id != BlockTree::noMember && update_ - entries_[id].lastUpdate > updatesToRest) unsorted_.push_back(id);
    if (unsorted_.size() * restingOneIn < moving.tree.memberCount()) return;
    const BoundsRounding rounded(origin_);
    for (const ProxyId id : unsorted_) {
        leave(id);
        enter(id, PartitionId::Resting);
        resting.tree.put(entries_[id].slot, rounded(treeBox(id)));
        resting.tree.markDirty(entries_[id].slot);
    }
    resting.tree.refitDirty();
    resting.tree.storePrevious();
}

const SortedPairs& Space::findNewPairs() {
    pairs_.clear();
    pairShifts_.clear();
    work_ = {};
    if (moved_.empty()) return pairs_;
    ++update_;
    updateEntries();
    recenterOrigin();
    for (Partition& partition : partitions_) updateTree(partition);
    searchAllPairs();
    sortPairs();
    finishUpdate();
    moveRestingBoxes();
    return pairs_;
}

}  // namespace plumb
