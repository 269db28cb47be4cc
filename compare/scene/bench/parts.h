// SPDX-License-Identifier: MIT
// What do the scenes that measure speed have in common?
#pragma once
#include <string>
#include <utility>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// An empty scene with this number of steps of 1/60 s, under 10 m/s^2.
inline Scene benchScene(const std::string& name, const std::string& question, int steps) {
    Scene scene{.name = name, .question = question, .gravity = {0, -10}};
    scene.duration = steps * scene.dt;
    return scene;
}

inline SceneBody fixedBody(const std::string& name, std::vector<ShapeDef> shapes, const Vec2& position = {0, 0}) {
    return {name, {.type = BodyType::Static, .position = position, .shapes = std::move(shapes)}};
}

/// Adds a dynamic body of one shape. Its name is its place in the list.
inline SceneBody& addBody(Scene& scene, const ShapeDef& shape, const Vec2& position) {
    SceneBody body{"body_" + std::to_string(scene.bodies.size()), {.position = position, .shapes = {shape}}};
    return scene.bodies.emplace_back(std::move(body));
}

/// Rows of squares; each row has one square less than the row below. first is the centre of the bottom row's leftmost
/// square.
inline void addPyramid(Scene& scene, int base, double halfSize, const Vec2& first) {
    const ShapeDef square = box({halfSize, halfSize});
    for (int row = 0; row < base; ++row)
        for (int column = 0; column < base - row; ++column)
            addBody(scene, square, first + halfSize * Vec2(row + 2 * column, 2 * row));
}

}  // namespace plumb::compare
