// SPDX-License-Identifier: MIT
// What was seen of one engine's run of one scene?
#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

inline constexpr double unsaid = std::numeric_limits<double>::quiet_NaN();  ///< not known, and nobody has to know it
inline constexpr double unbounded =
    std::numeric_limits<double>::infinity();  ///< the error of an engine that has to know it and does not

struct Observation {
    std::string engine;
    Role role = Role::Guest;
    std::string version;
    std::vector<Setting> settings;
    std::string unsupported;  ///< why the engine could not build the scene; empty when it could
    /// The engine may leave bodies and times out, as a closed form does: their states are not numbers. Where this is
    /// false, a state that is not a number is an infinite error.
    bool partial = false;
    double dt = 0;  ///< [s]
    /// [tick][body], tick 0 is the start: steps + 1 rows; none when the engine could not build the scene.
    std::vector<std::vector<BodyState>> states;
    /// [tick][probe]; NaN where the engine cannot say.
    std::vector<std::vector<double>> probes;
    /// [tick][joint] the size of the force in each, a mean over the step; NaN where the engine cannot say. None in a
    /// scene of more than 256 joints [N].
    std::vector<std::vector<double>> jointForces;
    /// [joint] the tick at which it was first seen broken; none for one that held. Ends with the last that broke.
    std::vector<std::optional<std::size_t>> brokenAt;
    std::optional<double> msPerStep;    ///< median of the run [ms]
    std::optional<std::uint64_t> hash;  ///< of the state after the run, from an engine that has one
};

/// Runs a scene in an engine and looks at it after every step. An engine that cannot build it is observed as such.
Observation observe(const Scene& scene, const Engine& engine);

/// Which joints had broken by a tick.
Broken brokenBy(const Observation& run, std::size_t tick);

/// What the probe watches can be told from where the bodies are and which joints have broken.
bool isSeen(const Probe& probe);

/// Every number of the state is finite.
bool isFinite(const BodyState& state);

}  // namespace plumb::compare
