// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

/// A disc that touches nothing.
SceneBody agentDisc(const char* name, BodyType type, const Vec2& position, const Vec2& velocity = {0, 0}) {
    ShapeDef disc = circle(0.3);
    disc.filter.mask = 0;
    return {name, {.type = type, .position = position, .velocity = velocity, .shapes = {disc}}};
}

SceneMover steered(const char* name, const char* body, const SteeredMotion& motion) {
    return {.name = name, .body = body, .motion = motion};
}

}  // namespace

Scene steering() {
    // From rest an agent takes all of its acceleration until its speed is a tenth of it short of the highest: here
    // never.
    const double gain = 1, highest = 6;
    // The quarry, 8 m to the side, is met after 8 / sqrt(2.5^2 - 1.5^2) = 4 s.
    const Vec2 fleeing(0, 1.5), pursuing(2, 1.5);
    const SteeredMotion arriving{
        .behaviour = Behaviour::Arrive, .target = "beacon", .maxSpeed = 4, .maxAcceleration = 20};
    return {
        .name = "steering",
        .question = "Do agents that seek, flee, arrive and pursue go where formulas say?",
        .gravity = {0, 0},
        .duration = 4,
        .bodies = {agentDisc("beacon", BodyType::Static, {0, 0}), agentDisc("seeker", BodyType::Kinematic, {-9, 0}),
                   agentDisc("fleer", BodyType::Kinematic, {1, 0}), agentDisc("arriver", BodyType::Kinematic, {0, -8}),
                   agentDisc("quarry", BodyType::Kinematic, {4, 2}, fleeing),
                   agentDisc("pursuer", BodyType::Kinematic, {-4, 2})},
        .movers =
            {steered("seek", "seeker", {.target = "beacon", .maxSpeed = highest, .maxAcceleration = gain}),
             steered("flee", "fleer",
                     {.behaviour = Behaviour::Flee, .target = "beacon", .maxSpeed = highest, .maxAcceleration = gain}),
             steered("arrive", "arriver", arriving),
             steered("pursue", "pursuer",
                     {.behaviour = Behaviour::Pursue,
                      .target = "quarry",
                      .velocity = pursuing,
                      .maxSpeed = pursuing.norm()})},
        .closedForm =
            ClosedForm{.formula = "a t^2 / 2 from rest; straight to where the quarry is met, T = d / sqrt(V^2 - w^2)",
                       .source = "Reynolds, Steering behaviors for autonomous characters, 1999; textbook: interception",
                       .bodies = {PiecewiseMotion{"seeker", {{.position = {-9, 0}, .acceleration = {gain, 0}}}},
                                  PiecewiseMotion{"fleer", {{.position = {1, 0}, .acceleration = {gain, 0}}}},
                                  PiecewiseMotion{"quarry", {{.position = {4, 2}, .velocity = fleeing}}},
                                  PiecewiseMotion{"pursuer", {{.position = {-4, 2}, .velocity = pursuing}}}}},
        .probes = {{.name = "arrived", .quantity = PositionProbe{"arriver"}, .from = 3, .unit = "m"},
                   {.name = "gap", .quantity = ApartProbe{"pursuer", "quarry"}, .unit = "m", .watch = Watch::Last}},
        .checks = {ExactCheck{1e-9, "an agent's step is exact for a constant acceleration: what is left is rounding"},
                   invariant("probe.arrived", 0.016, "1 % of the slowing distance, 4 V max(t, V / (2 A)) = 1.6 m"),
                   invariant("probe.gap", 1e-9, "likewise exact: they meet after 4 s")},
    };
}

}  // namespace plumb::compare
