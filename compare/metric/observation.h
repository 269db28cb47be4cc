// SPDX-License-Identifier: MIT
// What was seen of one engine's run of one scene?
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
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
    /// The engine may leave bodies and times out, as a closed form does (see EngineCard::isPartial): their states are
    /// not numbers. Where this is false, a state that is not a number is an infinite error.
    bool partial = false;
    double dt = 0;  ///< [s]
    /// [tick][body], tick 0 is the start: steps + 1 rows; none when the engine could not build the scene.
    std::vector<std::vector<BodyState>> states;
    /// [tick][probe]; NaN where the engine cannot say.
    std::vector<std::vector<double>> probes;
    /// [tick][joint] the size of the force in each, a mean over the step; NaN where the engine cannot say. None in a
    /// scene of more than 256 joints [N].
    std::vector<std::vector<double>> jointForces;
    /// [tick][cause] the energy that came in or went out since the start, in the order of energyCauses; none from an
    /// engine that does not account for it [J].
    std::vector<std::vector<double>> energyByCause;
    /// [joint] the tick at which it was first seen broken; none for one that held. Ends with the last that broke.
    std::vector<std::optional<std::size_t>> brokenAt;
    std::optional<double> msPerStep;    ///< median of the run [ms]
    std::optional<std::uint64_t> hash;  ///< of the state after the run, from an engine that has one
};

/// A scene in an engine, step by step, observed after each. An engine that cannot build the scene is observed as such,
/// and has nothing to run.
class Run {
public:
    Run(const Scene& scene, const Engine& engine);
    ~Run();
    Run(Run&&) noexcept;

    bool isOver() const;
    /// Only if it is not over.
    void step();
    /// Null if the engine cannot build the scene.
    Simulation* simulation() { return simulation_.get(); }
    /// Of the steps so far.
    const Observation& seen() const { return seen_; }
    /// The same with the hash after them and the time of a step.
    Observation observation() &&;

private:
    class Recorder;
    std::unique_ptr<Recorder> recorder_;
    std::unique_ptr<Simulation> simulation_;
    Observation seen_;
    std::vector<double> milliseconds_{};
};

/// Runs a scene in an engine from start to end.
Observation observe(const Scene& scene, const Engine& engine);

/// It shows a track that the user brought.
inline bool isTrack(const Observation& run) {
    return run.partial && run.role != Role::Truth;
}

/// Which joints had broken by a tick.
Broken brokenBy(const Observation& run, std::size_t tick);

/// What the probe watches can be told from where the bodies are and which joints have broken.
bool isSeen(const Probe& probe);

/// Every number of the state is finite.
bool isFinite(const BodyState& state);

}  // namespace plumb::compare
