// SPDX-License-Identifier: MIT
#include <compare/engine/box2d24/box2d24_bench.h>

#include <map>

namespace plumb::compare {

std::string leftOutOfBox2d24(const BenchScene& scene) {
    if (scene.group == "random") return "random scenes are measured in Plumb and Box2D 3";
    static const std::map<std::string, std::string> reasons{
        // Measured: the first step takes 0.2 s, the twelfth 8 s.
        {"spinner",
         "a step takes seconds: Box2D 2.4 enlarges boxes by four times a step's motion, and the paddle's tip makes "
         "1.7 m a step"},
        // Measured: 0.6 s a step for junkyard, and as much for washer.
        {"junkyard", "a run takes minutes"},
        {"washer", "a run takes minutes"},
        // Measured: 0.2 s a step with 16,000 bodies, 2.7 s with 64,000.
        {"pile_32000", "a step takes seconds"},
        {"pile_64000", "a step takes seconds"},
        {"pyramids_32000", "a step takes seconds"},
        {"pyramids_64000", "a step takes seconds"},
    };
    const auto reason = reasons.find(scene.name);
    return reason == reasons.end() ? "" : reason->second;
}

}  // namespace plumb::compare
