// SPDX-License-Identifier: MIT
#include <compare/metric/passed_walls.h>

#include <algorithm>

#include <compare/metric/observation.h>
#include <plumb/broad/bvh.h>
#include <plumb/collide/distance.h>

namespace plumb::compare {
namespace {

constexpr double point = 1e-6;   // radius of what stands for a centre of mass [m]
constexpr double inside = 1e-3;  // so deep a centre of mass is in no wall by rounding, nor on a line [m]

Transform placeOf(const BodyState& state) {
    return {state.position, Rot::fromAngle(state.angle)};
}

bool isOutside(const Vec2& center, const Aabb& walls, bool openAbove) {
    return center.x() < walls.lower.x() || center.x() > walls.upper.x() || center.y() < walls.lower.y() ||
           (!openAbove && center.y() > walls.upper.y());
}

}  // namespace

PassedWalls::PassedWalls(const Scene& scene) : openAbove_(!scene.gravity.isZero(0)) {
    if (scene.wrap.any()) return;
    std::vector<SolidShape> shapes = solidShapes(scene);
    for (const SolidShape& shape : shapes) {
        if (!shape.dynamic) continue;
        if (moving_.empty() || moving_.back().body != shape.body)
            moving_.push_back({shape.body, massOf(scene.bodies[shape.body].def).center, {}});
        moving_.back().filters.push_back(shape.shape.filter);
    }
    for (SolidShape& shape : shapes) {
        const auto touches = [&](const Moving& moving) { return mayTouch(moving, shape); };
        if (!shape.dynamic && std::ranges::any_of(moving_, touches)) walls_.push_back(std::move(shape));
    }
}

bool PassedWalls::mayTouch(const Moving& moving, const SolidShape& wall) const {
    return std::ranges::any_of(moving.filters, [&](const Filter& f) { return accepts(f, wall.shape.filter); });
}

std::optional<std::size_t> PassedWalls::count(std::span<const BodyState> states) const {
    if (walls_.empty()) return {};
    std::vector<Aabb> boxes;
    for (const SolidShape& wall : walls_) boxes.push_back(aabbOf(wall.shape.shape, placeOf(states[wall.body])));
    Aabb all = boxes.front();
    for (const Aabb& box : boxes) all = {all.lower.cwiseMin(box.lower), all.upper.cwiseMax(box.upper)};
    Bvh tree;
    tree.build(boxes);
    std::size_t passed = 0;
    for (const Moving& moving : moving_) {
        const BodyState& state = states[moving.body];
        if (!state.present) continue;
        if (!isFinite(state)) {
            ++passed;
            continue;
        }
        const Vec2 center = placeOf(state) * moving.localCenter;
        bool isIn = false;
        tree.query({center, center}, [&](std::uint32_t index) {
            const SolidShape& wall = walls_[index];
            if (isIn || !mayTouch(moving, wall)) return;
            const Distance apart =
                distance(wall.shape.shape, placeOf(states[wall.body]), Circle{.radius = point, .center = center}, {});
            isIn = apart.separation < -inside;
        });
        if (isIn || isOutside(center, all, openAbove_)) ++passed;
    }
    return passed;
}

}  // namespace plumb::compare
