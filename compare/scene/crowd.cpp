// SPDX-License-Identifier: MIT
#include <compare/scene/crowd.h>

#include <charconv>
#include <cmath>

namespace plumb::compare {
namespace {

Aabb boxAt(const Vec2& center, double half) {
    return {center - Vec2(half, half), center + Vec2(half, half)};
}

std::optional<int> countAfter(const std::string& start, const std::string& name) {
    if (!name.starts_with(start)) return {};
    int count = 0;
    const char* end = name.data() + name.size();
    const auto [rest, error] = std::from_chars(name.data() + start.size(), end, count);
    if (error != std::errc{} || rest != end || count < 2 || count > 5000) return {};
    return count;
}

}  // namespace

std::vector<Aabb> evenBoxes(int n, Random& random) {
    std::vector<Aabb> boxes;
    const double side = 2 * std::sqrt(n);
    for (int i = 0; i < n; ++i) {
        const double x = random.uniform(0, side), y = random.uniform(0, side);
        boxes.push_back(boxAt({x, y}, 0.5));
    }
    return boxes;
}

std::vector<Aabb> unevenBoxes(int n, Random& random) {
    std::vector<Aabb> boxes;
    const double side = 2 * std::sqrt(n);
    for (int i = 0; i < n; ++i) {
        const double extent = i % 2 == 0 ? side : side / 5;
        const double x = random.uniform(0, extent), y = random.uniform(0, extent);
        boxes.push_back(boxAt({x, y}, 0.1 / (1 - 0.96 * random.uniform(0, 1))));
    }
    return boxes;
}

std::optional<Scene> crowdScene(const std::string& name) {
    const std::optional<int> even = countAfter("even_", name), uneven = countAfter("uneven_", name);
    if (!even && !uneven) return {};
    Random random(27);
    Scene scene{.name = name, .question = "Which of the boxes overlap?", .gravity = {0, 0}, .duration = 2};
    const std::vector<Aabb> boxes = even ? evenBoxes(*even, random) : unevenBoxes(*uneven, random);
    for (const Aabb& box : boxes) {
        BodyDef def{.type = BodyType::Kinematic, .position = (box.lower + box.upper) / 2};
        def.velocity = {random.uniform(-1, 1), random.uniform(-1, 1)};
        def.shapes = {plumb::box((box.upper - box.lower) / 2)};
        scene.bodies.push_back({"box_" + std::to_string(scene.bodies.size()), def});
    }
    return scene;
}

}  // namespace plumb::compare
