// SPDX-License-Identifier: MIT
// Which bodies touch when they are at given places?
#pragma once
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/metric/solid_shapes.h>

namespace plumb::compare {

/// A contact of a body within a step.
struct Touch {
    std::size_t other = 0;  ///< its place in the scene
    Vec2 normal{0, 1};      ///< from the body to the other
};

/// Finds contacts from the places of bodies, without asking an engine.
class Touching {
public:
    /// Engines keep touching bodies apart by at most this [m].
    static constexpr double skin = 0.025;

    explicit Touching(const Scene& scene);

    /// The nearest of all bodies that the body touches, or may have reached, between two moments that are dt apart [s].
    /// Bodies no farther away than the skin count as touching.
    std::optional<Touch> nearest(std::size_t body, std::span<const BodyState> before, std::span<const BodyState> after,
                                 double dt) const;

    /// The pairs of bodies that touch, with the smaller place first.
    std::set<std::pair<std::size_t, std::size_t>> pairs(std::span<const BodyState> states) const;

    /// How far two bodies are from each other; negative if they overlap [m]. Infinite if they may not touch.
    double separation(std::size_t bodyA, std::size_t bodyB, std::span<const BodyState> states) const;

    /// True if the straight way from one point to another goes through the body, and the body is solid to `through`.
    bool isCrossed(std::size_t body, std::size_t through, std::span<const BodyState> states, const Vec2& from,
                   const Vec2& to) const;

private:
    struct Reach {
        SolidShape solid;
        Vec2 center{0, 0};  ///< of a disc around the shape, in the body's frame [m]
        double radius = 0;  ///< [m]
    };
    bool mayTouch(const Reach& a, const Reach& b) const;

    const Wrap& wrap_;
    std::vector<Reach> shapes_;
    std::vector<std::vector<std::size_t>> ofBody_;  // places of each body's shapes
    std::set<std::pair<std::size_t, std::size_t>> keptApart_;
};

}  // namespace plumb::compare
