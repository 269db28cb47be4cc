// SPDX-License-Identifier: MIT
// Does a scene that is measured still do what it should?
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <optional>
#include <span>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/metric/geometry.h>
#include <compare/metric/passed_walls.h>

namespace plumb::compare {

/// Computed from the bodies' states only, not by any engine. A value is infinite if a state is not a number, and empty
/// if the scene has nothing of that kind.
struct Integrity {
    std::optional<double> highest{};           ///< height of the highest dynamic body's origin at the end [m]
    std::optional<double> overlap{};           ///< deepest overlap of two bodies that may touch, of all looks [m]
    std::optional<double> jointGap{};          ///< largest gap of a joint that has not broken, of all looks [m]
    std::optional<std::size_t> passedWalls{};  ///< bodies that have passed a wall at the end
};

/// True if the result is of no use: a joint has opened by more than a metre, or a state was not a number. Its time
/// counts for nothing then.
bool isBroken(const Integrity& seen);

/// Looks at a run from time to time. A look takes time, so no step is timed during a look.
class IntegrityWatch {
public:
    explicit IntegrityWatch(const Scene& scene);

    void look(std::span<const BodyState> states, const Broken& broken);
    /// The last look counts as the end.
    const Integrity& seen() const { return seen_; }

private:
    Geometry geometry_;
    PassedWalls walls_;
    std::vector<std::size_t> dynamic_;
    Integrity seen_;
};

/// {"highest","overlap","joint_gap","passed_walls"}; null if there is no value. JSON has no infinite numbers: they are
/// written as "infinite".
nlohmann::ordered_json integrityJson(const Integrity& seen);

Integrity integrityFrom(const nlohmann::ordered_json& json);

}  // namespace plumb::compare
