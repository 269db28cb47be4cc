// SPDX-License-Identifier: MIT
#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>

namespace plumb::compare {
namespace {

constexpr int side = 100;     // discs across and down
constexpr double hold = 0.5;  // from a disc's centre to its hinges [m]

bool isHeld(int column, int row) {
    return row == 0 && column >= 47 && column <= 53;
}

std::string discName(int column, int row) {
    return "disc_" + std::to_string(column) + "_" + std::to_string(row);
}

void hang(Scene& scene, const std::string& from, const std::string& disc, const Vec2& anchor) {
    const std::string name = "joint_" + std::to_string(scene.joints.size());
    scene.joints.push_back({name, from, disc, RevoluteJointDef{.anchor = anchor}});
}

}  // namespace

Scene jointGrid() {
    Scene scene = benchScene("joint_grid", "What does a step of 19,794 hinges take?", 500);
    scene.sleeping = false;
    ShapeDef disc = circle(0.4);
    disc.filter = {.category = 2, .mask = ~std::uint64_t{2}};  // the discs do not touch each other
    for (int column = 0; column < side; ++column) {
        for (int row = 0; row < side; ++row) {
            const bool held = isHeld(column, row);
            const Vec2 position(column, -row);
            const BodyType type = held ? BodyType::Static : BodyType::Dynamic;
            const std::string name = discName(column, row);
            scene.bodies.push_back({name, {.type = type, .position = position, .shapes = {disc}}});
            if (row > 0) hang(scene, discName(column, row - 1), name, position + Vec2(0, hold));
            if (column > 0 && !(held && isHeld(column - 1, row)))  // two held discs need no hinge between them
                hang(scene, discName(column - 1, row), name, position - Vec2(hold, 0));
        }
    }
    return scene;
}

}  // namespace plumb::compare
