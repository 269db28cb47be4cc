// SPDX-License-Identifier: MIT
#include <compare/metric/bounds.h>

#include <variant>

namespace plumb::compare {
namespace {

constexpr std::size_t mostShapes = 60;

struct Placed {
    std::size_t body;
    const Shape* shape;
    Transform pose;
};

std::vector<Placed> placedShapes(const Scene& scene, std::span<const BodyState> states) {
    std::vector<Placed> placed;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyState& state = states[i];
        if (!state.present || !state.position.allFinite()) continue;
        for (const ShapeDef& def : scene.bodies[i].def.shapes)
            if (!std::holds_alternative<Chain>(def.shape) && !std::holds_alternative<TileMap>(def.shape))
                placed.push_back({i, &def.shape, {state.position, Rot::fromAngle(state.angle)}});
    }
    return placed;
}

bool isStatic(const Scene& scene, std::size_t body) {
    return scene.bodies[body].def.type == BodyType::Static;
}

}  // namespace

std::vector<ShapeBounds> boundsOf(const Scene& scene, std::span<const BodyState> states) {
    std::vector<ShapeBounds> bounds;
    for (const Placed& each : placedShapes(scene, states))
        bounds.push_back({each.body, boundingCircleOf(*each.shape, each.pose), aabbOf(*each.shape, each.pose),
                          orientedBoxOf(*each.shape, each.pose)});
    return bounds;
}

std::vector<BoundsPair> boundsPairs(const Scene& scene, std::span<const BodyState> states) {
    const std::vector<Placed> placed = placedShapes(scene, states);
    if (placed.size() > mostShapes) return {};
    const std::vector<ShapeBounds> bounds = boundsOf(scene, states);
    std::vector<BoundsPair> pairs;
    for (std::size_t i = 0; i < placed.size(); ++i)
        for (std::size_t k = i + 1; k < placed.size(); ++k) {
            const Placed &a = placed[i], &b = placed[k];
            if (a.body == b.body || (isStatic(scene, a.body) && isStatic(scene, b.body))) continue;
            pairs.push_back({a.body, b.body, overlap(bounds[i].circle, bounds[k].circle),
                             overlap(bounds[i].upright, bounds[k].upright),
                             overlap(bounds[i].oriented, bounds[k].oriented),
                             overlap(*a.shape, a.pose, *b.shape, b.pose)});
        }
    return pairs;
}

std::vector<PairTests> pairTests(const Scene& scene, std::span<const BodyState> states) {
    std::vector<Aabb> boxes;
    for (const Placed& each : placedShapes(scene, states)) boxes.push_back(aabbOf(*each.shape, each.pose));
    std::vector<PairTests> tests;
    for (const BroadPhase way : broadPhases) {
        const PairSearch found = findPairs(way, boxes);
        tests.push_back({way, found.tests, found.pairs.size()});
    }
    return tests;
}

}  // namespace plumb::compare
