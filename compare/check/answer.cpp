// SPDX-License-Identifier: MIT
#include <compare/check/answer.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <compare/check/query_value.h>
#include <compare/metric/length_text.h>
#include <compare/scene/answer.h>

namespace plumb::compare {
namespace {

std::string numberText(double value, const std::string& unit) {
    if (std::isnan(value)) return "–";
    if (unit == "m" && std::abs(value) < 0.0995) return (value < 0 ? "-" : "") + lengthText(std::abs(value));
    const double shown = std::abs(value) < 1e-9 ? 0 : value, size = std::abs(shown);
    std::string text = fmt::format("{:.3g}", shown);
    if (size >= 999.5 && size < 1e7) text = fmt::format("{:.0f}", std::stod(text));  // no 1e+03
    return unit.empty() || unit == "-" ? text : text + " " + unit;
}

std::string metricText(const Scene& scene, const std::string& name, const Measured& measured) {
    const auto found = measured.metrics.find(name);
    if (found == measured.metrics.end() || !found->second) return "–";
    if (name.ends_with("_drift")) return fmt::format("{:.2g} %", 100 * *found->second);
    return numberText(*found->second, metricUnit(scene, name));
}

/// "(y of ball does not return to 0 within 3 s)". A closed form may leave out what happens.
std::string missingText(const Observation& run, const std::string& what) {
    if (run.partial) return "–";
    return fmt::format("({} within {:.3g} s)", what, static_cast<double>(run.states.size() - 1) * run.dt);
}

std::string missingText(const Observation& run, const Happening& event) {
    constexpr const char* what[] = {"has no such maximum", "has no such minimum", "does not return to {}",
                                    "does not come above {}", "does not come below {}"};  // as in Happening::Kind
    const std::string level = event.level ? fmt::format("{:.3g}", *event.level) : "where it was";
    return missingText(
        run, textOf(event.of) + " " + fmt::format(fmt::runtime(what[static_cast<std::size_t>(event.kind)]), level));
}

std::string missingText(const Observation& run, const AnswerQuery& query) {
    if (query.when) return missingText(run, *query.when);
    return missingText(run, textOf(query.quantity) + " does not swing to and fro");
}

std::string textOf(const Scene& scene, const Observation& run, const Measured& measured, const AnswerQuery& query) {
    if (query.kind == AnswerQuery::Kind::Metric) return metricText(scene, query.metric, measured);
    const std::optional<double> value = valueOf(scene, run, query);
    return value ? numberText(*value, unitOf(scene, query)) : missingText(run, query);
}

}  // namespace

std::string answerOf(const Scene& scene, const Observation& run, const Measured& measured) {
    if (run.states.empty() || scene.answer.empty()) return "";
    std::string answer;
    for (const AnswerPart& part : answerParts(scene)) {
        answer += part.text;
        if (part.query) answer += textOf(scene, run, measured, *part.query);
    }
    return answer;
}

}  // namespace plumb::compare
