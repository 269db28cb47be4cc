// SPDX-License-Identifier: MIT
#include <compare/engine/textbook/frames.h>

#include <fmt/format.h>

#include <utility>

#include <compare/engine/engine_settings.h>
#include <plumb/stepping/interpolate.h>

namespace plumb::compare {
namespace {

constexpr double roundingOfTime = 1e-9;  // [s]

std::vector<BodyState> between(const std::vector<BodyState>& before, const std::vector<BodyState>& now,
                               double fraction) {
    std::vector<BodyState> result = now;
    for (std::size_t i = 0; i < now.size(); ++i) {
        result[i].position = interpolate(before[i].position, now[i].position, fraction);
        result[i].angle = interpolate(before[i].angle, now[i].angle, fraction);
    }
    return result;
}

/// When the frames of a display end.
class Display {
public:
    explicit Display(const FrameSettings& settings) : settings_(settings) { draw(); }

    /// Ends the frame whose end is next, and gives its length [s].
    double takeFrame() {
        const double length = next_ - time_;
        time_ = next_;
        ++frames_;
        draw();
        return length;
    }
    double next() const { return next_; }

private:
    void draw() {
        const double mean = 1 / settings_.framesPerSecond, off = settings_.unevenness;
        // The ends of even frames are counted, because a sum of lengths would drift by rounding.
        next_ = off == 0 ? static_cast<double>(frames_ + 1) / settings_.framesPerSecond
                         : time_ + mean * random_.uniform(1 - off, 1 + off);
    }

    FrameSettings settings_;
    Random random_{24};
    double time_ = 0, next_ = 0;  // of the last end, and of the next one [s]
    std::int64_t frames_ = 0;
};

/// What a clock does about a stall is not asked here.
std::optional<ClockSettings> clockOf(const FrameSettings& settings) {
    if (settings.interval == 0) return {};
    return ClockSettings{.interval = settings.interval, .longestElapsed = 100};
}

class FramedSimulation : public Simulation {
public:
    FramedSimulation(std::unique_ptr<Simulation> inner, const FrameSettings& settings)
        : inner_(std::move(inner)),
          display_(settings),
          loop_({[this](double dt) { inner_->step(dt); }, [this] { return inner_->states(); }}, clockOf(settings),
                settings.isInterpolated) {}

    void step(double dt) override {
        const double now = ++steps_ * dt;
        while (display_.next() <= now + roundingOfTime) loop_.frame(display_.takeFrame());
    }
    std::vector<BodyState> states() const override { return loop_.shown(); }
    std::vector<double> probeValues() const override { return inner_->probeValues(); }
    Broken brokenJoints() const override { return inner_->brokenJoints(); }
    void hold(const std::optional<Hand>& hand) override { inner_->hold(hand); }

private:
    std::unique_ptr<Simulation> inner_;
    Display display_;
    FramedLoop loop_;
    int steps_ = 0;
};

std::vector<EngineNumber> numbersOf(const FrameSettings& defaults) {
    std::vector<EngineNumber> numbers{{"framesPerSecond", defaults.framesPerSecond, 0.5, 1000},
                                      {"unevenness", defaults.unevenness, 0, 0.95}};
    if (defaults.interval > 0) {
        numbers.push_back({"interval", defaults.interval, 1e-3, 1});
        numbers.push_back({"interpolated", defaults.isInterpolated ? 1.0 : 0.0, 0, 1});
    }
    return numbers;
}

FrameSettings settingsFor(const std::string& engine, const std::vector<EngineNumber>& numbers, const Scene& scene) {
    FrameSettings settings;
    settings.framesPerSecond = numberFor(engine, numbers[0], scene);
    settings.unevenness = numberFor(engine, numbers[1], scene);
    if (numbers.size() > 2) {
        settings.interval = numberFor(engine, numbers[2], scene);
        settings.isInterpolated = numberFor(engine, numbers[3], scene) != 0;
    }
    return settings;
}

}  // namespace

FramedLoop::FramedLoop(Stepped stepped, const std::optional<ClockSettings>& clock, bool isInterpolated)
    : stepped_(std::move(stepped)), isInterpolated_(isInterpolated) {
    if (clock) clock_.emplace(*clock);
    before_ = shown_ = stepped_.states();
}

void FramedLoop::frame(double length) {
    ++frames_;
    if (!clock_) {
        stepped_.step(length);
        shown_ = stepped_.states();
        return;
    }
    const Ticks ticks = clock_->advance(length);
    for (int tick = 0; tick < ticks.due; ++tick) {
        before_ = stepped_.states();
        stepped_.step(clock_->interval());
    }
    const std::vector<BodyState> now = stepped_.states();
    shown_ = isInterpolated_ ? between(before_, now, ticks.fraction) : now;
}

Engine framed(const Engine& inner, EngineCard card, const FrameSettings& defaults) {
    Engine engine;
    static_cast<EngineCard&>(engine) = std::move(card);
    engine.version = inner.version;
    engine.numbers = numbersOf(defaults);
    const auto settingsOf = [name = engine.name, numbers = engine.numbers](const Scene& scene) {
        return settingsFor(name, numbers, scene);
    };
    engine.settings = [settingsOf](const Scene& scene) {
        const FrameSettings settings = settingsOf(scene);
        std::vector<Setting> said{{"frames a second", fmt::format("{:g}", settings.framesPerSecond)}};
        if (settings.unevenness > 0)
            said.emplace_back("a frame's length", fmt::format("{:g} to {:g} of the mean", 1 - settings.unevenness,
                                                              1 + settings.unevenness));
        said.emplace_back("a step", settings.interval > 0 ? fmt::format("{:g} s, by a fixed clock", settings.interval)
                                                          : "as long as the frame");
        return said;
    };
    if (!inner.build) return engine;
    engine.build = [build = inner.build, settingsOf](const Scene& scene) {
        for (const SceneBody& body : scene.bodies)
            if (!isAlwaysThere(body)) throw Unsupported("frame by frame, no bodies come later: " + body.name);
        return std::make_unique<FramedSimulation>(build(scene), settingsOf(scene));
    };
    return engine;
}

}  // namespace plumb::compare
