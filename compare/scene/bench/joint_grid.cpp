// SPDX-License-Identifier: MIT
#include <algorithm>

#include <compare/scene/bench/parts.h>
#include <compare/scene/bench/scenes.h>

namespace plumb::compare {
namespace {

constexpr double hold = 0.5;  // from a disc's centre to its hinges [m]

/// A disc that does not touch others of its kind.
ShapeDef apart(double radius) {
    ShapeDef disc = circle(radius);
    disc.filter = {.category = 2, .mask = ~std::uint64_t{2}};
    return disc;
}

std::string discName(int column, int row) {
    return "disc_" + std::to_string(column) + "_" + std::to_string(row);
}

void hang(Scene& scene, const std::string& from, const std::string& disc, const Vec2& anchor) {
    const std::string name = "joint_" + std::to_string(scene.joints.size());
    scene.joints.push_back({name, from, disc, RevoluteJointDef{.anchor = anchor}});
}

std::string addDisc(Scene& scene, const Vec2& position, bool held) {
    const std::string name = "disc_" + std::to_string(scene.bodies.size());
    const BodyType type = held ? BodyType::Static : BodyType::Dynamic;
    scene.bodies.push_back({name, {.type = type, .position = position, .shapes = {apart(0.1)}}});
    return name;
}

void addRod(Scene& scene, const std::string& a, const std::string& b) {
    const auto placeOf = [&](const std::string& name) {
        return std::ranges::find(scene.bodies, name, &SceneBody::name)->def.position;
    };
    const std::string name = "joint_" + std::to_string(scene.joints.size());
    scene.joints.push_back({name, a, b, DistanceJointDef{.anchorA = placeOf(a), .anchorB = placeOf(b)}});
}

}  // namespace

Scene net(int n) {
    const auto isHeld = [n](int column, int row) { return row == 0 && column >= n / 2 - 3 && column <= n / 2 + 3; };
    Scene scene = benchScene("net_" + std::to_string(n), "What does a step of a net of hinges take?", 500);
    scene.sleeping = false;
    for (int column = 0; column < n; ++column) {
        for (int row = 0; row < n; ++row) {
            const bool held = isHeld(column, row);
            const Vec2 position(column, -row);
            const BodyType type = held ? BodyType::Static : BodyType::Dynamic;
            const std::string name = discName(column, row);
            scene.bodies.push_back({name, {.type = type, .position = position, .shapes = {apart(0.4)}}});
            if (row > 0) hang(scene, discName(column, row - 1), name, position + Vec2(0, hold));
            if (column > 0 && !(held && isHeld(column - 1, row)))  // two held discs need no hinge between them
                hang(scene, discName(column - 1, row), name, position - Vec2(hold, 0));
        }
    }
    return scene;
}

Scene jointGrid() {
    Scene scene = net(100);
    scene.name = "joint_grid";
    scene.question = "What does a step of 19,794 hinges take?";
    return scene;
}

Scene truss32() {
    constexpr int bays = 32;
    Scene scene = benchScene("truss_32", "What does a step of a truss of 32 bays under a ton take?", 500);
    scene.sleeping = false;
    std::vector<std::string> lower, upper;
    for (int i = 0; i <= bays; ++i) lower.push_back(addDisc(scene, Vec2(2 * i, 0), i == 0 || i == bays));
    for (int i = 0; i < bays; ++i) upper.push_back(addDisc(scene, Vec2(2 * i + 1, 1.5), false));
    for (std::size_t i = 0; i < upper.size(); ++i) {
        addRod(scene, lower[i], lower[i + 1]);
        addRod(scene, lower[i], upper[i]);
        addRod(scene, upper[i], lower[i + 1]);
        if (i + 1 < upper.size()) addRod(scene, upper[i], upper[i + 1]);
    }
    const std::string load = addDisc(scene, Vec2(bays, -1), false);
    scene.bodies.back().def.mass = Mass{1000, {0, 0}, 100};
    addRod(scene, lower[bays / 2], load);
    return scene;
}

Scene cloth20() {
    constexpr std::size_t n = 20;
    Scene scene = benchScene("cloth_20", "What does a step of a cloth of rods take?", 500);
    scene.sleeping = false;
    std::vector<std::string> discs;
    for (std::size_t i = 0; i < n * n; ++i) {
        discs.push_back(addDisc(scene, Vec2(static_cast<double>(i % n), -static_cast<double>(i / n)), i < n));
        if (i % n > 0 && i >= n) addRod(scene, discs[i - 1], discs[i]);
        if (i >= n) addRod(scene, discs[i - n], discs[i]);
    }
    return scene;
}

}  // namespace plumb::compare
