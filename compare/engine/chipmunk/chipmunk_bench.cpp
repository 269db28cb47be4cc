// SPDX-License-Identifier: MIT
#include <compare/engine/chipmunk/chipmunk_bench.h>

namespace plumb::compare {

std::string leftOutOfChipmunk(const BenchScene& scene) {
    if (scene.group == "random") return "random scenes are measured in Plumb and Box2D 3";
    if (scene.name.ends_with("_32000") || scene.name.ends_with("_64000")) return "a step takes seconds";
    return "";
}

}  // namespace plumb::compare
