// SPDX-License-Identifier: MIT
#include <compare/engine/engines.h>

#include <limits>

#include <compare/closed_form/oracle.h>

namespace plumb::compare {
namespace {

class ClosedFormSimulation : public Simulation {
public:
    /// Throws Unsupported if a motion cannot be computed from the scene's numbers.
    explicit ClosedFormSimulation(const Scene& scene) : scene_(scene) { scene_.closedForm = workedOut(scene); }

    // Time is computed from the number of steps: a sum of steps would drift by rounding.
    void step(double dt) override { time_ = dt * ++steps_; }
    std::vector<BodyState> states() const override { return closedFormStates(scene_, time_); }
    std::vector<double> probeValues() const override {
        return std::vector<double>(scene_.probes.size(), std::numeric_limits<double>::quiet_NaN());
    }

private:
    Scene scene_;
    int steps_ = 0;
    double time_ = 0;
};

std::vector<Setting> closedFormSettings(const Scene& scene) {
    if (!scene.closedForm) return {};
    return {{"formula", scene.closedForm->formula}, {"source", scene.closedForm->source}};
}

}  // namespace

Engine closedFormEngine() {
    Engine engine;
    engine.name = "closed-form";
    engine.label = engine.product = "Closed form";
    engine.role = Role::Truth;
    engine.isPartial = true;
    engine.look = {"#1b222c", "#f2f2f2", {3, 4}, 2, false, true};
    engine.settings = closedFormSettings;
    engine.build = [](const Scene& scene) {
        if (!scene.closedForm) throw Unsupported("the scene has no closed form");
        return std::make_unique<ClosedFormSimulation>(scene);
    };
    return engine;
}

}  // namespace plumb::compare
