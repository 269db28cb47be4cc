// SPDX-License-Identifier: MIT
#include <plumb/space/detail/space.h>

#include <algorithm>
#include <limits>

#include <plumb/math/detail/arrays.h>

namespace plumb {

namespace {

/// The previous box of a new shape: overlaps nothing, not even the whole plane.
Aabb nowhere() {
    constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
    return {{notANumber, notANumber}, {notANumber, notANumber}};
}

/// Of no shape.
FilterKey noKey() {
    FilterKey key;
    key.fixed = true;
    key.collides = false;
    return key;
}

}  // namespace

ProxyId Space::acquire() {
    if (!free_.empty()) {
        const ProxyId id = free_.back();
        free_.pop_back();
        return id;
    }
    proxies_.emplace_back();
    boxes_.emplace_back();
    previousBoxes_.emplace_back();
    entries_.emplace_back();
    filterKeys_.push_back(noKey());
    return static_cast<ProxyId>(proxies_.size() - 1);
}

ProxyId Space::add(const ShapeDef& def, std::uint32_t owner, bool fixed, const Vec2& localCenter, const Aabb& tight,
                   std::uint32_t number, bool piece, PieceUse use) {
    const ProxyId id = acquire();
    proxies_[id] = {def, convexOf(def.shape, localCenter), owner, number, piece, use, fixed, false, true};
    proxies_[id].convex.oneSided = use == PieceUse::Contact;
    setFilterKey(id);
    entries_[id].fixed = fixed;
    boxes_[id].box = tight;
    if (wrap_.any()) {
        if (imageRecords_.size() <= id) imageRecords_.resize(id + std::size_t{1});
        imageRecords_[id] = {id, {0, 0}, {0, 0}, {}};
    }
    markNew(id);
    return id;
}

void Space::remove(ProxyId id) {
    hide(id);
    proxies_[id].alive = false;
    setFilterKey(id);
    free_.push_back(id);
}

void Space::hide(ProxyId id) {
    leave(id);
    entries_[id].moved = false;
    if (wrap_.any()) removeImages(id);
}

void Space::change(ProxyId id, const ShapeDef& def) {
    proxies_[id].def = def;
    setFilterKey(id);
}

void Space::change(ProxyId id, bool fixed, const Vec2& localCenter) {
    proxies_[id].convex = convexOf(proxies_[id].def.shape, localCenter);
    proxies_[id].convex.oneSided = proxies_[id].use == PieceUse::Contact;
    proxies_[id].fixed = fixed;
    setFilterKey(id);
    entries_[id].fixed = fixed;
}

void Space::setDriven(ProxyId id, bool driven) {
    proxies_[id].driven = driven;
    setFilterKey(id);
}

/// The key of a shape that is not there does not pair.
void Space::setFilterKey(ProxyId id) {
    FilterKey& key = filterKeys_[id];
    if (key.pairsWithAll()) --pairable_;
    key = filterKeyOf(proxies_[id]);
    if (!proxies_[id].alive) key = noKey();
    if (key.pairsWithAll()) ++pairable_;
}

void Space::markMoved(ProxyId id) {
    TreeEntry& entry = entries_[id];
    if (entry.moved) return;
    previousBoxes_[id] = boxes_[id];
    entry.moved = true;
    if (!entry.inMovedList) moved_.push_back(id);
    entry.inMovedList = true;
}

void Space::updateBox(ProxyId id, const Aabb& tight, double margin) {
    markMoved(id);
    boxes_[id].box = inflate(tight, margin);
}

void Space::markNew(ProxyId id) {
    markMoved(id);
    previousBoxes_[id].box = nowhere();
    entries_[id].isNew = true;
}

void Space::leave(ProxyId id) {
    TreeEntry& entry = entries_[id];
    if (entry.partitionId == PartitionId::None) return;
    Partition& partition = partitionOf(entry.partitionId);
    partition.tree.erase(entry.slot);
    ++partition.changes;
    entry.partitionId = PartitionId::None;
}

void Space::enter(ProxyId id, PartitionId partitionId) {
    Partition& partition = partitionOf(partitionId);
    entries_[id].slot = partition.tree.append(id);
    entries_[id].partitionId = partitionId;
    ++partition.changes;
    if (wrap_.any())
        partition.tree.clearPrevious(entries_[id].slot);
    else
        partition.tree.putPrevious(entries_[id].slot, BoundsRounding(origin_)(previousBox(id)));
}

void Space::reserve(std::size_t shapes) {
    proxies_.reserve(shapes);
    boxes_.reserve(shapes);
    previousBoxes_.reserve(shapes);
    entries_.reserve(shapes);
    filterKeys_.reserve(shapes);
    free_.reserve(shapes);
    moved_.reserve(shapes);
    partitionOf(PartitionId::Moving).tree.reserve(shapes);
}

std::size_t Space::bytes() const {
    std::size_t bytes = bytesOf(proxies_) + bytesOf(boxes_) + bytesOf(previousBoxes_) + bytesOf(entries_) +
                        bytesOf(filterKeys_) + bytesOf(free_) + bytesOf(moved_) + bytesOf(pairs_) +
                        bytesOf(sortBoxes_) + bytesOf(unsorted_) + bytesOf(sorted_) + bytesOf(imageRecords_) +
                        bytesOf(shiftedPairs_) + bytesOf(pairShifts_) + mortonSort_.bytes() + pairSort_.bytes();
    for (const Partition& partition : partitions_) bytes += partition.tree.bytes();
    for (const ImageRecord& record : imageRecords_) bytes += bytesOf(record.images);
    for (const Proxy& proxy : proxies_) {
        bytes += proxy.convex.vertices.bytes() + proxy.convex.normals.bytes();
        if (const auto* polygon = std::get_if<Polygon>(&proxy.def.shape)) bytes += bytesOf(polygon->vertices);
    }
    return bytes;
}

/// Clips the ray to the bounds of all boxes: a ray that goes far beyond them would be imprecise in float.
RayPart Space::clipToBounds(const Vec2& halfSize, const Vec2& from, const Vec2& to) const {
    constexpr double far = 8192;
    const Vec2 farthest = (from - origin_).cwiseAbs().cwiseMax((to - origin_).cwiseAbs());
    if (farthest.maxCoeff() < far) return {};
    RayPart part{1, 0};
    for (const Partition& partition : partitions_) {
        const Bounds bounds = partition.tree.bounds();
        if (!(bounds.lowerX <= bounds.upperX)) continue;
        const Vec2 lower(static_cast<double>(bounds.lowerX), static_cast<double>(bounds.lowerY));
        const Vec2 upper(static_cast<double>(bounds.upperX), static_cast<double>(bounds.upperY));
        // A millionth more, because the bounds are rounded.
        const Vec2 margins = halfSize + 1e-6 * (lower.cwiseAbs().cwiseMax(upper.cwiseAbs()));
        const RayPart here = clipRay(from, to, {lower + origin_ - margins, upper + origin_ + margins});
        if (!(here.first <= here.last)) continue;
        part =
            part.first <= part.last ? RayPart{std::min(part.first, here.first), std::max(part.last, here.last)} : here;
    }
    return part;
}

}  // namespace plumb
