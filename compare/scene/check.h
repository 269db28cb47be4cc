// SPDX-License-Identifier: MIT
// What must be true in a scene, and for which engine?
#pragma once
#include <string>
#include <variant>
#include <vector>

namespace plumb::compare {

/// The engine under test stays within limit of the closed form over the whole run. It is also no farther off than the
/// best of its peers, or than 1 mm.
struct ExactCheck {
    double limit = 1e-3;   ///< on error_max [m]
    std::string reason{};  ///< why this limit
};

/// The engine under test and each of its peers stay together until the horizon.
struct AgreeCheck {
    double tolerance = 0.01;  ///< on the largest distance between the same body in both [m]
    double until = 1;         ///< the horizon: before chaos or modelling differences take over [s]
    std::string reason{};
};

/// A metric of an engine's run stays within a bound.
struct InvariantCheck {
    std::string metric{};                ///< a metric's name: "energy_drift", "probe.normal_1", ...
    double limit = 0;                    ///< the metric is at most this, in its unit
    std::vector<std::string> engines{};  ///< the engines that it is for; none: the engine under test
    std::string reason{};
};

/// The error falls as dt^order, measured at dt, dt/2 and dt/4.
struct OrderCheck {
    double order = 2;                    ///< the observed order, log2 of the ratio of errors, is at least this [-]
    std::vector<std::string> engines{};  ///< the engines that it is for; none: the engine under test
    std::string reason{};
};

using Check = std::variant<ExactCheck, AgreeCheck, InvariantCheck, OrderCheck>;

}  // namespace plumb::compare
