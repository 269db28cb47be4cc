// SPDX-License-Identifier: MIT
// Which engines and scenes have known answers? Those whose states are written down here.
#pragma once
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <compare/engine/engine.h>
#include <compare/metric/observation.h>

namespace plumb::compare {

inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// Says what it is told to: states and probe values at a time.
struct Script {
    std::function<std::vector<BodyState>(double)> states;
    std::function<std::vector<double>(double)> probes = [](double) { return std::vector<double>{}; };
};

class ScriptedSimulation : public Simulation {
public:
    ScriptedSimulation(Script script, std::size_t probes) : script_(std::move(script)), probes_(probes) {}
    void step(double dt) override { time_ = dt * ++steps_; }
    std::vector<BodyState> states() const override { return script_.states(time_); }
    std::vector<double> probeValues() const override {
        std::vector<double> values = script_.probes(time_);
        values.resize(probes_, nan);
        return values;
    }

private:
    Script script_;
    std::size_t probes_;
    int steps_ = 0;
    double time_ = 0;
};

inline std::vector<Setting> noSettings(const Scene&) {
    return {};
}

/// With the part that the known engine of that name has.
inline Engine namedEngine(const std::string& name,
                          const std::function<std::unique_ptr<Simulation>(const Scene&)>& build) {
    Engine engine;
    engine.name = engine.label = engine.product = name;
    engine.version = "1";
    if (const Engine* known = findKnown(name)) {
        engine.role = known->role;
        engine.isPartial = known->isPartial;
    }
    engine.settings = noSettings;
    engine.build = build;
    return engine;
}

inline Engine scripted(const std::string& name, const Script& script) {
    return namedEngine(name, [script](const Scene& scene) {
        return std::make_unique<ScriptedSimulation>(script, scene.probes.size());
    });
}

inline Engine unsupporting(const std::string& name) {
    return namedEngine(name,
                       [](const Scene&) -> std::unique_ptr<Simulation> { throw Unsupported("it has no such thing"); });
}

/// One disc of 2 kg and radius 0.5 m, inertia 0.25 kg m^2, thrown up at 3 m/s from the origin under 10 m/s^2; ten steps
/// of 0.1 s. Its closed form is there, but until a closed-form engine is scripted nobody reads it.
inline Scene oneDisc() {
    Scene scene;
    scene.name = "one_disc";
    scene.gravity = {0, -10};
    scene.duration = 1;
    scene.dt = 0.1;
    SceneBody disc;
    disc.name = "disc";
    disc.def.velocity = {0, 3};
    disc.def.shapes = {circle(0.5)};
    disc.def.mass = Mass{2, {0, 0}, 0.25};
    scene.bodies = {disc};
    scene.closedForm = ClosedForm{"x = v t + g t^2 / 2", "textbook", 0, {}};
    scene.closedForm->bodies.push_back(PiecewiseMotion{"disc", {Flight{0, {0, 0}, {0, 3}, {0, -10}, 0, 0, 0}}});
    return scene;
}

/// The disc's state at a height.
inline BodyState at(double x, double y) {
    BodyState state;
    state.position = {x, y};
    return state;
}

/// An engine in which the disc stands still, off the origin by x.
inline Engine standing(const std::string& name, double x) {
    return scripted(name, {[x](double) { return std::vector<BodyState>{at(x, 0)}; }});
}

}  // namespace plumb::compare
