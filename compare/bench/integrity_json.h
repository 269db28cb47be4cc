// SPDX-License-Identifier: MIT
// How does what a look found stand in JSON?
#pragma once
#include <nlohmann/json.hpp>

#include <compare/bench/integrity.h>

namespace plumb::compare {

/// {"highest","overlap","joint_gap","passed_walls"}; null where there is none. JSON has no infinite numbers: those are
/// "infinite".
nlohmann::ordered_json integrityJson(const Integrity& seen);

Integrity integrityFrom(const nlohmann::ordered_json& json);

}  // namespace plumb::compare
