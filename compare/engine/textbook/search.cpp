// SPDX-License-Identifier: MIT
#include <compare/engine/textbook/search.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include <compare/engine/engine_settings.h>
#include <compare/engine/textbook/frame_loop.h>
#include <plumb/collide/bisection.h>

namespace plumb::compare {
namespace {

const EngineNumber frameNumber{"frame", 0.1, 1e-4, 10};  // [s]
const EngineNumber probesNumber{"probes", 5, 0, 30};

/// The states that are shown, one a tick; the last one stays.
class Stages : public Simulation {
public:
    Stages(std::vector<std::vector<BodyState>> stages, std::size_t probes)
        : stages_(std::move(stages)), probes_(probes) {}

    void step(double) override { at_ = std::min(at_ + 1, stages_.size() - 1); }
    std::vector<BodyState> states() const override { return stages_[at_]; }
    std::vector<double> probeValues() const override {
        return std::vector<double>(probes_, std::numeric_limits<double>::quiet_NaN());
    }

private:
    std::vector<std::vector<BodyState>> stages_;
    std::size_t probes_, at_ = 0;
};

std::vector<BodyState> startOf(const Scene& scene) {
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies)
        states.push_back({body.def.position, body.def.angle, body.def.velocity, body.def.angularVelocity});
    return states;
}

/// The first dynamic body: the one that moves.
std::size_t moverOf(const Scene& scene) {
    const auto mover =
        std::ranges::find(scene.bodies, BodyType::Dynamic, [](const SceneBody& b) { return b.def.type; });
    if (mover == scene.bodies.end()) throw Unsupported("nothing moves: a dynamic body is wanted");
    return static_cast<std::size_t>(mover - scene.bodies.begin());
}

/// The states at a share of the frame, if nothing were in the way.
std::vector<BodyState> flownTo(const Scene& scene, double time) {
    std::vector<BodyState> states = startOf(scene);
    BodyState& body = states[moverOf(scene)];
    body.position += time * body.velocity;
    body.angle += time * body.angularVelocity;
    return states;
}

bool overlaps(const Scene& scene, const std::vector<BodyState>& states) {
    const std::size_t mover = moverOf(scene);
    const auto poseOf = [&](std::size_t i) { return Transform{states[i].position, Rot::fromAngle(states[i].angle)}; };
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        if (i == mover) continue;
        for (const ShapeDef& own : scene.bodies[mover].def.shapes)
            for (const ShapeDef& other : scene.bodies[i].def.shapes)
                if (overlap(own.shape, poseOf(mover), other.shape, poseOf(i))) return true;
    }
    return false;
}

std::vector<std::vector<BodyState>> bisectionStages(const Scene& scene, double frame, int probes) {
    std::vector<std::vector<BodyState>> stages{startOf(scene), flownTo(scene, frame)};
    const auto found =
        bisectCollision([&](double fraction) { return overlaps(scene, flownTo(scene, fraction * frame)); }, probes);
    if (found)
        for (const double probe : found->probes) stages.push_back(flownTo(scene, probe * frame));
    return stages;
}

Engine named(EngineCard card, std::vector<EngineNumber> numbers) {
    Engine engine;
    static_cast<EngineCard&>(engine) = std::move(card);
    engine.onDemand = true;
    engine.numbers = std::move(numbers);
    engine.settings = [name = engine.name, numbers = engine.numbers](const Scene& scene) {
        std::vector<Setting> said;
        for (const EngineNumber& number : numbers)
            said.emplace_back(number.name, fmt::format("{:g}", numberFor(name, number, scene)));
        return said;
    };
    return engine;
}

}  // namespace

Engine bisectionEngine() {
    EngineCard card;
    card.name = "bisection";
    card.label = card.product = "Bisection";
    card.look = {"#9c2a6b", "#f08cc4", {}, 2.5, true};
    Engine engine = named(card, {frameNumber, probesNumber});
    engine.build = [name = engine.name](const Scene& scene) {
        const double frame = numberFor(name, frameNumber, scene);
        const int probes = static_cast<int>(numberFor(name, probesNumber, scene));
        return std::make_unique<Stages>(bisectionStages(scene, frame, probes), scene.probes.size());
    };
    return engine;
}

Engine sweptTestEngine() {
    EngineCard card;
    card.name = "swept-test";
    card.label = card.product = "Swept test";
    card.look = {"#2b5f2b", "#88c988", {}, 2.5, true};
    Engine engine = named(card, {frameNumber});
    engine.build = [name = engine.name](const Scene& scene) {
        const double frame = numberFor(name, frameNumber, scene);
        Scene still = scene;
        still.gravity = {0, 0};
        FrameLoop loop(still, Integration::SemiImplicitEuler, CollisionTest::Swept);
        loop.advance(frame);
        std::vector<std::vector<BodyState>> stages{startOf(scene)};
        if (const std::optional<double> impact = loop.firstImpact()) stages.push_back(flownTo(scene, *impact * frame));
        stages.push_back(loop.states());
        return std::make_unique<Stages>(std::move(stages), scene.probes.size());
    };
    return engine;
}

}  // namespace plumb::compare
