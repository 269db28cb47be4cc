// SPDX-License-Identifier: MIT
#include "kit/dynamics/grounds.h"

#include <string>

#include <plumb/shapes/tile_text.h>

namespace plumb::test {

namespace {

void addFixed(World& world, const Vec2& at, double angle, ShapeDef shape) {
    world.add({.type = BodyType::Static, .position = at, .angle = angle, .shapes = {std::move(shape)}});
}

void addSlab(World& world, const Material& material) {
    addFixed(world, {0, -5}, 0, box({20, 5}, material));
}

void addBoxes(World& world, Random& random, const Material& material) {
    addSlab(world, material);
    for (double x = -19; x < 19; x += random.uniform(1, 4)) {
        const double angle = random.integer(0, 1) == 0 ? 0 : random.uniform(-1, 1);
        addFixed(world, {x, 0}, angle, box({random.uniform(0.2, 0.6), random.uniform(0.2, 1.2)}, material));
    }
}

void addTiles(World& world, Random& random, const Material& material) {
    const std::size_t columns = 80;
    std::string upper, lower(columns, '#');
    for (std::size_t c = 0; c < columns; ++c) upper += random.integer(0, 2) == 0 ? '#' : '.';
    addFixed(world, {-20, -2}, 0, tiles(tileMapOf({upper, lower, lower, lower, lower}, 0.5), material));
}

std::vector<Vec2> addHills(World& world, Random& random, const Material& material) {
    std::vector<Vec2> points;
    for (double x = -20; x < 20; x += random.uniform(0.3, 2)) points.push_back({x, random.uniform(0, 1.2)});
    points.push_back({20, 0});
    addFixed(world, {0, 0}, 0, chain(points, material));
    return points;
}

void addBoulders(World& world, Random& random, const Material& material) {
    addSlab(world, material);
    for (double x = -19; x < 19; x += random.uniform(0.5, 2))
        addFixed(world, {x, 0}, 0, circle(random.uniform(0.1, 0.9), material));
}

void addPosts(World& world, Random& random, const Material& material) {
    addSlab(world, material);
    for (double x = -19; x < 19; x += random.uniform(0.7, 3)) {
        const Vec2 top(random.uniform(-0.5, 0.5), random.uniform(0.3, 1.3));
        addFixed(world, {x, 0}, 0, capsule({0, 0}, top, random.uniform(0.05, 0.2), material));
    }
}

bool isInside(const World& world, const Vec2& point) {
    bool inside = false;
    for (const ShapeId shape : world.overlapPoint(point))
        inside = inside || world.body(shape.body).type() == BodyType::Static;
    return inside;
}

}  // namespace

bool Ground::isBelow(const World& world, const Vec2& point) const {
    if (outline.empty()) return point.y() < 0 || isInside(world, point);
    for (std::size_t i = 1; i < outline.size(); ++i) {
        const Vec2 &a = outline[i - 1], &b = outline[i];
        if (point.x() < a.x() || point.x() > b.x()) continue;
        return point.y() < a.y() + (b.y() - a.y()) * (point.x() - a.x()) / (b.x() - a.x());
    }
    return false;
}

Ground addGround(World& world, GroundKind kind, Random& random, double friction) {
    const Material material{.friction = friction};
    Ground ground;
    switch (kind) {
        case GroundKind::Flat: addSlab(world, material); break;
        case GroundKind::Boxes: addBoxes(world, random, material); break;
        case GroundKind::Tiles: addTiles(world, random, material); break;
        case GroundKind::Chain: ground.outline = addHills(world, random, material); break;
        case GroundKind::Discs: addBoulders(world, random, material); break;
        case GroundKind::Capsules: addPosts(world, random, material); break;
    }
    return ground;
}

ShapeDef randomFaller(Random& random, const Material& material) {
    const double size = random.uniform(0.15, 0.8);
    switch (random.integer(0, 4)) {
        case 0: return box({size, 0.3 * size}, material);
        case 1: return box({size, random.uniform(0.03, 0.1)}, material);
        case 2: return box({1, 0.04}, material);
        case 3: return polygon({{-size, -0.4 * size}, {0.8 * size, -0.5 * size}, {0.2 * size, 0.9 * size}}, material);
        default: return capsule({-size, 0}, {size, 0}, random.uniform(0.04, 0.2), material);
    }
}

}  // namespace plumb::test
