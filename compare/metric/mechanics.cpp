// SPDX-License-Identifier: MIT
#include <compare/metric/mechanics.h>

#include <algorithm>
#include <cmath>
#include <span>

#include <compare/metric/observation.h>
#include <plumb/math/transform.h>

namespace plumb::compare {
namespace {

double reachOf(const Circle& circle, const Vec2& from) {
    return (circle.center - from).norm() + circle.radius;
}

double farthest(std::span<const Vec2> points, const Vec2& from) {
    double reach = 0;
    for (const Vec2& point : points) reach = std::max(reach, (point - from).norm());
    return reach;
}

double reachOf(const Capsule& capsule, const Vec2& from) {
    return std::max((capsule.start - from).norm(), (capsule.end - from).norm()) + capsule.radius;
}

double reachOf(const Polygon& polygon, const Vec2& from) {
    return farthest(polygon.vertices, from) + polygon.radius;
}

double reachOf(const Segment& segment, const Vec2& from) {
    return std::max((segment.start - from).norm(), (segment.end - from).norm());
}

double reachOf(const Chain& chain, const Vec2& from) {
    return farthest(chain.points, from);
}

double reachOf(const TileMap& map, const Vec2& from) {
    return farthest(outerCornersOf(map), from);
}

double reachOf(const BodyDef& def, const Vec2& from) {
    double reach = 0;
    for (const ShapeDef& shape : def.shapes)
        reach = std::max(reach, std::visit([&](const auto& s) { return reachOf(s, from); }, shape.shape));
    return reach;
}

}  // namespace

Vec2 centerOf(const BodyState& state, const Mass& mass) {
    return Transform{state.position, Rot::fromAngle(state.angle)} * mass.center;
}

MassModel::MassModel(const Scene& scene) : gravity_(scene.gravity), joints_(scene), fields_(scene) {
    double total = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyDef& def = scene.bodies[i].def;
        if (def.type != BodyType::Dynamic) continue;
        const Mass mass = massOf(def);
        const BodyState start{def.position, def.angle, def.velocity, def.angularVelocity};
        moving_.push_back({i, mass, def.gravityScale, centerOf(start, mass), reachOf(def, mass.center)});
        startCenter_ += mass.mass * moving_.back().startCenter;
        total += mass.mass;
    }
    if (total > 0) startCenter_ /= total;
}

std::optional<Mechanics> MassModel::at(std::span<const BodyState> states, const Broken& broken) const {
    Mechanics sum;
    for (const Moving& moving : moving_) {
        const BodyState& state = states[moving.body];
        if (!state.present) continue;
        if (!isFinite(state)) return {};
        const double m = moving.mass.mass;
        const double spin = moving.mass.inertia * state.angularVelocity;
        const Vec2 center = centerOf(state, moving.mass);
        const Vec2 arm = center - startCenter_;
        const Vec2 weight = m * moving.gravityScale * gravity_;
        sum.kinetic += (m * state.velocity.squaredNorm() + spin * state.angularVelocity) / 2;
        sum.potential -= weight.dot(center);
        sum.lifted -= weight.dot(center - moving.startCenter);
        sum.momentum += m * state.velocity;
        sum.momentumSize += m * state.velocity.norm();
        sum.angularMomentum += m * cross(arm, state.velocity) + spin;
        sum.angularMomentumSize += m * arm.norm() * state.velocity.norm() + std::abs(spin);
    }
    for (std::size_t joint = 0; joint < joints_.joints().size(); ++joint) {
        if ((joint < broken.size() && broken[joint]) || !joints_.isPresent(joint, states)) continue;
        if (joints_.isKnown(joint, states)) sum.elastic += joints_.springEnergy(joint, states);
    }
    if (!fields_.empty()) sum.field = fields_.energyAt(states);
    return sum;
}

std::optional<double> MassModel::fastestPoint(std::span<const BodyState> states) const {
    double fastest = 0;
    for (const Moving& moving : moving_) {
        const BodyState& state = states[moving.body];
        if (!state.present) continue;
        if (!isFinite(state)) return {};
        fastest = std::max(fastest, state.velocity.norm() + std::abs(state.angularVelocity) * moving.reach);
    }
    return fastest;
}

std::vector<std::size_t> MassModel::dynamicBodies() const {
    std::vector<std::size_t> result;
    for (const Moving& moving : moving_) result.push_back(moving.body);
    return result;
}

}  // namespace plumb::compare
