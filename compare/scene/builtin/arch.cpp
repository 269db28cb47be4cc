// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {

Scene arch() {
    const int count = 15;
    const double inner = 4, outer = 5;  // radii [m]
    Scene scene{
        .name = "arch",
        .question = "Does a round arch of fifteen loose stones stand for a minute?",
        .duration = 60,
        .sleeping = false,
        .bodies = {floorBody()},
        .checks = {ExactCheck{0.025, sinks + "5/4 of it for each of 5 stones' weights that press in the mean of 14 "
                                             "joints, 25 mm in all, by which the arch may get shorter"},
                   invariant("penetration_max", 5e-3,
                             sinks + "5/4 of it for each of 6.5 stones, 2.3 mm in the lowest joints, and up to twice "
                                     "that where one corner carries all"),
                   invariant("settle_time", 2, "all start where they rest")},
    };
    ClosedForm still{.formula = "x = x0: a line of thrust fits into a round arch thicker than 0.108 of its radius",
                     .source = "Milankovitch 1907; Heyman, \"The Stone Skeleton\", 1966"};
    for (int i = 0; i < count; ++i) {
        const double step = degrees(180) / count;
        const Vec2 from = direction(i * step), to = direction((i + 1) * step);
        const Vec2 middle = (inner + outer) / 4 * (from + to);
        const std::string name = "stone_" + std::to_string(i + 1);
        const std::vector<Vec2> corners{inner * from - middle, outer * from - middle, outer * to - middle,
                                        inner * to - middle};
        scene.bodies.push_back({name, {.position = middle, .shapes = {polygon(corners)}}});
        still.bodies.push_back(PiecewiseMotion{name, {{.position = middle}}});
    }
    scene.closedForm = still;
    return scene;
}

}  // namespace plumb::compare
