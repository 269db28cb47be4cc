// SPDX-License-Identifier: MIT
#include <compare/check/answer.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <compare/check/aimed.h>
#include <compare/check/course.h>
#include <compare/check/samples.h>
#include <compare/metric/bounds.h>
#include <compare/metric/length_text.h>
#include <compare/scene/answer.h>
#include <compare/scene/joint_geometry.h>
#include <compare/scene/set_field.h>

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

/// How fast the value changes; none where that is not known.
std::optional<double> slopeIn(const BodyState& state, BodyValue value) {
    switch (value) {
        case BodyValue::X: return state.velocity.x();
        case BodyValue::Y: return state.velocity.y();
        case BodyValue::Angle: return state.angularVelocity * 180 / std::numbers::pi;
        default: return {};
    }
}

std::vector<double> valuesAtTicks(const Scene& scene, const Observation& run, const Reading& quantity) {
    std::vector<double> values;
    if (quantity.body.empty()) {
        const auto probe = std::ranges::find(scene.probes, quantity.probe, &Probe::name) - scene.probes.begin();
        for (const std::vector<double>& row : run.probes) values.push_back(row[static_cast<std::size_t>(probe)]);
    } else {
        const std::size_t body = bodyIndex(scene, quantity.body);
        for (const std::vector<BodyState>& row : run.states) values.push_back(valueIn(row[body], quantity.value));
    }
    return values;
}

/// Of a body also at its impacts, where it has one place and two velocities.
Course courseOf(const Scene& scene, const Observation& run, const Reading& quantity) {
    Course course;
    if (quantity.body.empty()) {
        course.value = valuesAtTicks(scene, run, quantity);
        for (std::size_t i = 0; i < course.value.size(); ++i) course.time.push_back(static_cast<double>(i) * run.dt);
        return course;
    }
    for (const Sample& sample : samplesOf(scene, run, bodyIndex(scene, quantity.body))) {
        course.time.push_back(sample.time);
        course.value.push_back(valueIn(sample.state, quantity.value));
        if (const auto slope = slopeIn(sample.state, quantity.value)) course.slope.push_back(*slope);
    }
    return course;
}

/// The values without those that are not numbers, of a track that is shorter than the run. For an engine that has lost
/// a body and for a formula that ends, nothing is left out.
std::vector<double> valuesThatCount(const Observation& run, std::vector<double> values) {
    if (isTrack(run)) std::erase_if(values, [](double value) { return std::isnan(value); });
    return values;
}

/// Not a number where one of them is not, or where there is none.
double extremeOf(const std::vector<double>& values, bool largest) {
    if (values.empty()) return unsaid;
    double best = values.front();
    for (const double value : values)
        if (std::isnan(value) || (largest ? value > best : value < best)) best = value;
    return best;
}

std::string unitOf(const Scene& scene, const Reading& quantity) {
    if (quantity.body.empty()) return std::ranges::find(scene.probes, quantity.probe, &Probe::name)->unit;
    return valueUnits[static_cast<std::size_t>(quantity.value)];
}

double endOf(const Observation& run) {
    return static_cast<double>(run.states.size() - 1) * run.dt;
}

/// Of a query that reads a quantity; time: the moment at which it reads [s].
std::optional<double> readingAt(const Course& course, AnswerQuery::Kind kind, double time) {
    using Kind = AnswerQuery::Kind;
    switch (kind) {
        case Kind::Change: return valueAt(course, time) - course.value.front();
        case Kind::Drop: return course.value.front() - valueAt(course, time);
        case Kind::Period: return periodOf(course);
        default: return valueAt(course, time);
    }
}

std::optional<double> overlapOf(const Scene& scene, const std::vector<BodyState>& states, const AnswerQuery& query) {
    const std::size_t a = bodyIndex(scene, query.bodyA), b = bodyIndex(scene, query.bodyB);
    double depth = 0;
    for (const BoundsPair& pair : boundsPairs(scene, states))
        if (pair.shapes && ((pair.a == a && pair.b == b) || (pair.a == b && pair.b == a)))
            depth = std::max(depth, pair.shapes->depth);
    return depth;
}

std::optional<double> testsOf(const Scene& scene, const std::vector<BodyState>& states, const std::string& way) {
    const auto index = std::ranges::find(broadPhaseNames, way) - broadPhaseNames.begin();
    return static_cast<double>(pairTests(scene, states)[static_cast<std::size_t>(index)].tests);
}

