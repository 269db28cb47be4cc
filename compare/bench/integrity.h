// SPDX-License-Identifier: MIT
// Does a scene that is measured still do what it should?
#pragma once
#include <optional>
#include <span>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/metric/geometry.h>
#include <compare/metric/passed_walls.h>

namespace plumb::compare {

/// Told from the bodies' states, without asking any engine. Infinite where a state is not a number; empty where there
/// is no such thing in the scene.
struct Integrity {
    std::optional<double> highest{};           ///< dynamic body at the end: its origin's height [m]
    std::optional<double> overlap{};           ///< deepest of two bodies that may touch, of all looks [m]
    std::optional<double> jointGap{};          ///< largest of a joint that has not broken, of all looks [m]
    std::optional<std::size_t> passedWalls{};  ///< bodies that are where a wall should have kept them, at the end
};

/// Looks at a run from time to time. Each look takes a time, so no step is timed while it looks.
class IntegrityWatch {
public:
    explicit IntegrityWatch(const Scene& scene);

    void look(std::span<const BodyState> states, const Broken& broken);
    /// The last look is the end.
    const Integrity& seen() const { return seen_; }

private:
    Geometry geometry_;
    PassedWalls walls_;
    std::vector<std::size_t> dynamic_;
    Integrity seen_;
};

}  // namespace plumb::compare
