// SPDX-License-Identifier: MIT
// Which bodies touch, when they are somewhere?
#pragma once
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/metric/solid_shapes.h>

namespace plumb::compare {

/// What a body touches within a step.
struct Touch {
    std::size_t other = 0;  ///< its place in the scene
    Vec2 normal{0, 1};      ///< from the body to the other
};

/// Told from where bodies are, without asking any engine.
class Touching {
public:
    /// Engines keep what touches apart by up to so much [m].
    static constexpr double skin = 0.025;

    explicit Touching(const Scene& scene);

    /// What the body is nearest to of all that it touches, or can have reached, between two moments that lie dt apart
    /// [s]. What is no farther than the skin is touched.
    std::optional<Touch> nearest(std::size_t body, std::span<const BodyState> before, std::span<const BodyState> after,
                                 double dt) const;

    /// The pairs of bodies that touch, smaller place first.
    std::set<std::pair<std::size_t, std::size_t>> pairs(std::span<const BodyState> states) const;

    /// How far two bodies are from each other, negative where they overlap [m]. Infinite where they may not touch.
    double separation(std::size_t bodyA, std::size_t bodyB, std::span<const BodyState> states) const;

    /// The straight way from one point to another goes through the body, which is solid to `through`.
    bool isCrossed(std::size_t body, std::size_t through, std::span<const BodyState> states, const Vec2& from,
                   const Vec2& to) const;

private:
    struct Reach {
        SolidShape solid;
        Vec2 center{0, 0};  ///< of a disc around it, in the body's frame [m]
        double radius = 0;  ///< [m]
    };
    bool mayTouch(const Reach& a, const Reach& b) const;

    std::vector<Reach> shapes_;
    std::vector<std::vector<std::size_t>> ofBody_;  // places of its shapes
    std::set<std::pair<std::size_t, std::size_t>> keptApart_;
};

}  // namespace plumb::compare
