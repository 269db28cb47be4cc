// SPDX-License-Identifier: MIT
// How many bodies are where a wall should have kept them from going?
#pragma once
#include <optional>
#include <span>
#include <vector>

#include <compare/metric/solid_shapes.h>
#include <compare/scene/scene.h>
#include <compare/scene/state.h>
#include <plumb/shapes/mass.h>

namespace plumb::compare {

/// Told from where bodies are, without asking any engine. A wall is what is static or kinematic, and solid to the body.
class PassedWalls {
public:
    explicit PassedWalls(const Scene& scene);

    /// How many dynamic bodies have their centre of mass inside a wall, or to the left or right of all walls, or below
    /// them. Above them counts only without gravity: else the body may have been thrown over. A state that is not a
    /// number counts as passed. Empty in a scene without walls, and in one that wraps around.
    std::optional<std::size_t> count(std::span<const BodyState> states) const;

private:
    struct Moving {
        std::size_t body;
        Vec2 localCenter;  ///< of mass [m]
        std::vector<Filter> filters;
    };
    bool mayTouch(const Moving& moving, const SolidShape& wall) const;

    std::vector<SolidShape> walls_;
    std::vector<Moving> moving_;
    bool openAbove_;
};

}  // namespace plumb::compare
