// SPDX-License-Identifier: MIT
// Which placed shapes have come near each other?
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <plumb/broad/block_tree.h>
#include <plumb/broad/box_probe.h>
#include <plumb/broad/morton.h>
#include <plumb/broad/pair.h>
#include <plumb/broad/radix_sort.h>
#include <plumb/collide/convex.h>
#include <plumb/math/function_ref.h>
#include <plumb/shapes/aabb.h>
#include <plumb/shapes/tile_pieces.h>
#include <plumb/space/shape_def.h>
#include <plumb/space/wrap.h>

namespace plumb {

using ProxyId = std::uint32_t;

/// A shape in the space, owned by a body or mover.
struct Proxy {
    ShapeDef def;
    Convex convex;             ///< the shape relative to the owner's centre of mass
    std::uint32_t owner = 0;   ///< an index chosen by the owner; shapes of one owner never pair
    std::uint32_t number = 0;  ///< which of the owner's shapes it is, or is a piece of
    bool piece = false;        ///< it is a piece of a chain or a tile map
    PieceUse use = PieceUse::Both;
    bool fixed = false;   ///< does not move by itself, and does not pair with another fixed shape
    bool driven = false;  ///< nothing pushes it: pairs only with what is neither fixed nor driven, and with sensors
    bool alive = false;
};

/// The data that decides whether two shapes may collide. Small, because it is read often.
struct FilterKey {
    std::uint64_t category = 1, mask = ~std::uint64_t{0};
    std::uint32_t owner = 0;
    int group = 0;
    bool fixed = false;
    bool driven = false;
    bool sensor = false;
    bool collides = true;  ///< takes part in collisions, and is not only there for queries
    bool queried = true;   ///< is found by queries

