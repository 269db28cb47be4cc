// SPDX-License-Identifier: MIT
#include <compare/field/scene_fields.h>

#include <cmath>

#include <compare/engine/plumb_world.h>
#include <compare/scene/builtin.h>
#include <plumb/math/random.h>

#include "catch.h"

namespace plumb::compare {
namespace {

/// Balls and boxes among one field of each law.
Scene sceneWithAll(Random& random) {
    Scene scene{.name = "a", .gravity = {0, 0}};
    for (int i = 0; i < 6; ++i) {
        BodyDef def{.position = {6.0 * i, random.uniform(-1, 1)},
                    .angle = random.uniform(0, 3),
                    .velocity = {random.uniform(-2, 2), random.uniform(-2, 2)},
                    .angularVelocity = random.uniform(-2, 2)};
        if (i % 2 == 0)
            def.shapes = {circle(0.5)};
        else
            def.shapes = {{.shape = boxPolygon({0.6, 0.3}, {0.2, 0.1})}};
        scene.bodies.push_back({"b" + std::to_string(i), def});
    }
    scene.fields = {{"u", {.law = UniformGravity{{1, 2}}}},
                    {"g", {.law = MutualGravity{.constant = 3}}},
                    {"d", {.law = Drag{0.1, 0.05, {2, 0}}, .region = boxPolygon({10, 10})}},
                    {"a", {.law = Attractor{.center = {3, 4}, .strength = 5}}},
                    {"m", {.law = Magnet{{}, {.strength = 4}}}, "b3"},
                    {"p", {.law = Pool{.fluid = {.density = 2}, .drag = 0.3, .flow = {1, 0}}}},
                    {"f", {.law = GroundFriction{.friction = 0.02}}}};
    return scene;
}

}  // namespace

// Two ways to the same forces, that share only the laws themselves: in a step so short that nothing moves far, what the
// world does to each velocity is what is applied to the Box2Ds.
TEST_CASE("what fields do to a body is what a world does, in 200 scenes", "[compare][fields]") {
    Random random(71);
    for (int i = 0; i < 200; ++i) {
        CAPTURE(i);
        const Scene scene = sceneWithAll(random);
        PlumbWorld made = plumbWorld(scene);
        std::vector<BodyState> states;
        for (const BodyId id : made.bodies) {
            const BodyView body = made.world.body(id);
            states.push_back({body.position(), body.angle(), body.velocity(), body.angularVelocity()});
        }
        const double dt = 1e-6;
        const std::vector<FieldForce> forces = SceneFields(scene).at(states, dt);
        made.world.step(dt);
        for (std::size_t b = 0; b < states.size(); ++b) {
            const BodyView body = made.world.body(made.bodies[b]);
            const Vec2 force = body.mass() * Vec2(body.velocity() - states[b].velocity) / dt;
            const double torque = body.inertia() * (body.angularVelocity() - states[b].angularVelocity) / dt;
            // In that time the forces change by 1e-5 of themselves; a velocity is rounded to 1e-16 / dt.
            CHECK((force - forces[b].force).norm() < 1e-4 * (1 + forces[b].force.norm()));
            CHECK(std::abs(torque - forces[b].torque) < 1e-4 * (1 + std::abs(forces[b].torque)));
        }
    }
}

TEST_CASE("the energy in a scene's fields is what the world's ledger has", "[compare][fields]") {
    Random random(72);
    const Scene scene = sceneWithAll(random);
    const PlumbWorld made = plumbWorld(scene, {.ledger = true});
    std::vector<BodyState> states;
    for (const SceneBody& body : scene.bodies) states.push_back({body.def.position, body.def.angle, {0, 0}, 0});
    CHECK(SceneFields(scene).energyAt(states) == Approx(made.world.ledger().energy.fields).epsilon(1e-12));
}

}  // namespace plumb::compare
