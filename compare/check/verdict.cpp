// SPDX-License-Identifier: MIT
#include <compare/check/verdict.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include <compare/check/answer.h>
#include <compare/closed_form/oracle.h>
#include <compare/engine/engine.h>

namespace plumb::compare {
namespace {

template <class Property, class Value>
const Engine* find(const std::vector<Engine>& engines, Property property, const Value& value) {
    const auto found = std::ranges::find(engines, value, property);
    return found == engines.end() ? nullptr : &*found;
}

void checkOptions(const RunOptions& options, const std::vector<Engine>& engines) {
    for (const std::string& name : options.engines)
        if (!find(engines, &Engine::name, name))
            throw std::invalid_argument(fmt::format("RunOptions.engines: \"{}\" is not an engine of this build", name));
    if (options.steps && *options.steps < 1)
        throw std::invalid_argument(fmt::format("RunOptions.steps: {} is not at least 1", *options.steps));
}

Scene asAsked(Scene scene, const RunOptions& options) {
    if (options.dt) scene.dt = *options.dt;
    if (options.steps) scene.duration = *options.steps * scene.dt;
    return scene;
}

bool asked(const RunOptions& options, const std::string& engine) {
    return options.engines.empty() ||
           std::find(options.engines.begin(), options.engines.end(), engine) != options.engines.end();
}

const Observation* observationOf(const SceneResult& result, Role role) {
    for (const EngineResult& run : result.engines)
        if (run.observation.role == role) return &run.observation;
    return nullptr;
}

}  // namespace

SceneResult runScene(const Scene& scene, const RunOptions& options, const std::vector<Engine>& engines) {
    checkOptions(options, engines);
    const Scene whole = asAsked(scene, options);
    validate(whole);
    validateEngineNames(whole);
    std::vector<Observation> runs;
    for (const Engine& engine : engines)
        if (asked(options, engine.name)) runs.push_back(observe(whole, engine));
    return resultOf(whole, std::move(runs), options, engines);
}

SceneResult resultOf(const Scene& scene, std::vector<Observation> observed, const RunOptions& options,
                     const std::vector<Engine>& engines) {
    SceneResult result;
    result.scene = scene;
    result.changed = options.changed;
    if (options.dt) result.changed.push_back(fmt::format("dt = {:.6g}", *options.dt));
    if (options.steps) result.changed.push_back(fmt::format("steps = {}", *options.steps));
    for (Observation& run : observed) result.engines.push_back({std::move(run), {}});
    const Engine* oracle = find(engines, &Engine::role, Role::Truth);
    const Observation truth = oracle ? observe(result.scene, *oracle) : Observation{};
    // What is worked out of the scene's numbers may hold for less long than the scene says.
    if (oracle && result.scene.closedForm && truth.unsupported.empty())
        result.scene.closedForm->until = workedOut(result.scene).until;
    const Observation* subject = observationOf(result, Role::Subject);
    for (EngineResult& run : result.engines) {
        const Observation* reference = &run.observation == subject ? nullptr : subject;
        run.measured = measure(result.scene, run.observation, &truth, reference);
        run.answer = answerOf(result.scene, run.observation, run.measured);
    }
    if (options.inDetail)
        for (EngineResult& run : result.engines)
            if (!run.observation.partial)
                run.ownSteps =
                    ownSteps(result.scene, *find(engines, &Engine::name, run.observation.engine), run.observation);
    std::vector<const Observation*> runs;
    for (const EngineResult& run : result.engines) runs.push_back(&run.observation);
    result.partings = partingsOf(result.scene, runs);
    if (options.inDetail) addPortions(result.scene, runs, result.partings);
    if (!options.changed.empty()) result.unjudged = metricsOfItsNumbers(result.scene, truth);
    result.outcomes = judge(result, engines);
    result.verdict = verdictOf(result.outcomes);
    return result;
}

}  // namespace plumb::compare
