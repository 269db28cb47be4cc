// SPDX-License-Identifier: MIT
#include <compare/report/data.h>

#include <nlohmann/json.hpp>

#include <compare/report/packed_numbers.h>

namespace plumb::compare {
namespace {

using nlohmann::json;

json axisData(const Axis& axis) {
    return {{"label", axis.label}, {"unit", axis.unit}, {"logarithmic", axis.logarithmic}};
}

json curveData(const Curve& curve) {
    std::vector<double> xs, ys;
    for (const Point& point : curve.points) {
        xs.push_back(point.x);
        ys.push_back(point.y);
    }
    return {{"name", curve.name},
            {"note", curve.note},
            {"theory", curve.theory},
            {"xs", packNumbers(xs)},
            {"ys", packNumbers(ys)}};
}

json graphData(const Graph& graph) {
    json curves = json::array();
    for (const Curve& curve : graph.curves) curves.push_back(curveData(curve));
    return {{"title", graph.title}, {"x", axisData(graph.x)}, {"y", axisData(graph.y)}, {"curves", curves}};
}

json outcomeData(const LabOutcome& outcome) {
    const LabCheck& check = outcome.check;
    return {{"check", check.name},  {"value", outcome.value ? json(*outcome.value) : json()},
            {"limit", check.limit}, {"atMost", check.bound == Bound::AtMost},
            {"unit", check.unit},   {"reason", check.reason},
            {"pass", outcome.pass}};
}

json labData(const LabResult& result) {
    json data = {{"name", result.lab.name}, {"question", result.lab.question},    {"varied", result.lab.varied},
                 {"pass", result.verdict},  {"checks", result.lab.checks.size()}, {"seen", result.run.seen},
                 {"graphs", json::array()}, {"outcomes", json::array()}};
    for (const Graph& graph : result.run.graphs) data["graphs"].push_back(graphData(graph));
    for (const LabOutcome& outcome : result.outcomes) data["outcomes"].push_back(outcomeData(outcome));
    return data;
}

}  // namespace

json labsData(const std::vector<LabResult>& labs) {
    json data = json::array();
    for (const LabResult& lab : labs) data.push_back(labData(lab));
    return data;
}

}  // namespace plumb::compare