std::string metricText(const Scene& scene, const std::string& name, const Measured& measured) {
    const auto found = measured.metrics.find(name);
    if (found == measured.metrics.end() || !found->second) return "–";
    if (name.ends_with("_drift")) return fmt::format("{:.2g} %", 100 * *found->second);
    return valueText(*found->second, metricUnit(scene, name));
}

/// "(y of ball does not return to 0 within 3 s)". A closed form may leave out what happens.
std::string missingText(const Observation& run, const std::string& what) {
    if (run.partial) return "–";
    return fmt::format("({} within {:.3g} s)", what, static_cast<double>(run.states.size() - 1) * run.dt);
}

std::string missingText(const Observation& run, const Happening& event) {
    if (event.kind == Happening::Kind::Impact) return missingText(run, event.of.body + " has no such impact");
    constexpr const char* what[] = {"has no such maximum", "has no such minimum", "does not return to {}",
                                    "does not come above {}", "does not come below {}"};  // as in Happening::Kind
    const std::string level = event.level ? fmt::format("{:.3g}", *event.level) : "where it was";
    return missingText(
        run, textOf(event.of) + " " + fmt::format(fmt::runtime(what[static_cast<std::size_t>(event.kind)]), level));
}

std::string missingText(const Observation& run, const AnswerQuery& query) {
    if (query.when) return missingText(run, *query.when);
    if (query.kind == AnswerQuery::Kind::Aim) return "(no shot of that speed hits " + query.aim.target + ")";
    return missingText(run, textOf(query.quantity) + " does not swing to and fro");
}

std::string textOf(const Scene& scene, const Observation& run, const Measured& measured, const AnswerQuery& query) {
    if (query.kind == AnswerQuery::Kind::Metric) return metricText(scene, query.name, measured);
    const std::optional<double> value = valueOf(scene, run, query);
    return value ? valueText(*value, unitOf(scene, query)) : missingText(run, query);
}

}  // namespace

std::optional<double> valueOf(const Scene& scene, const Observation& run, const AnswerQuery& query) {
    using Kind = AnswerQuery::Kind;
    if (query.kind == Kind::Gravity) return scene.gravity.norm();
    if (query.kind == Kind::Field) return numberAt(scene, query.name);
    if (query.kind == Kind::Aim) return aimed(scene, query.aim);
    if (query.kind == Kind::Overlap)
        return overlapOf(scene, query.when ? run.states.front() : run.states.back(), query);
    if (query.kind == Kind::Tests) return testsOf(scene, run.states.back(), query.name);
    if (query.kind == Kind::Largest || query.kind == Kind::Smallest)
        return extremeOf(valuesThatCount(run, valuesAtTicks(scene, run, query.quantity)), query.kind == Kind::Largest);
    const std::optional<double> time =
        query.when ? timeOf(courseOf(scene, run, query.when->of), *query.when) : endOf(run);
    if (!time || query.kind == Kind::Time || query.kind == Kind::Duration) return time;
    return readingAt(courseOf(scene, run, query.quantity), query.kind, *time);
}

std::string unitOf(const Scene& scene, const AnswerQuery& query) {
    using Kind = AnswerQuery::Kind;
    if (query.kind == Kind::Gravity) return "m/s^2";
    if (query.kind == Kind::Field || query.kind == Kind::Tests) return "";
    if (query.kind == Kind::Overlap) return "m";
    if (query.kind == Kind::Aim) return unitOf(query.aim);
    if (query.kind == Kind::Metric) return metricUnit(scene, query.name);
    const bool isTime = query.kind == Kind::Time || query.kind == Kind::Duration || query.kind == Kind::Period;
    return isTime ? "s" : unitOf(scene, query.quantity);
}

std::string valueText(double value, const std::string& unit) {
    if (std::isnan(value)) return "–";
    if (unit == "m" && std::abs(value) < 0.0995) return (value < 0 ? "-" : "") + lengthText(std::abs(value));
    const double shown = std::abs(value) < 1e-9 ? 0 : value, size = std::abs(shown);
    if (unit.empty() && shown == std::round(shown) && size < 1e7) return fmt::format("{:.0f}", shown);
    std::string text = fmt::format("{:.3g}", shown);
    if (size >= 999.5 && size < 1e7) text = fmt::format("{:.0f}", std::stod(text));  // no 1e+03
    return unit.empty() || unit == "-" ? text : text + " " + unit;
}

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
