// SPDX-License-Identifier: MIT
#include <compare/check/answer.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <compare/engine/joint_geometry.h>
#include <compare/metric/length_text.h>
#include <compare/scene/answer.h>

namespace plumb::compare {
namespace {

constexpr const char* valueUnits[] = {"m", "m", "deg", "m/s", "m/s", "m/s", "rad/s"};  // as in BodyValue

double valueIn(const BodyState& state, BodyValue value) {
    switch (value) {
        case BodyValue::X: return state.position.x();
        case BodyValue::Y: return state.position.y();
        case BodyValue::Angle: return state.angle * 180 / std::numbers::pi;
        case BodyValue::Vx: return state.velocity.x();
        case BodyValue::Vy: return state.velocity.y();
        case BodyValue::Speed: return state.velocity.norm();
        case BodyValue::Spin: return state.angularVelocity;
    }
    return 0;
}

std::vector<double> seriesOf(const Scene& scene, const Observation& run, const AnswerQuery& query) {
    std::vector<double> series;
    if (query.kind == AnswerQuery::Kind::Probe) {
        const auto probe = std::ranges::find(scene.probes, query.name, &Probe::name) - scene.probes.begin();
        for (const std::vector<double>& row : run.probes) series.push_back(row[static_cast<std::size_t>(probe)]);
        return series;
    }
    const std::size_t body = bodyIndex(scene, query.name);
    for (const std::vector<BodyState>& row : run.states) series.push_back(valueIn(row[body], query.value));
    return series;
}

/// Where the extreme stands; what is not a number is passed over.
std::size_t extremeOf(const std::vector<double>& series, bool largest) {
    std::size_t best = 0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        if (std::isnan(series[i])) continue;
        if (std::isnan(series[best]) || (largest ? series[i] > series[best] : series[i] < series[best])) best = i;
    }
    return best;
}

std::string numberText(double value, const std::string& unit) {
    if (std::isnan(value)) return "–";
    if (unit == "m" && std::abs(value) < 0.1) return (value < 0 ? "-" : "") + lengthText(std::abs(value));
    const double shown = std::abs(value) < 1e-9 ? 0 : value;
    return fmt::format("{:.3g}{}{}", shown, unit.empty() || unit == "-" ? "" : " ", unit == "-" ? "" : unit);
}

std::string metricText(const Scene& scene, const std::string& name, const Measured& measured) {
    const auto found = measured.metrics.find(name);
    if (found == measured.metrics.end() || !found->second) return "–";
    if (name.ends_with("_drift")) return fmt::format("{:.2g} %", 100 * *found->second);
    return numberText(*found->second, metricUnit(scene, name));
}

std::string textOf(const Scene& scene, const Observation& run, const Measured& measured, const AnswerQuery& query) {
    if (query.kind == AnswerQuery::Kind::Metric) return metricText(scene, query.name, measured);
    const std::vector<double> series = seriesOf(scene, run, query);
    const bool isProbe = query.kind == AnswerQuery::Kind::Probe;
    const std::string unit = isProbe ? std::ranges::find(scene.probes, query.name, &Probe::name)->unit
                                     : valueUnits[static_cast<std::size_t>(query.value)];
    const auto timeText = [&](bool largest) {
        return numberText(static_cast<double>(extremeOf(series, largest)) * run.dt, "s");
    };
    switch (query.pick) {
        case Pick::Last: return numberText(series.back(), unit);
        case Pick::At: {
            const auto tick = static_cast<std::size_t>(std::lround(query.time / run.dt));
            return numberText(series[std::min(tick, series.size() - 1)], unit);
        }
        case Pick::Largest: return numberText(series[extremeOf(series, true)], unit);
        case Pick::Smallest: return numberText(series[extremeOf(series, false)], unit);
        case Pick::Change: return numberText(series.back() - series.front(), unit);
        case Pick::Drop: return numberText(series.front() - series.back(), unit);
        case Pick::TimeOfLargest: return timeText(true);
        case Pick::TimeOfSmallest: return timeText(false);
    }
    return "";
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
