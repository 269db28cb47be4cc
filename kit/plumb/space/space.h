// SPDX-License-Identifier: MIT
// Which placed shapes have come near each other?
#pragma once
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
    Convex convex;             ///< the shape as seen from the owner's centre of mass
    std::uint32_t owner = 0;   ///< an index its owner's side knows; shapes of one owner never pair
    std::uint32_t number = 0;  ///< which of its owner's shapes it is, or is a piece of
    bool piece = false;        ///< of a chain or a tile map
    PieceUse use = PieceUse::Both;
    bool fixed = false;  ///< never moves by itself, and never pairs with another that is fixed
    bool alive = false;
};

/// What decides whether two shapes may collide: little, for it is asked often.
struct Gate {
    std::uint64_t category = 1, mask = ~std::uint64_t{0};
    std::uint32_t owner = 0;
    int group = 0;
    bool fixed = false;
    bool sensor = false;
    bool touched = true;  ///< there to be touched, and not only to be found by queries
    bool asked = true;    ///< there to be found by queries
};

/// As far as their filters go.
inline bool mayMeet(const Gate& a, const Gate& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

inline bool mayPair(const Gate& a, const Gate& b) {
    return a.owner != b.owner && !(a.fixed && b.fixed) && !(a.sensor && b.sensor) && a.touched && b.touched &&
           mayMeet(a, b);
}

inline Gate gateOf(const Proxy& proxy) {
    const Filter& filter = proxy.def.filter;
    const bool touched = proxy.use == PieceUse::Both || proxy.use == PieceUse::Touch;
    const bool asked = proxy.use == PieceUse::Both || proxy.use == PieceUse::Ask;
    return {filter.category, filter.mask, proxy.owner, filter.group, proxy.fixed, proxy.def.sensor, touched, asked};
}

/// May these two collide, as far as owner and filter go?
inline bool mayPair(const Proxy& a, const Proxy& b) {
    return mayPair(gateOf(a), gateOf(b));
}

/// What the last look for pairs took, counted, so that it is the same on any machine.
struct SpaceWork {
    std::uint32_t placed = 0;      ///< shapes that were new, renewed, or had left their boxes
    std::uint32_t sorted = 0;      ///< shapes whose order along the curve was made anew
    std::uint64_t blockTests = 0;  ///< 16 boxes against one
    std::uint64_t boxTests = 0;    ///< one box against the 16 of a block, one by one
};

/// Shapes with boxes that are larger than they need be, so that what rests or creeps is not looked at again.
/// Three hierarchies: of what was placed lately, of what was not, and of what is fixed. A look for pairs costs in
/// proportion to what was placed anew since the last; all else is only met where it lies in the way.
/// The hierarchies are of floats, counted from near what moves, and find a few pairs too many; what they find is tested
/// in double.
/// A space may wrap around. Places are then those that its owner goes by, in whichever round; what is found comes with
/// the shift, of whole rounds, that brings it to where it was found: visit(id, shift). One that takes the id alone is
/// for a space that does not wrap. A shape may be found more than once, with different shifts.
class Space {
public:
    /// lanes: boxes tested at once, 1, 4, 8 or 16; no more than the machine has. The pairs are the same for any.
    explicit Space(int lanes = 16, const Wrap& wrap = {}) : lanes_(lanes), wrap_(wrap) {}
    void setLanes(int lanes) { lanes_ = lanes; }
    /// Of a space that is empty yet.
    void setWrap(const Wrap& wrap) { wrap_ = wrap; }
    const Wrap& wrap() const { return wrap_; }

    ProxyId add(const ShapeDef& def, std::uint32_t owner, bool fixed, const Vec2& localCenter, const Aabb& tight,
                std::uint32_t number = 0, bool piece = false, PieceUse use = PieceUse::Both);
    void remove(ProxyId proxy);

    /// Takes a shape out until it is placed and renewed; it keeps its id.
    void hide(ProxyId proxy);
    /// Another material, filter or tag, or another way to meet what it meets; the outline stays. What has come to pair
    /// thereby is the owner's to find, or to renew.
    void change(ProxyId proxy, const ShapeDef& def);
    /// Now fixed, or not any more, and seen from another centre of mass. To be renewed if fixed has changed.
    void change(ProxyId proxy, bool fixed, const Vec2& localCenter);

    /// Tells where a shape is and will be; a box that no longer holds it, or holds far too much, is renewed with
    /// margin [m] to spare.
    void place(ProxyId proxy, const Aabb& tight, double margin) {
        const Aabb& now = placed_[proxy].box;
        if (!contains(now, tight) || !contains(inflate(tight, loosest * margin), now)) renewBox(proxy, tight, margin);
    }

    /// Lets the next look find all of a shape's pairs again, as if it were new.
    void renew(ProxyId proxy);

    /// Boxes overlap now and did not at the last call: sorted, each once; holds until the next call. Pairs whose boxes
    /// overlapped before are the owner's to remember for as long as they do.
    const SortedPairs& takeNewPairs();
    /// What b of each of these pairs is to be shifted by to overlap a, if the space wraps; else none. A pair that
    /// overlaps with two shifts is two pairs.
    std::span<const Vec2> newPairShifts() const { return pairShifts_; }

    /// Told of a shape, and of the shift by which it was found in a space that wraps.
    using Visit = FunctionRef<void(ProxyId, const Vec2&)>;
    /// The same; says up to which fraction of a way, or which distance, more is wanted.
    using VisitWhile = FunctionRef<double(ProxyId, const Vec2&)>;

    /// Calls visit for each shape whose box overlaps or touches the given one, wherever it was placed by now.
    void query(const Aabb& box, Visit visit) const;

    /// The same for those that are fixed.
    void queryFixed(const Aabb& box, Visit visit) const;

    /// Calls visit for each shape whose box something of this half size may meet that moves from one point to
    /// another, those on its way sooner as far as they are known to be; visit returns up to which fraction of the way
    /// more is wanted, at first and at most 1.
    void castBox(const Vec2& halfSize, const Vec2& from, const Vec2& to, VisitWhile visit) const;

    /// The same for each whose box may be no farther from a point than within [m], at first; visit returns a new
    /// within.
    void findNear(const Vec2& point, double within, VisitWhile visit) const;

    const Gate& gate(ProxyId proxy) const { return gates_[proxy]; }
    const Proxy& operator[](ProxyId proxy) const { return proxies_[proxy]; }
    /// Holds the shape, with room to spare.
    const Aabb& box(ProxyId proxy) const { return placed_[proxy].box; }
    bool boxesOverlap(ProxyId a, ProxyId b) const { return overlap(placed_[a].box, placed_[b].box); }
    /// Did they, at the last look for pairs?
    bool previousBoxesOverlap(ProxyId a, ProxyId b) const { return overlap(previousBox(a), previousBox(b)); }
    // The same with b shifted.
    bool boxesOverlap(ProxyId a, ProxyId b, const Vec2& shift) const {
        return overlap(placed_[a].box, shifted(placed_[b].box, shift));
    }
    bool previousBoxesOverlap(ProxyId a, ProxyId b, const Vec2& shift) const {
        return overlap(previousBox(a), shifted(previousBox(b), shift));
    }
    /// Do the hierarchies have it whole? Not if its box reaches into more rounds than they follow.
    bool isWhole(ProxyId id) const;
    /// Calls visit(shift) for each with which a box, shifted, overlaps another; up to 64 along an axis.
    template <class Look>
    void forEachShift(const Aabb& still, const Aabb& box, Look&& look) const;
    /// The same for the boxes of two shapes at the last look for pairs.
    template <class Look>
    void forEachPreviousShift(ProxyId still, ProxyId other, Look&& look) const {
        forEachShift(previousBox(still), previousBox(other), look);
    }

    /// Makes room for so many shapes.
    void reserve(std::size_t shapes);
    /// Of memory that it holds.
    std::size_t bytes() const;

    const SpaceWork& work() const { return work_; }

private:
    /// A box is renewed when it has more than this many margins to spare [-].
    static constexpr double loosest = 4;

    enum class Home : std::uint8_t { None, Moving, Resting, Fixed };
    static constexpr std::size_t homes = 4;

    struct alignas(32) PlacedBox {
        Aabb box;
    };
    /// Where a proxy stands in the hierarchies.
    struct Seat {
        std::uint32_t slot = 0;
        std::uint32_t lastPlaced = 0;  ///< the look that found it placed
        Home home = Home::None;
        bool fixed = false;
        bool moved = false;   ///< has a new box since the last look
        bool fresh = false;   ///< had none at the last look, or is to be taken as if
        bool listed = false;  ///< stands in moved_
    };
    /// Shapes that have one hierarchy in common, and what tells whether its order is still good.
    struct Crowd {
        BlockTree tree;
        std::uint32_t changes = 0;   ///< added and taken out since its order was made
        std::uint64_t placings = 0;  ///< of its members since then
        double looseness = 0;        ///< when its order was made [m]
        std::uint32_t moved = 0;     ///< how many of it did since the last look
        bool allMoved = false;       ///< so many did that all are taken to have
        bool refit = false;          ///< all of its bounds are to be made anew
        bool loose = false;          ///< its blocks have grown since
    };
    struct Finding;

    /// Where a proxy stands in the hierarchies of a space that wraps: its box, shifted into the first round, and an
    /// image of it, another member there, for each further round that it reaches into.
    struct Rounds {
        ProxyId real = 0;
        Vec2 image{0, 0};             ///< which image it is: so many rounds less; (0, 0) of the shape itself
        Vec2 first{0, 0};             ///< of the shape itself: the round of its box's lower corner
        std::vector<ProxyId> images;  ///< likewise
    };
    struct ShiftedPair {
        Pair pair;
        Vec2 rounds{0, 0};
    };

    static Aabb shifted(const Aabb& box, const Vec2& shift) { return {box.lower + shift, box.upper + shift}; }
    ProxyId acquire();
    /// As it stands in the hierarchies.
    Aabb seatBox(ProxyId id) const { return wrap_.any() ? imageBox(id) : placed_[id].box; }
    Aabb imageBox(ProxyId id) const;
    /// Where the hierarchies have it, from where it is.
    Vec2 roundsOf(ProxyId id) const { return rounds_[rounds_[id].real].first + rounds_[id].image; }
    void seatImages(ProxyId id);
    void dropImages(ProxyId id);
    void takeShifted(ProxyId a, ProxyId b);
    void sortShiftedPairs();
    Vec2 lastRound(const Aabb& box) const;
    RayPart partInRound(const Vec2& halfSize, const Vec2& from, const Vec2& to, int axis, double round) const;
    void queryAround(std::span<const Crowd> crowds, const Aabb& box, Visit visit) const;
    void castAround(const Vec2& halfSize, const Vec2& from, const Vec2& to, VisitWhile visit) const;
    void findAround(const Vec2& point, double within, VisitWhile visit) const;
    void castTrees(const Vec2& halfSize, const Vec2& from, const Vec2& to, const RayPart& part,
                   FunctionRef<double(ProxyId)> visit) const;

    RayPart partWithin(const Vec2& halfSize, const Vec2& from, const Vec2& to) const;
    void probe(const BoxProbe& probe, float limit, FunctionRef<float(ProxyId)> visit) const;
    void renewBox(ProxyId proxy, const Aabb& tight, double margin);
    void markMoved(ProxyId proxy);
    const Aabb& previousBox(ProxyId proxy) const {
        return seats_[proxy].moved ? previousBoxes_[proxy].box : placed_[proxy].box;
    }
    Crowd& crowdOf(Home home) { return crowds_[static_cast<std::size_t>(home)]; }
    void leave(ProxyId proxy);
    void enter(ProxyId proxy, Home home);
    void seatMoved();
    bool isStale(const Crowd& crowd) const;
    void bringUp(Crowd& crowd);
    void sort(Crowd& crowd);
    void fill(Crowd& crowd);
    void putMoved(Crowd& crowd);
    void follow();
    void find(const Crowd& from, const Crowd& in, bool otherHasAsked = false);
    void findAll();
    void sortPairs();
    void settle();
    void letRest();

    int lanes_;
    Wrap wrap_;
    std::uint32_t look_ = 0;
    std::vector<Proxy> proxies_;
    std::vector<PlacedBox> placed_;
    std::vector<PlacedBox> previousBoxes_;  ///< of those that moved: the box at the last look
    std::vector<Seat> seats_;
    std::vector<Gate> gates_;
    std::vector<ProxyId> free_;
    std::vector<ProxyId> moved_;
    std::array<Crowd, homes> crowds_;
    Vec2 origin_{0, 0};  ///< of the floats [m]
    std::uint32_t originLook_ = 0;
    SortedPairs pairs_;
    std::vector<Rounds> rounds_;  ///< of each proxy and image, if the space wraps
    std::vector<ShiftedPair> shiftedPairs_;
    std::vector<Vec2> pairShifts_;
    SpaceWork work_;
    MortonSort mortonSort_;
    std::vector<Aabb> sortBoxes_;
    std::vector<ProxyId> unsorted_, sorted_;
    RadixSort<Pair, 8> pairSort_;
};

}  // namespace plumb

#include <plumb/space/space_around.h>
