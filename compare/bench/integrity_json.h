// SPDX-License-Identifier: MIT
// How is the result of the looks written in JSON?
#pragma once
#include <nlohmann/json.hpp>

#include <compare/bench/integrity.h>

namespace plumb::compare {

/// {"highest","overlap","joint_gap","passed_walls"}; null if there is no value. JSON has no infinite numbers: they are
/// written as "infinite".
nlohmann::ordered_json integrityJson(const Integrity& seen);

Integrity integrityFrom(const nlohmann::ordered_json& json);

}  // namespace plumb::compare
