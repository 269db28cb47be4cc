// SPDX-License-Identifier: MIT
#include <compare/check/query_value.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <compare/check/course.h>
#include <compare/scene/joint_geometry.h>

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

Course courseOf(const Scene& scene, const Observation& run, const Reading& quantity) {
    Course course{.dt = run.dt};
    if (quantity.body.empty()) {
        const auto probe = std::ranges::find(scene.probes, quantity.probe, &Probe::name) - scene.probes.begin();
        for (const std::vector<double>& row : run.probes) course.value.push_back(row[static_cast<std::size_t>(probe)]);
        return course;
    }
    const std::size_t body = bodyIndex(scene, quantity.body);
    for (const std::vector<BodyState>& row : run.states) {
        course.value.push_back(valueIn(row[body], quantity.value));
        if (const auto slope = slopeIn(row[body], quantity.value)) course.slope.push_back(*slope);
    }
    return course;
}

/// Not a number where one of them is not.
double extremeOf(const std::vector<double>& values, bool largest) {
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
        case Kind::Largest: return extremeOf(course.value, true);
        case Kind::Smallest: return extremeOf(course.value, false);
        case Kind::Change: return valueAt(course, time) - course.value.front();
        case Kind::Drop: return course.value.front() - valueAt(course, time);
        case Kind::Period: return periodOf(course);
        default: return valueAt(course, time);
    }
}

}  // namespace

std::optional<double> valueOf(const Scene& scene, const Observation& run, const AnswerQuery& query) {
    using Kind = AnswerQuery::Kind;
    const std::optional<double> time =
        query.when ? timeOf(courseOf(scene, run, query.when->of), *query.when) : endOf(run);
    if (!time || query.kind == Kind::Time || query.kind == Kind::Duration) return time;
    return readingAt(courseOf(scene, run, query.quantity), query.kind, *time);
}

std::string unitOf(const Scene& scene, const AnswerQuery& query) {
    using Kind = AnswerQuery::Kind;
    const bool isTime = query.kind == Kind::Time || query.kind == Kind::Duration || query.kind == Kind::Period;
    return isTime ? "s" : unitOf(scene, query.quantity);
}

}  // namespace plumb::compare