    /// Can it pair with any other shape, also with one that nothing pushes?
    bool pairsWithAll() const { return sensor || !(fixed || driven); }
};

/// Do the two filters allow a collision?
inline bool filtersAllow(const FilterKey& a, const FilterKey& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

inline bool mayPair(const FilterKey& a, const FilterKey& b) {
    return a.owner != b.owner && !(a.fixed && b.fixed) && !(a.sensor && b.sensor) && a.collides && b.collides &&
           (a.pairsWithAll() || b.pairsWithAll()) && filtersAllow(a, b);
}

inline FilterKey filterKeyOf(const Proxy& proxy) {
    const Filter& filter = proxy.def.filter;
    const bool collides = proxy.use == PieceUse::Both || proxy.use == PieceUse::Contact;
    const bool queried = proxy.use == PieceUse::Both || proxy.use == PieceUse::Query;
    return {filter.category, filter.mask,      proxy.owner, filter.group, proxy.fixed,
            proxy.driven,    proxy.def.sensor, collides,    queried};
}

/// May these two collide, as far as owner, kind and filter decide?
inline bool mayPair(const Proxy& a, const Proxy& b) {
    return mayPair(filterKeyOf(a), filterKeyOf(b));
}

/// How much work the last update took, in counts that are the same on any machine.
struct SpaceWork {
    std::uint32_t placed = 0;      ///< shapes that were new, marked as new, or had left their boxes
    std::uint32_t sorted = 0;      ///< shapes whose order along the Morton curve was made again
    std::uint64_t blockTests = 0;  ///< 16 boxes tested against one
    std::uint64_t boxTests = 0;    ///< one box tested against the 16 of a block
};

/// Stores shapes with boxes that have a margin, so that a shape that rests or creeps needs no update. Three trees hold
/// the shapes that moved recently, the shapes that rest, and the fixed shapes. An update costs in proportion to what
/// has moved since the last one.
/// The trees store floats, relative to an origin near the moving shapes, and report a few pairs too many; candidates
/// are tested again in double.
/// A space may wrap around. Positions may then be in any periodic image. Results come with the shift, of whole periods,
/// that brings the shape to where it was found: visit(id, shift). A visitor that takes only the id is for a space that
/// does not wrap. A shape may be found more than once, with different shifts.
class Space {
public:
    /// lanes: boxes tested at once, 1, 4, 8 or 16; no more than the machine supports. The pairs are the same for any
    /// number.
    explicit Space(int lanes = 16, const Wrap& wrap = {}) : lanes_(lanes), wrap_(wrap) {}
    void setLanes(int lanes) { lanes_ = lanes; }
    /// Only while the space is empty.
    void setWrap(const Wrap& wrap) { wrap_ = wrap; }
    const Wrap& wrap() const { return wrap_; }

    ProxyId add(const ShapeDef& def, std::uint32_t owner, bool fixed, const Vec2& localCenter, const Aabb& tight,
                std::uint32_t number = 0, bool piece = false, PieceUse use = PieceUse::Both);
    void remove(ProxyId proxy);

    /// Takes a shape out of the trees until it is placed and marked as new; it keeps its id.
    void hide(ProxyId proxy);
    /// Sets another material, filter, tag or contact rule; the outline stays. If new pairs become possible, the owner
    /// has to find them, or to call markNew.
    void change(ProxyId proxy, const ShapeDef& def);
    /// Makes a shape fixed or movable, and sets another centre of mass. Call markNew if fixed has changed.
    void change(ProxyId proxy, bool fixed, const Vec2& localCenter);

    /// Makes a shape one that nothing pushes, or not. Call markNew if it is placed already.
    void setDriven(ProxyId proxy, bool driven);

    /// Sets where a shape is and will be. A box that no longer contains it, or is far too large, is replaced by one
    /// with this margin [m].
    void place(ProxyId proxy, const Aabb& tight, double margin) {
        const Aabb& now = boxes_[proxy].box;
        if (!contains(now, tight) || !contains(inflate(tight, maxSpareMargins * margin), now))
            updateBox(proxy, tight, margin);
    }

    /// The next update reports all pairs of this shape again, as if it were new.
    void markNew(ProxyId proxy);

    /// Pairs whose boxes overlap now and did not at the last call: sorted, each once; valid until the next call. The
    /// owner has to remember older pairs for as long as their boxes overlap.
    const SortedPairs& findNewPairs();
    /// How b of each of these pairs has to be shifted to overlap a, if the space wraps; otherwise empty. A pair that
    /// overlaps with two shifts is two pairs.
    std::span<const Vec2> newPairShifts() const { return pairShifts_; }

    /// Called with a shape, and with the shift by which it was found in a space that wraps.
    using Visit = FunctionRef<void(ProxyId, const Vec2&)>;
    /// The same; returns the fraction of the ray, or the distance, up to which more results are wanted.
    using VisitWhile = FunctionRef<double(ProxyId, const Vec2&)>;

    /// Calls visit for each shape whose current box overlaps or touches the given one.
    void query(const Aabb& box, Visit visit) const;

    /// The same for fixed shapes.
    void queryFixed(const Aabb& box, Visit visit) const;

    /// Casts a box of this half size from one point to another: calls visit for each shape whose box it may hit, nearer
    /// ones first as far as known. visit returns the fraction of the ray up to which more results are wanted; at first,
    /// and at most, 1.
    void castBox(const Vec2& halfSize, const Vec2& from, const Vec2& to, VisitWhile visit) const;

    /// Calls visit for each shape whose box may be no farther from a point than within [m]; visit returns a new value
    /// of within.
    void findNear(const Vec2& point, double within, VisitWhile visit) const;

    const FilterKey& filterKey(ProxyId proxy) const { return filterKeys_[proxy]; }
    const Proxy& operator[](ProxyId proxy) const { return proxies_[proxy]; }
    /// Contains the shape, with a margin.
    const Aabb& box(ProxyId proxy) const { return boxes_[proxy].box; }
    bool boxesOverlap(ProxyId a, ProxyId b) const { return overlap(boxes_[a].box, boxes_[b].box); }
    /// Did they at the last update?
    bool previousBoxesOverlap(ProxyId a, ProxyId b) const { return overlap(previousBox(a), previousBox(b)); }
    // The same with b shifted.
    bool boxesOverlap(ProxyId a, ProxyId b, const Vec2& shift) const {
        return overlap(boxes_[a].box, shifted(boxes_[b].box, shift));
    }
    bool previousBoxesOverlap(ProxyId a, ProxyId b, const Vec2& shift) const {
        return overlap(previousBox(a), shifted(previousBox(b), shift));
    }
    /// Do the trees hold all images of its box? Not if the box extends into more images than are stored.
    bool hasAllImages(ProxyId id) const;
    /// Calls visit(shift) for each shift with which a box overlaps another one; up to 64 along an axis.
    template <class Visitor>
    void forEachShift(const Aabb& still, const Aabb& box, Visitor&& visitor) const;
    /// The same for the boxes of two shapes at the last update.
    template <class Visitor>
    void forEachPreviousShift(ProxyId still, ProxyId other, Visitor&& visitor) const {
        forEachShift(previousBox(still), previousBox(other), visitor);
    }

    /// Reserves memory for so many shapes.
    void reserve(std::size_t shapes);
    /// Memory in use.
    std::size_t bytes() const;

    const SpaceWork& work() const { return work_; }

private:
    /// A box is replaced when it is larger than needed by more than this many margins [-].
    static constexpr double maxSpareMargins = 4;

    enum class PartitionId : std::uint8_t { None, Moving, Resting, Fixed };
    static constexpr std::size_t partitionCount = 4;

    struct alignas(32) AlignedBox {
        Aabb box;
    };
    /// Where a proxy is in the trees.
    struct TreeEntry {
        std::uint32_t slot = 0;
        std::uint32_t lastUpdate = 0;  ///< the update in which it last moved
        PartitionId partitionId = PartitionId::None;
        bool fixed = false;
        bool moved = false;        ///< has a new box since the last update
        bool isNew = false;        ///< had no box at the last update, or is to be treated so
        bool inMovedList = false;  ///< is in moved_
    };
    /// Shapes that share a tree, and the data that decides whether its order is still good.
    struct Partition {
        BlockTree tree;
        std::uint32_t changes = 0;     ///< shapes added and removed since it was sorted
        std::uint64_t moves = 0;       ///< moves of its shapes since then
        double halfPerimeterSum = 0;   ///< of its blocks when it was sorted [m]
        std::uint32_t movedCount = 0;  ///< how many of its shapes moved since the last update
        bool allMoved = false;         ///< so many moved that all count as moved
        bool needsRefit = false;       ///< all of its bounds have to be computed again
        bool grown = false;            ///< its blocks have grown since it was sorted
    };
    struct PairSink;

    /// Where a proxy is in the trees of a space that wraps: its box, shifted into the base image, and one more entry,
    /// an image of it, for each further periodic image that the box extends into.
    struct ImageRecord {
        ProxyId original = 0;
        Vec2 image{0, 0};             ///< offset of this image; (0, 0) for the shape itself [periods]
        Vec2 base{0, 0};              ///< of the shape itself: the image index of the lower corner of its box
        std::vector<ProxyId> images;  ///< of the shape itself: its other entries
    };
    struct ShiftedPair {
        Pair pair;
        Vec2 image{0, 0};
    };

    static Aabb shifted(const Aabb& box, const Vec2& shift) { return {box.lower + shift, box.upper + shift}; }
    ProxyId acquire();
    void setFilterKey(ProxyId proxy);
    /// The box that is stored in the trees.
    Aabb treeBox(ProxyId id) const { return wrap_.any() ? imageBox(id) : boxes_[id].box; }
    Aabb imageBox(ProxyId id) const;
    /// Periods between the box in the trees and where the shape is.
    Vec2 imageIndexOf(ProxyId id) const {
        return imageRecords_[imageRecords_[id].original].base + imageRecords_[id].image;
    }
    void updateImages(ProxyId id);
    void removeImages(ProxyId id);
    void addShiftedPair(ProxyId a, ProxyId b);
    void sortShiftedPairs();
    Vec2 lastImage(const Aabb& box) const;
    RayPart partInImage(const Vec2& halfSize, const Vec2& from, const Vec2& to, int axis, double image) const;
    void queryWrapped(std::span<const Partition> partitions, const Aabb& box, Visit visit) const;
    void castWrapped(const Vec2& halfSize, const Vec2& from, const Vec2& to, VisitWhile visit) const;
    void findNearWrapped(const Vec2& point, double within, VisitWhile visit) const;
    void castTrees(const Vec2& halfSize, const Vec2& from, const Vec2& to, const RayPart& part,
                   FunctionRef<double(ProxyId)> visit) const;

    RayPart clipToBounds(const Vec2& halfSize, const Vec2& from, const Vec2& to) const;
    void probe(const BoxProbe& probe, float limit, FunctionRef<float(ProxyId)> visit) const;
    void updateBox(ProxyId proxy, const Aabb& tight, double margin);
    void markMoved(ProxyId proxy);
    const Aabb& previousBox(ProxyId proxy) const {
        return entries_[proxy].moved ? previousBoxes_[proxy].box : boxes_[proxy].box;
    }
    Partition& partitionOf(PartitionId partitionId) { return partitions_[static_cast<std::size_t>(partitionId)]; }
    void leave(ProxyId proxy);
    void enter(ProxyId proxy, PartitionId partitionId);
    void updateEntries();
    bool isStale(const Partition& partition) const;
    void updateTree(Partition& partition);
    void sort(Partition& partition);
    void refillBoxes(Partition& partition);
    void putMovedBoxes(Partition& partition);
    void recenterOrigin();
    void searchPairs(const Partition& from, const Partition& in, bool otherSearched = false);
    void searchAllPairs();
    void sortPairs();
    void finishUpdate();
    void moveRestingBoxes();

    int lanes_;
    Wrap wrap_;
    std::uint32_t update_ = 0;
    std::vector<Proxy> proxies_;
    std::vector<AlignedBox> boxes_;
    std::vector<AlignedBox> previousBoxes_;  ///< of those that moved: the box at the last update
    std::vector<TreeEntry> entries_;
    std::vector<FilterKey> filterKeys_;
    std::uint32_t pairable_ = 0;  ///< number of shapes that pair with all others; without any, there are no pairs
    std::vector<ProxyId> free_;
    std::vector<ProxyId> moved_;
    std::array<Partition, partitionCount> partitions_;
    Vec2 origin_{0, 0};  ///< of the float coordinates [m]
    std::uint32_t originUpdate_ = 0;
    SortedPairs pairs_;
    std::vector<ImageRecord> imageRecords_;  ///< of each proxy and image, if the space wraps
    std::vector<ShiftedPair> shiftedPairs_;
    std::vector<Vec2> pairShifts_;
    SpaceWork work_;
    MortonSort mortonSort_;
    std::vector<Aabb> sortBoxes_;
    std::vector<ProxyId> unsorted_, sorted_;
    RadixSort<Pair, 8> pairSort_;
};

namespace periodic {

/// More images than this along an axis are not visited, however large a box is [-].
inline constexpr double maxImages = 64;

/// The trees store a shifted box: it is enlarged by the rounding error of that shift.
inline Aabb padded(const Aabb& box) {
    return inflate(box, 0x1p-48 * box.lower.cwiseAbs().cwiseMax(box.upper.cwiseAbs()).maxCoeff());
}

/// The number of whole numbers from first to last; 0 if one is not finite.
inline int countFrom(double first, double last) {
    constexpr double most = 1 << 20;  // a longer ray is cut off
    const double count = last - first + 1;
    return count > 0 ? static_cast<int>(std::min(count, most)) : 0;
}

template <class Visit>
void forEachImage(const Vec2& first, const Vec2& last, Visit&& visit) {
    const int columns = countFrom(first.x(), last.x()), rows = countFrom(first.y(), last.y());
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) visit(Vec2(first.x() + i, first.y() + j));
}

}  // namespace periodic

/// The last image that a box extends into, but no more than maxImages from the first.
inline Vec2 Space::lastImage(const Aabb& box) const {
    const Vec2 most = wrap_.imageIndex(box.lower) + Vec2::Constant(periodic::maxImages - 1);
    return wrap_.imageIndex(box.upper).cwiseMin(most);
}

template <class Visitor>
void Space::forEachShift(const Aabb& still, const Aabb& box, Visitor&& visitor) const {
    // One more image at both ends, because the division is rounded.
    const Vec2 one(wrap_.width ? 1 : 0, wrap_.height ? 1 : 0);
    const Vec2 first = wrap_.imageIndex(still.lower - box.upper) - one;
    const Vec2 most = first + Vec2::Constant(periodic::maxImages + 2);
    const Vec2 last = (wrap_.imageIndex(still.upper - box.lower) + one).cwiseMin(most);
    periodic::forEachImage(first, last, [&](const Vec2& image) {
        const Vec2 shift = wrap_.imageOffset(image);
        if (overlap(still, shifted(box, shift))) visitor(shift);
    });
}

}  // namespace plumb
