// SPDX-License-Identifier: MIT
#include <cmath>

#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>

namespace plumb::compare {
namespace {

constexpr int base = 10;                               // boxes in the lowest row
constexpr int boxes = base * (base + 1) / 2;           // of a pyramid
constexpr double squareHalf = 0.5;                     // [m]
constexpr double pitch = 2 * squareHalf * (base + 1);  // from one pyramid or floor to the next [m]

/// Adds this number of pyramids, side by side on floors one above the other, with this number of columns on each floor.
void addPyramids(Scene& scene, int count, int columns) {
    const double halfWidth = columns * pitch / 2;
    const int rows = (count + columns - 1) / columns;
    std::vector<ShapeDef> floors;
    for (int row = 0; row < rows; ++row) floors.push_back(segment({-halfWidth, row * pitch}, {halfWidth, row * pitch}));
    scene.bodies.push_back(fixedBody("ground", floors));
    for (int i = 0; i < count; ++i)
        addPyramid(scene, base, squareHalf,
                   {1 - halfWidth + (i % columns) * pitch, squareHalf + (i / columns) * pitch});
    scene.sleeping = false;
}

}  // namespace

Scene largePyramid() {
    Scene scene = benchScene("large_pyramid", "What does a step of one island with 14,950 contacts take?", 500);
    scene.sleeping = false;
    scene.bodies.push_back(fixedBody("ground", {box({100, 1})}, {0, -1}));
    addPyramid(scene, 100, squareHalf, {-49.5, squareHalf});
    return scene;
}

Scene manyPyramids() {
    Scene scene = benchScene("many_pyramids", "What does a step of 400 islands with 58,000 contacts take?", 200);
    addPyramids(scene, 400, 20);
    return scene;
}

Scene pyramids(int n) {
    const int count = n / boxes;
    Scene scene = benchScene("pyramids_" + std::to_string(n), "How does the time of a step grow with pyramids?", 60);
    addPyramids(scene, count, static_cast<int>(std::ceil(std::sqrt(count))));
    return scene;
}

}  // namespace plumb::compare
