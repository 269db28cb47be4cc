// SPDX-License-Identifier: MIT
// What do bounding volumes and broad phases say of bodies at one moment?
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <compare/scene/scene.h>
#include <compare/scene/state.h>
#include <plumb/broad/broad_phase.h>
#include <plumb/collide/overlap.h>
#include <plumb/shapes/bounding_circle.h>
#include <plumb/shapes/oriented_box.h>

namespace plumb::compare {

/// Around one shape of a body.
struct ShapeBounds {
    std::size_t body = 0;
    BoundingCircle circle{};
    Aabb upright{};
    OrientedBox oriented{};
};

/// Two shapes of different bodies, of which not both are static, and which of their bounds overlap.
struct BoundsPair {
    std::size_t a = 0, b = 0;  ///< indices of bodies
    bool circles = false, upright = false, oriented = false;
    std::optional<Overlap> shapes{};
};

/// How many tests a broad phase makes for the upright boxes of all shapes.
struct PairTests {
    BroadPhase way{};
    std::uint64_t tests = 0, pairs = 0;
};

/// In the order of bodies and shapes; without chains, tile maps and bodies that are not there.
std::vector<ShapeBounds> boundsOf(const Scene& scene, std::span<const BodyState> states);
/// None for more than 60 shapes.
std::vector<BoundsPair> boundsPairs(const Scene& scene, std::span<const BodyState> states);
/// In the order of broadPhases.
std::vector<PairTests> pairTests(const Scene& scene, std::span<const BodyState> states);

}  // namespace plumb::compare
