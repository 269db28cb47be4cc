// SPDX-License-Identifier: MIT
#include <compare/engine/chipmunk/chipmunk_bench.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace plumb::compare {
namespace {

// Measured: a run of each takes more than a minute; spinner takes 0.2 s a step from the start.
constexpr std::array<std::string_view, 6> slow{"joint_grid", "spinner", "junkyard", "compounds", "washer", "rain"};

}  // namespace

std::string leftOutOfChipmunk(const BenchScene& scene) {
    if (scene.group == "random") return "random scenes are measured in Plumb and Box2D 3";
    if (std::ranges::find(slow, scene.name) != slow.end()) return "a run takes more than a minute";
    if (scene.name.ends_with("_32000") || scene.name.ends_with("_64000")) return "a step takes seconds";
    return "";
}

}  // namespace plumb::compare
