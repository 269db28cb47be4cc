// SPDX-License-Identifier: MIT
#include <compare/lab/lab.h>

#include <algorithm>

namespace plumb::compare {
namespace {

std::vector<Engine> simulators(const std::vector<std::string>& asked, const std::vector<Engine>& engines) {
    std::vector<Engine> result;
    for (const Engine& engine : engines) {
        const bool wanted = asked.empty() || std::ranges::find(asked, engine.name) != asked.end();
        if (wanted && engine.role != Role::Truth) result.push_back(engine);
    }
    return result;
}

LabOutcome outcomeOf(const LabCheck& check, const LabRun& run) {
    LabOutcome outcome{.check = check};
    const auto found = run.values.find(check.name);
    if (found == run.values.end()) return outcome;
    outcome.value = found->second;
    outcome.pass = check.bound == Bound::AtMost ? found->second <= check.limit : found->second >= check.limit;
    return outcome;
}

}  // namespace

LabResult runLab(const Lab& lab, const std::vector<std::string>& asked, const std::vector<Engine>& engines) {
    const std::vector<Engine> running = simulators(asked, engines);
    LabResult result{.lab = lab, .run = lab.run(running)};
    for (const LabCheck& check : lab.checks) {
        const auto isIts = [&](const Engine& engine) { return engine.name == check.engine; };
        if (!check.engine.empty() && std::ranges::none_of(running, isIts)) continue;
        result.outcomes.push_back(outcomeOf(check, result.run));
    }
    result.verdict = verdictOf(result.outcomes);
    return result;
}

}  // namespace plumb::compare
