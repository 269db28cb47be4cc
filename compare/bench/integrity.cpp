// SPDX-License-Identifier: MIT
#include <compare/bench/integrity.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <compare/metric/observation.h>

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

bool isBroken(const Integrity& seen) {
    constexpr double torn = 1;  // the gap of a joint that holds nothing any more [m]
    return seen.jointGap.value_or(0) > torn || std::isinf(seen.highest.value_or(0)) ||
           std::isinf(seen.overlap.value_or(0));
}

IntegrityWatch::IntegrityWatch(const Scene& scene) : geometry_(scene), walls_(scene) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].def.type == BodyType::Dynamic) dynamic_.push_back(i);
}

void IntegrityWatch::look(std::span<const BodyState> states, const Broken& broken) {
    seen_.highest.reset();
    for (const std::size_t body : dynamic_) {
        if (!states[body].present) continue;
        const double height = isFinite(states[body]) ? states[body].position.y() : unbounded;
        seen_.highest = std::max(seen_.highest.value_or(height), height);
    }
    const auto larger = [](std::optional<double>& most, const std::optional<double>& now) {
        most = std::max(most.value_or(0), now.value_or(unbounded));
    };
    if (geometry_.anyMayTouch()) larger(seen_.overlap, geometry_.penetration(states));
    if (geometry_.anyJoint()) larger(seen_.jointGap, geometry_.jointError(states, broken));
    seen_.passedWalls = walls_.count(states);
}

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
