// SPDX-License-Identifier: MIT
// What does an engine have to offer to be compared?
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

inline constexpr std::string_view plumbName = "plumb";
inline constexpr std::string_view closedFormName = "closed-form";
/// True for "box2d-2.4", "box2d-3" and whichever Box2D may come.
inline bool isBox2d(std::string_view engine) {
    return engine.starts_with("box2d");
}

struct BodyState {
    Vec2 position{0, 0};         ///< of the body's origin [m]
    double angle = 0;            ///< counted on through whole turns [rad]
    Vec2 velocity{0, 0};         ///< of the centre of mass [m/s]
    double angularVelocity = 0;  ///< [rad/s]
    bool present = true;         ///< false before it appears; then the rest says where it will
};

/// By place in the scene, whether a joint has broken; one that is not in the list has not.
using Broken = std::vector<bool>;

/// A part of a step.
struct Phase {
    std::string name;    ///< "pairs", "solve"
    double seconds = 0;  ///< [s]
};

/// One scene in one engine. Bodies and probes are in the scene's order.
class Simulation {
public:
    virtual ~Simulation() = default;
    /// Moves on by dt > 0 [s], in a scene's run by the same in every step. Does nothing beside the engine's own step
    /// that costs time in it: this is what is timed.
    virtual void step(double dt) = 0;
    /// An engine that keeps no count of turns counts them here, so angles are counted on when this is called after
    /// every step.
    virtual std::vector<BodyState> states() const = 0;
    /// Where the time of the last step went, as the engine tells it; phases that do not overlap.
    virtual std::vector<Phase> phases() const { return {}; }
    /// The value of each of the scene's probes now: forces as means over the last step, and what sensors have counted
    /// since the start. NaN where the engine cannot say, and of forces before the first step. What can be read from the
    /// states is NaN here.
    virtual std::vector<double> probeValues() const = 0;
    /// The state the world is in, as one number; none from an engine that has no such hash.
    virtual std::optional<std::uint64_t> stateHash() const { return {}; }
    /// Which joints have broken so far.
    virtual Broken brokenJoints() const { return {}; }
};

/// A name and a value, as the report lists them: "sub-steps", "4".
using Setting = std::pair<std::string, std::string>;

struct Engine {
    std::string name;     ///< "plumb", "box2d-2.4", "box2d-3", "chipmunk", "closed-form"
    std::string version;  ///< "2.4.1"
    /// The numbers that matter, as this scene is run.
    std::function<std::vector<Setting>(const Scene&)> settings;
    /// Throws Unsupported when the engine has no counterpart for something in the scene.
    std::function<std::unique_ptr<Simulation>(const Scene&)> build;
};

struct Unsupported : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The engines of this build, in the order plumb, box2d-2.4, box2d-3 where found, chipmunk, closed-form.
const std::vector<Engine>& engines();

}  // namespace plumb::compare
