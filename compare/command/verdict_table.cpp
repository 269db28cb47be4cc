// SPDX-License-Identifier: MIT
#include <compare/command/verdict_table.h>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <ostream>

#include <compare/command/verdict_words.h>
#include <compare/engine/engine_settings.h>
#include <compare/metric/length_text.h>

namespace plumb::compare {
namespace {

constexpr int engineWidth = 11;

std::string cell(const SceneResult& result, const std::string& engine) {
    for (const EngineResult& run : result.engines) {
        if (run.observation.engine != engine) continue;
        if (!run.observation.unsupported.empty()) return "unsupported";
        const auto metric = [&](const char* name) {
            const auto found = run.measured.metrics.find(name);
            return found == run.measured.metrics.end() ? std::nullopt : found->second;
        };
        if (const std::optional<double> error = metric("error_max")) return lengthText(*error);
        const std::optional<double> apart = result.scene.closedForm ? std::nullopt : metric("divergence_max");
        return apart ? fmt::format("({})", lengthText(*apart)) : "-";
    }
    return "-";
}

/// "344 checks: 338 of a, 6 of b." and the line's end. Empty if nothing was judged.
std::string boundText(std::span<const SceneResult> results) {
    std::map<std::string, std::size_t> bound;
    std::size_t checks = 0;
    for (const SceneResult& result : results)
        for (const Outcome& outcome : result.outcomes) {
            ++bound[outcome.engine];
            ++checks;
        }
    std::vector<std::string> parts;
    for (const Engine& engine : knownEngines())
        if (bound.contains(engine.name)) parts.push_back(fmt::format("{} of {}", bound[engine.name], engine.name));
    return parts.empty() ? ""
                         : fmt::format("{} check{}: {}.\n", checks, checks == 1 ? "" : "s", fmt::join(parts, ", "));
}

}  // namespace

std::string failureText(const Scene& scene, const Outcome& outcome) {
    const bool order = outcome.check == "order";
    const std::string unit = order ? "" : metricUnit(scene, outcome.metric);
    const std::string space = unit.empty() ? "" : " ";
    const std::string bound = fmt::format("{:.4g}{}{}", outcome.limit, space, unit);
    const std::string head = fmt::format("{}: {} {}", outcome.check, outcome.engine, outcome.metric);
    const std::string why = outcome.reason.empty() ? "" : " (the limit: " + outcome.reason + ")";
    if (!outcome.value && !outcome.missing.empty()) return fmt::format("{} is not known: {}", head, outcome.missing);
    if (!outcome.value)
        return fmt::format("{} does not exist, wanted {} {}{}", head, order ? "at least" : "at most", bound, why);
    return fmt::format("{} is {:.4g}{}{}, {} {}{}", head, *outcome.value, space, unit, order ? "under" : "over", bound,
                       why);
}

VerdictTable::VerdictTable(std::ostream& out, std::vector<std::string> engines, std::span<const Scene> scenes,
                           bool colour)
    : out_(out), engines_(std::move(engines)), nameWidth_(5), colour_(colour) {
    for (const Scene& scene : scenes) nameWidth_ = std::max(nameWidth_, scene.name.size());
}

void VerdictTable::head() const {
    fmt::print(out_, "{:6}{:{}}  largest distance to the closed form; in brackets, where there is none: to {}\n", "",
               "", nameWidth_, subjectName());
    fmt::print(out_, "{:6}{:{}}", "", "scene", nameWidth_);
    for (const std::string& engine : engines_) fmt::print(out_, "  {:>{}}", engine, engineWidth);
    fmt::print(out_, "  checks that hold\n");
    out_.flush();
}

void VerdictTable::row(const SceneResult& result) const {
    const auto held = static_cast<std::size_t>(
        std::count_if(result.outcomes.begin(), result.outcomes.end(), [](const Outcome& o) { return o.pass; }));
    fmt::print(out_, "{}  {:{}}", verdictWord(result.verdict, colour_), result.scene.name, nameWidth_);
    for (const std::string& engine : engines_) fmt::print(out_, "  {:>{}}", cell(result, engine), engineWidth);
    if (result.verdict == Verdict::NotJudged)
        fmt::print(out_, "  {}\n", painted(notJudgedText("scene", result.scene.checks.size()), grey, colour_));
    else
        fmt::print(out_, "  {} of {}\n", held, result.outcomes.size());
    for (const Outcome& outcome : result.outcomes)
        if (!outcome.pass) fmt::print(out_, "      {}\n", painted(failureText(result.scene, outcome), red, colour_));
    out_.flush();
}

void VerdictTable::partings(const SceneResult& result) const {
    if (!result.changed.empty()) fmt::print(out_, "      changed: {}\n", fmt::join(result.changed, ", "));
    for (const EngineResult& run : result.engines)
        if (run.observation.role == Role::Truth && result.scene.closedForm && !run.observation.unsupported.empty())
            fmt::print(out_, "      no closed form: {}\n", run.observation.unsupported);
    if (!result.unjudged.empty())
        fmt::print(out_, "      not judged, because they expect what holds for the scene as it was: {}\n",
                   fmt::join(result.unjudged, ", "));
    for (const EngineResult& run : result.engines)
        if (run.observation.role == Role::Subject && !run.answer.empty()) fmt::print(out_, "      {}\n", run.answer);
    for (const EngineResult& run : result.engines)
        if (isTrack(run.observation) && !run.answer.empty())
            fmt::print(out_, "      {}: {}\n", run.observation.engine, run.answer);
    for (const EngineResult& run : result.engines)
        for (const auto& [path, value] : settingsFor(run.observation.engine, result.scene))
            fmt::print(out_, "      {}: {} = {}\n", run.observation.engine, path, value);
    for (const EngineResult& run : result.engines)
        if (const std::string text = ownStepsText(run.ownSteps); !text.empty()) fmt::print(out_, "      {}\n", text);
    for (const Parting& parting : result.partings) fmt::print(out_, "      {}\n", partingText(result.scene, parting));
    out_.flush();
}

void VerdictTable::summary(std::span<const SceneResult> results) const {
    std::vector<Verdict> verdicts;
    for (const SceneResult& result : results) verdicts.push_back(result.verdict);
    fmt::print(out_, "\n{}\n{}", countText("scene", verdicts, colour_), boundText(results));
    out_.flush();
}

}  // namespace plumb::compare
