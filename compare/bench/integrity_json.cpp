// SPDX-License-Identifier: MIT
#include <compare/bench/integrity_json.h>

#include <cmath>

#include <compare/metric/missing.h>

namespace plumb::compare {
namespace {

using Json = nlohmann::ordered_json;

Json lengthJson(const std::optional<double>& length) {
    if (!length) return nullptr;
    return std::isinf(*length) ? Json("infinite") : Json(*length);
}

std::optional<double> lengthFrom(const Json& json) {
    if (json.is_null()) return {};
    return json.is_string() ? unbounded : json.get<double>();
}

}  // namespace

Json integrityJson(const Integrity& seen) {
    return {{"highest", lengthJson(seen.highest)},
            {"overlap", lengthJson(seen.overlap)},
            {"joint_gap", lengthJson(seen.jointGap)},
            {"passed_walls", seen.passedWalls ? Json(*seen.passedWalls) : Json(nullptr)}};
}

Integrity integrityFrom(const Json& json) {
    Integrity seen{
        lengthFrom(json.at("highest")), lengthFrom(json.at("overlap")), lengthFrom(json.at("joint_gap")), {}};
    if (!json.at("passed_walls").is_null()) seen.passedWalls = json.at("passed_walls").get<std::size_t>();
    return seen;
}

}  // namespace plumb::compare
