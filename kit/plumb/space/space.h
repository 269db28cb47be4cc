// SPDX-License-Identifier: MIT
// Which placed shapes have come near each other?
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <plumb/broad/bvh.h>
#include <plumb/collide/convex.h>
#include <plumb/shapes/aabb.h>
#include <plumb/space/shape_def.h>

namespace plumb {

using ProxyId = std::uint32_t;

/// A shape in the space, owned by a body or mover.
struct Proxy {
    ShapeDef def;
    Convex convex;            ///< the shape as seen from the owner's centre of mass
    std::uint32_t owner = 0;  ///< an index its owner's side knows; shapes of one owner never pair
    bool fixed = false;       ///< never moves, and never pairs with another that is fixed
    bool alive = false;
    bool moved = false;  ///< got a new box since the last look for pairs
    Aabb box;            ///< holds the shape with room to spare
    Aabb previousBox;    ///< the box at the last look for pairs; empty for a new proxy
};

/// May these two collide, as far as owner and filter go?
bool mayPair(const Proxy& a, const Proxy& b);

/// Shapes with boxes that are larger than they need be, so that what rests or creeps is not looked at again.
class Space {
public:
    ProxyId add(const ShapeDef& def, std::uint32_t owner, bool fixed, const Vec2& localCenter, const Aabb& tight);
    void remove(ProxyId proxy);

    /// Tells where a shape is and will be; a box that no longer holds it is renewed with margin [m] to spare.
    void place(ProxyId proxy, const Aabb& tight, double margin);

    /// Lets the next look find all of a shape's pairs again, as if it were new.
    void renew(ProxyId proxy);

    /// Boxes overlap now and did not at the last call: sorted, each once. Pairs whose boxes overlapped before are the
    /// owner's to remember for as long as they do.
    SortedPairs takeNewPairs();

    const Proxy& operator[](ProxyId proxy) const { return proxies_[proxy]; }

private:
    void rebuildTrees();
    void collectPairs(ProxyId proxy, const Bvh& tree, const std::vector<ProxyId>& members, SortedPairs& pairs) const;

    std::vector<Proxy> proxies_;
    std::vector<ProxyId> free_;
    std::vector<ProxyId> movedProxies_;
    Bvh fixedTree_, movingTree_;
    std::vector<ProxyId> fixedMembers_, movingMembers_;
    bool fixedChanged_ = false;
};

}  // namespace plumb
