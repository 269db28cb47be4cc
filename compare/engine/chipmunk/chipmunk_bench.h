// SPDX-License-Identifier: MIT
// Which scenes that measure speed are not run in Chipmunk?
#pragma once
#include <string>

#include <compare/scene/bench.h>

namespace plumb::compare {

/// Why the scene is not run; empty if it is run.
std::string leftOutOfChipmunk(const BenchScene& scene);

}  // namespace plumb::compare
