// SPDX-License-Identifier: MIT
// For which scenes that measure speed is Chipmunk not waited for?
#pragma once
#include <string>

#include <compare/scene/bench.h>

namespace plumb::compare {

/// Why; empty for a scene that it is measured in.
std::string leftOutOfChipmunk(const BenchScene& scene);

}  // namespace plumb::compare
