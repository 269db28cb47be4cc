// SPDX-License-Identifier: MIT
#include <compare/web/live.h>

#include <algorithm>
#include <chrono>
#include <stdexcept>

#include <compare/engine/engine.h>
#include <compare/engine/engines.h>

namespace plumb::compare {
namespace {

constexpr std::size_t mostBodies = 100;  // of a scene whose forces are kept

}  // namespace

Live::Live(Scene scene) : original_(std::move(scene)) {
    validate(original_);
    validateEngineNames(original_);
    scene_ = original_;
}

Scene Live::sceneToKeep() const {
    Scene kept = scene_;
    if (settings_.empty()) return kept;
    Observation truth;
    for (const Engine& engine : engines())
        if (engine.role == Role::Truth) truth = observe(scene_, engine);
    const std::vector<std::string> stale = metricsOfItsNumbers(scene_, truth);
    std::erase_if(kept.checks, [&](const Check& check) {
        const auto* invariant = std::get_if<InvariantCheck>(&check);
        return invariant && std::ranges::find(stale, invariant->metric) != stale.end();
    });
    return kept;
}

std::vector<std::string> Live::changed() const {
    std::vector<std::string> texts;
    for (const FieldSetting& setting : settings_) texts.push_back(setting.path + " = " + setting.value);
    return texts;
}

void Live::set(const FieldSetting& setting) {
    std::vector<FieldSetting> settings = settings_;
    std::erase_if(settings, [&](const FieldSetting& earlier) { return earlier.path == setting.path; });
    settings.push_back(setting);
    Scene scene = withFields(original_, settings);
    validateEngineNames(scene);
    scene_ = std::move(scene);
    settings_ = std::move(settings);
    runs_.clear();
}

void Live::reset() {
    settings_.clear();
    scene_ = original_;
    runs_.clear();
}

void Live::start(std::vector<std::string> engines) {
    engines_ = std::move(engines);
    pulls_.clear();
    begin();
}

void Live::bring(std::string_view csv, const std::string& file) {
    Engine made = mineEngine(ownTrackFrom(csv, file));
    (void)made.build(scene_);
    brought_ = std::move(made);
}

std::vector<Engine> Live::wanted() const {
    std::vector<Engine> wanted = enginesWith(engines_);
    std::erase_if(wanted, [&](const Engine& engine) {
        return !engines_.empty() && std::ranges::find(engines_, engine.name) == engines_.end();
    });
    if (brought_) wanted.push_back(*brought_);
    return wanted;
}

void Live::begin() {
    runs_.clear();
    for (const Engine& engine : wanted()) runs_.emplace_back(scene_, engine);
    pushes_.assign(runs_.size(), {{}});
    tick_ = 0;
}

bool Live::isOver() const {
    return std::ranges::all_of(runs_, &Run::isOver);
}

std::size_t Live::tick() const {
    return tick_;
}

void Live::stepTo(std::size_t tick) {
    const auto pull = std::ranges::find(pulls_, tick - 1, &Pull::tick);
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        Run& run = runs_[i];
        if (run.isOver()) continue;
        if (pull != pulls_.end()) run.simulation()->hold(pull->hand);
        run.step();
        if (scene_.bodies.size() <= mostBodies) pushes_[i].push_back(run.simulation()->pushes());
    }
    tick_ = tick;
}

void Live::advance(std::size_t tick, double milliseconds) {
    const auto start = std::chrono::steady_clock::now();
    const auto isInTime = [&] {
        const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
        return taken.count() < milliseconds;
    };
    const std::size_t last = std::min(tick, lastTick());
    if (tick_ < last && !isOver()) do
            stepTo(tick_ + 1);
        while (tick_ < last && isInTime());
}

const std::vector<Push>& Live::pushes(std::size_t run, std::size_t tick) const {
    static const std::vector<Push> none;
    const std::vector<std::vector<Push>>& ticks = pushes_.at(run);
    return tick < ticks.size() ? ticks[tick] : none;
}

void Live::hold(std::size_t tick, const std::optional<Hand>& hand) {
    if (hand && hand->body >= scene_.bodies.size()) throw std::invalid_argument("hold: there is no such body");
    std::erase_if(pulls_, [&](const Pull& pull) { return pull.tick >= tick; });
    pulls_.push_back({tick, hand});
    if (tick_ <= tick && !runs_.empty()) return;
    begin();
    while (tick_ < tick) stepTo(tick_ + 1);
}

SceneResult Live::resultOfRuns(bool inDetail) {
    std::vector<Observation> observed;
    for (Run& run : runs_) observed.push_back(std::move(run).observation());
    runs_.clear();
    RunOptions options;
    options.changed = changed();
    options.inDetail = inDetail;
    std::vector<Engine> known = enginesWith(engines_);
    if (brought_) known.push_back(*brought_);
    return resultOf(scene_, std::move(observed), options, known);
}

}  // namespace plumb::compare
