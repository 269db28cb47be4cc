// SPDX-License-Identifier: MIT
// Prints a hash a world: the same whoever compiled it, and how, and whichever number of contacts is solved side by
// side. Between them the worlds use every shape, material and joint, both ways an impact is solved, what catches
// bullets, friction, damping, motors, belts, sleep, and bodies that are removed. After them come the scenes of the
// comparison, all.
#include <cinttypes>
#include <cstdio>
#include <string>
#include <vector>

#include <compare/engine/plumb_movers.h>
#include <compare/engine/plumb_world.h>
#include <compare/scene/builtin.h>
#include <plumb/math/detail/for_lanes.h>
#include <plumb/math/random.h>
#include <plumb/plumb.h>

using plumb::BodyId;
using plumb::BodyType;
using plumb::Material;
using plumb::ShapeDef;
using plumb::Vec2;
using plumb::World;

namespace {

struct Hash {
    std::string name;
    std::uint64_t value;
};

/// A world on so many lanes, and its hashes on the way.
struct Run {
    int lanes = 1;
    std::vector<Hash> hashes = {};

    World world(const Vec2& gravity = {0, -9.81}) const {
        return World({.gravity = gravity, .solver = {.lanes = lanes}});
    }
    void step(const std::string& name, World& world, int ticks) {
        for (int tick = 0; tick < ticks; ++tick) world.step(1.0 / 60);
        hashes.push_back({name, plumb::stateHash(world)});
    }
};

void addBox(World& world, double side, const Material& material) {
    world.add({.type = BodyType::Static,
               .shapes = {plumb::segment({-side, -side}, {side, -side}, material),
                          plumb::segment({side, -side}, {side, side}, material),
                          plumb::segment({side, side}, {-side, side}, material),
                          plumb::segment({-side, side}, {-side, -side}, material)}});
}

void heap(Run& run) {
    World world = run.world();
    plumb::Random random(1);
    addBox(world, 8, {.friction = 0.4});
    std::vector<BodyId> bodies;
    for (int i = 0; i < 60; ++i) {
        const Material material{.density = random.uniform(0.5, 2), .friction = random.uniform(0, 1)};
        const double size = random.uniform(0.3, 0.6);
        const ShapeDef shapes[] = {
            plumb::circle(size, material), plumb::box({size, 0.7 * size}, material),
            plumb::polygon({{-size, -size}, {size, -0.5 * size}, {0.4 * size, size}, {-0.6 * size, 0.8 * size}},
                           material)};
        bodies.push_back(world.add({.position = {-7 + 1.4 * (i % 10), -6 + 1.4 * (i / 10)},
                                    .angle = random.uniform(-3, 3),
                                    .velocity = {random.uniform(-4, 4), random.uniform(-4, 4)},
                                    .angularVelocity = random.uniform(-9, 9),
                                    .linearDamping = i % 5 == 0 ? 0.3 : 0,
                                    .angularDamping = i % 7 == 0 ? 0.2 : 0,
                                    .shapes = {shapes[i % 3]}}));
    }
    run.step("heap falling", world, 240);
    for (std::size_t i = 0; i < bodies.size(); i += 9) world.remove(bodies[i]);
    run.step("heap at rest", world, 900);
}

void gas(Run& run) {
    World world = run.world({0, -1});
    plumb::Random random(2);
    const Material material{.friction = 0.1, .restitution = 1};
    addBox(world, 6, material);
    for (int i = 0; i < 30; ++i)
        world.add({.position = {-5 + 2.0 * (i % 6), -5 + 2.0 * (i / 6)},
                   .velocity = {random.uniform(-5, 5), random.uniform(-5, 5)},
                   .shapes = {i % 4 == 0 ? plumb::box({0.4, 0.3}, material) : plumb::circle(0.4, material)}});
    run.step("gas", world, 600);
}

void pendulums(Run& run) {
    World world = run.world();
    const BodyId ceiling = world.add({.type = BodyType::Static});
    BodyId last = ceiling;
    for (int i = 0; i < 8; ++i) {
        const BodyId link = world.add({.position = {0.5 + i, 0}, .shapes = {plumb::box({0.5, 0.05})}});
        world.join(plumb::RevoluteJointDef{.bodyA = last, .bodyB = link, .anchor = {double(i), 0}});
        last = link;
    }
    const BodyId bob = world.add({.position = {-2, 0}, .shapes = {plumb::circle(0.3)}});
    world.join(plumb::DistanceJointDef{.bodyA = ceiling, .bodyB = bob, .anchorA = {0, 0}, .anchorB = {-2, 0}});
    run.step("pendulums", world, 900);
}

void pyramid(Run& run) {
    World world = run.world();
    world.add({.type = BodyType::Kinematic, .velocity = {0.1, 0}, .shapes = {plumb::box({20, 0.5})}});
    for (int i = 0; i < 12; ++i)
        for (int j = i; j < 12; ++j)
            world.add({.position = {0.5 * (i + 1) + (j - i) - 6, 1.0 + i}, .shapes = {plumb::box({0.5, 0.5})}});
    run.step("pyramid", world, 300);
}

ShapeDef anyShape(plumb::Random& random, int kind, const Material& material) {
    const double size = random.uniform(0.2, 0.5);
    std::vector<Vec2> points;
    for (int i = 0; i < 40; ++i) points.push_back({random.uniform(-size, size), random.uniform(-size, size)});
    switch (kind) {
        case 0: return plumb::capsule({-size, 0}, {size, 0.1}, 0.4 * size, material);
        case 1: return plumb::roundedBox({size, 0.5 * size}, 0.1, material);
        case 2: return plumb::roundedPolygon({{-size, -size}, {size, 0}, {-size, size}}, 0.05, material);
        case 3: return {.shape = plumb::hullOf(points), .material = material};
        case 4: return plumb::circle(size, material);
        default: return plumb::box({size, size}, material);
    }
}

/// A valley with a paddle in it, a belt, and one of everything coming down.
void valley(Run& run) {
    World world = run.world();
    plumb::Random random(3);
    std::vector<Vec2> ground;
    for (int i = 40; i >= 0; --i)
        ground.push_back({-10 + 0.5 * i, 0.03 * (i - 20) * (i - 20) + random.uniform(0, 0.3)});
    world.add({.type = BodyType::Static,
               .shapes = {plumb::chain(ground, {.friction = 0.8, .frictionMix = plumb::Mix::Minimum})}});
    const BodyId axle = world.add({.type = BodyType::Static, .position = {-3, 5}});
    const BodyId paddle =
        world.add({.position = {-3, 5}, .shapes = {plumb::box({1.5, 0.1}), plumb::roundedBox({0.1, 1.5}, 0.05)}});
    world.join(plumb::RevoluteJointDef{
        .bodyA = axle, .bodyB = paddle, .anchor = {-3, 5}, .motorSpeed = -3, .maxMotorTorque = 200});
    world.add({.type = BodyType::Kinematic,
               .position = {4, 4},
               .angularVelocity = 0.5,
               .shapes = {plumb::loop({{-1, -1}, {-1, 1}, {1, 1}, {1, -1}}, {.surfaceSpeed = 2})}});
    for (int i = 0; i < 70; ++i) {
        const Material material{.friction = random.uniform(0, 1),
                                .restitution = i % 3 == 0 ? 0.4 : 0,
                                .rollingResistance = i % 2 == 0 ? 0.05 : 0,
                                .surfaceSpeed = i % 11 == 0 ? 1.0 : 0.0,
                                .frictionMix = static_cast<plumb::Mix>(i % 5),
                                .restitutionMix = static_cast<plumb::Mix>(i % 4)};
        ShapeDef shape = anyShape(random, i % 6, material);
        shape.filter.group = i % 13 == 0 ? -1 : 0;
        world.add({.position = {-6 + 1.3 * (i % 10), 7 + 1.3 * (i / 10)},
                   .angle = random.uniform(-3, 3),
                   .awake = i % 10 != 9,
                   .shapes = {shape}});
    }
    run.step("valley falling", world, 200);
    run.step("valley settling", world, 700);
}

/// Everything spins, and flies at 10 to 600 m/s in a ring, at what stands and turns in the middle.
void bullets(Run& run) {
    World world = run.world();
    plumb::Random random(4);
    std::vector<Vec2> ring;
    for (int i = 0; i < 32; ++i) {
        const plumb::SinCos at = plumb::sinCos(-0.19634954084936207 * i);
        ring.push_back({20 * at.cos, 20 * at.sin});
    }
    world.add({.type = BodyType::Static, .shapes = {plumb::loop(ring)}});
    world.add({.type = BodyType::Kinematic, .angularVelocity = 7, .shapes = {plumb::box({6, 0.005})}});
    for (int i = 0; i < 60; ++i) {
        const Material material{.restitution = i % 2 == 0 ? 0.6 : 0};
        const double speed = random.uniform(10, i % 5 == 0 ? 600 : 50);
        world.add({.position = {-9 + 2.0 * (i % 10), 7.0 + 1.2 * (i / 10) - (i / 30) * 18},
                   .velocity = {speed * random.uniform(-1, 1), speed * random.uniform(-1, 1)},
                   .angularVelocity = random.uniform(-300, 300),
                   .shapes = {anyShape(random, i % 6, material)}});
    }
    run.step("bullets", world, 300);
}

void scenes(Run& run) {
    for (const plumb::compare::Scene& scene : plumb::compare::builtinScenes()) {
        plumb::compare::PlumbWorld made = plumb::compare::plumbWorld(scene, {.solver = {.lanes = run.lanes}});
        plumb::compare::PlumbMovers movers(scene, made);
        for (int tick = 0; tick < stepCount(scene); ++tick) {
            movers.step(made.world, scene.dt);
            made.world.step(scene.dt);
        }
        run.hashes.push_back({"scene " + scene.name, plumb::stateHash(made.world)});
    }
}

Run allOn(int lanes) {
    Run run{lanes};
    heap(run);
    gas(run);
    pendulums(run);
    pyramid(run);
    valley(run);
    bullets(run);
    scenes(run);
    return run;
}

}  // namespace

int main() {
    const Run scalar = allOn(1);
    for (const Hash& hash : scalar.hashes) std::printf("%s %016" PRIx64 "\n", hash.name.c_str(), hash.value);
    for (const int lanes : {4, 8, 16}) {
        if (lanes > plumb::machineLanes()) continue;
        const Run wide = allOn(lanes);
        for (std::size_t i = 0; i < scalar.hashes.size(); ++i)
            if (wide.hashes[i].value != scalar.hashes[i].value)
                std::printf("%s %016" PRIx64 " on %d lanes\n", wide.hashes[i].name.c_str(), wide.hashes[i].value,
                            lanes);
    }
}
