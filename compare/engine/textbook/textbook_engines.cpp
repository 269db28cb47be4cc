// SPDX-License-Identifier: MIT
#include <compare/engine/engines.h>

#include <array>
#include <limits>
#include <string>
#include <utility>

#include <compare/engine/engine_settings.h>
#include <compare/engine/textbook/frame_loop.h>
#include <compare/engine/textbook/frames.h>
#include <compare/engine/textbook/search.h>

namespace plumb::compare {
namespace {

class LoopSimulation : public Simulation {
public:
    LoopSimulation(const Scene& scene, Integration integration, CollisionTest test)
        : loop_(scene, integration, test), probes_(scene.probes.size()) {}

    void step(double dt) override { loop_.advance(dt); }
    std::vector<BodyState> states() const override { return loop_.states(); }
    std::vector<double> probeValues() const override {
        return std::vector<double>(probes_, std::numeric_limits<double>::quiet_NaN());
    }

private:
    FrameLoop loop_;
    std::size_t probes_;
};

constexpr std::array tests{"overlap at the frame's end", "overlap at the frame's end, its time by bisection",
                           "swept test: impact, then the rest of the frame"};  // in the order of CollisionTest

const EngineNumber testNumber{"collisionTest", 0, 0, 2};

EngineCard cardOf(std::string name, std::string label, Look look) {
    EngineCard card;
    card.name = std::move(name);
    card.label = std::move(label);
    card.product = card.label;
    card.look = std::move(look);
    card.onDemand = true;
    return card;
}

Engine loopEngine(EngineCard card, Integration integration) {
    Engine engine;
    static_cast<EngineCard&>(engine) = std::move(card);
    engine.numbers = {testNumber};
    const auto testOf = [name = engine.name](const Scene& scene) {
        return static_cast<std::size_t>(numberFor(name, testNumber, scene));
    };
    engine.settings = [testOf](const Scene& scene) {
        return std::vector<Setting>{{"a step", "a frame of the game's loop"}, {"collisions", tests.at(testOf(scene))}};
    };
    engine.build = [integration, testOf](const Scene& scene) {
        return std::make_unique<LoopSimulation>(scene, integration, static_cast<CollisionTest>(testOf(scene)));
    };
    return engine;
}

Engine methodEngine(Integration integration) {
    struct Shown {
        const char *name, *label;
        Look look;
    };
    // In the order of Integration.
    static const Shown shown[] = {
        {"explicit-euler", "Explicit Euler", {"#b3261e", "#ff8a80", {3, 3}, 2}},
        {"semi-implicit-euler", "Semi-implicit Euler", {"#8a6d00", "#e0bd3c", {8, 3}, 2}},
        {"velocity-verlet", "Velocity Verlet", {"#5b3f9e", "#a68cf2", {8, 3, 2, 3}, 2}},
        {"midpoint", "Midpoint", {"#4d6b1f", "#a9cf6b", {5, 2}, 2}},
        {"rk4", "RK4", {"#00696f", "#4fd0d8", {12, 3}, 2}},
    };
    const Shown& own = shown[static_cast<std::size_t>(integration)];
    return loopEngine(cardOf(own.name, own.label, own.look), integration);
}

}  // namespace

std::vector<Engine> textbookEngines() {
    std::vector<Engine> engines;
    for (const IntegrationName& each : integrations) engines.push_back(methodEngine(each.integration));
    const Engine simple = loopEngine(cardOf("frame-loop", "", {}), Integration::SemiImplicitEuler);
    const FrameSettings display{.framesPerSecond = 24};
    engines.push_back(
        framed(simple, cardOf("game-loop", "Semi-implicit Euler, a step a frame", {"#7c4a9e", "#d3a6ee", {6, 4}, 2}),
               display));
    engines.push_back(framed(
        plumbEngine(), cardOf("plumb-frames", "Plumb, a step a frame", {"#3d5a80", "#9db8de", {10, 4}, 2}), display));
    EngineCard other = cardOf("box2d-3-frames", "Box2D 3, a step a frame", {"#3c7d5b", "#7fd0a6", {2, 4}, 2});
    const Engine rival = box2d3Engine();
    other.missing = rival.missing;
    engines.push_back(framed(rival, other, display));
    engines.push_back(framed(plumbEngine(),
                             cardOf("fixed-clock", "Plumb, by a fixed clock", {"#964b00", "#f0a35e", {}, 2, true}),
                             {.framesPerSecond = 24, .interval = 0.02}));
    engines.push_back(bisectionEngine());
    engines.push_back(sweptTestEngine());
    return engines;
}

}  // namespace plumb::compare
