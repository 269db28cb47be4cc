// SPDX-License-Identifier: MIT
// On which grounds do bodies fall that may tip, wedge or tear them? All from a seed.
#pragma once
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>

namespace plumb::test {

enum class GroundKind { Flat, Boxes, Tiles, Chain, Discs, Capsules };
inline constexpr GroundKind roughGrounds[] = {GroundKind::Boxes, GroundKind::Tiles, GroundKind::Chain,
                                              GroundKind::Discs, GroundKind::Capsules};

/// Static bodies from x = -20 m to 20 m. The ground's surface is between y = 0 and 1.5 m.
struct Ground {
    std::vector<Vec2> outline;  ///< of a chain, from left to right; otherwise the ground is solid

    /// Is this point, the centre of a body, where it could only come through the surface?
    bool isBelow(const World& world, const Vec2& point) const;
};

Ground addGround(World& world, GroundKind kind, Random& random, double friction);

/// A bar, plank, stick, polygon or capsule whose longest half is 0.15 to 1.1 m.
ShapeDef randomFaller(Random& random, const Material& material);

}  // namespace plumb::test
