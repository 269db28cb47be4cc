// SPDX-License-Identifier: MIT
// Until when does an engine's result not hang on the step?
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <compare/metric/observation.h>

namespace plumb::compare {

/// An engine's run beside its own at smaller steps.
struct OwnSteps {
    std::string engine{};
    double halved = 0;  ///< the largest distance of a body to its path at half the step [m]
    /// log2 of that over the same at half and a quarter of the step; if that is over 1 cm, the smaller one of this and
    /// the next, with an eighth. Empty if they are rounding [-]
    std::optional<double> order{};
    /// From when on half the step is more than 1 cm off the path at the whole step, and off that at a quarter, if at
    /// the end a further half leaves over 70 % of the distance: smaller steps do not lead to one result. Later
    /// differences to other engines decide nothing. Empty if they do lead to one, or no body is so far off [s].
    std::optional<double> horizon{};
};

/// Runs the engine at half, a quarter and, where it is needed, an eighth of the step, and compares. A body that is late
/// by one step of the run is on its path. run: of this scene in this engine.
OwnSteps ownSteps(const Scene& scene, const Engine& engine, const Observation& run);

/// "plumb: from 0.83 s on, half and a quarter of the step are over 1 cm apart ...: what differs later decides nothing."
/// Or how much half the step changes, if this can be seen; else empty.
std::string ownStepsText(const OwnSteps& steps);

}  // namespace plumb::compare
