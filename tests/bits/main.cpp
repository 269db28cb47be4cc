// SPDX-License-Identifier: MIT
// Prints a hash a world: the same whoever compiled it, and how. Between them the worlds use every shape and joint, both
// ways an impact is solved, friction, damping, sleep, and bodies that are removed.
#include <cinttypes>
#include <cstdio>
#include <vector>

#include <plumb/math/random.h>
#include <plumb/plumb.h>

using plumb::BodyId;
using plumb::BodyType;
using plumb::Vec2;
using plumb::World;

namespace {

void run(const char* name, World& world, int ticks) {
    for (int tick = 0; tick < ticks; ++tick) world.step(1.0 / 60);
    std::printf("%s %016" PRIx64 "\n", name, plumb::stateHash(world));
}

void addBox(World& world, double side, const plumb::Material& material) {
    world.add({.type = BodyType::Static,
               .shapes = {plumb::segment({-side, -side}, {side, -side}, material),
                          plumb::segment({side, -side}, {side, side}, material),
                          plumb::segment({side, side}, {-side, side}, material),
                          plumb::segment({-side, side}, {-side, -side}, material)}});
}

void heap() {
    World world;
    plumb::Random random(1);
    addBox(world, 8, {.friction = 0.4});
    std::vector<BodyId> bodies;
    for (int i = 0; i < 60; ++i) {
        const plumb::Material material{.density = random.uniform(0.5, 2), .friction = random.uniform(0, 1)};
        const double size = random.uniform(0.3, 0.6);
        const plumb::ShapeDef shapes[] = {
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
    run("heap falling", world, 240);
    for (std::size_t i = 0; i < bodies.size(); i += 9) world.remove(bodies[i]);
    run("heap at rest", world, 900);
}

void gas() {
    World world({.gravity = {0, -1}});
    plumb::Random random(2);
    const plumb::Material material{.friction = 0.1, .restitution = 1};
    addBox(world, 6, material);
    for (int i = 0; i < 30; ++i)
        world.add({.position = {-5 + 2.0 * (i % 6), -5 + 2.0 * (i / 6)},
                   .velocity = {random.uniform(-5, 5), random.uniform(-5, 5)},
                   .shapes = {i % 4 == 0 ? plumb::box({0.4, 0.3}, material) : plumb::circle(0.4, material)}});
    run("gas", world, 600);
}

void pendulums() {
    World world;
    const BodyId ceiling = world.add({.type = BodyType::Static});
    BodyId last = ceiling;
    for (int i = 0; i < 8; ++i) {
        const BodyId link = world.add({.position = {0.5 + i, 0}, .shapes = {plumb::box({0.5, 0.05})}});
        world.join(plumb::RevoluteJointDef{.bodyA = last, .bodyB = link, .anchor = {double(i), 0}});
        last = link;
    }
    const BodyId bob = world.add({.position = {-2, 0}, .shapes = {plumb::circle(0.3)}});
    world.join(plumb::DistanceJointDef{.bodyA = ceiling, .bodyB = bob, .anchorA = {0, 0}, .anchorB = {-2, 0}});
    run("pendulums", world, 900);
}

void pyramid() {
    World world;
    world.add({.type = BodyType::Kinematic, .velocity = {0.1, 0}, .shapes = {plumb::box({20, 0.5})}});
    for (int i = 0; i < 12; ++i)
        for (int j = i; j < 12; ++j)
            world.add({.position = {0.5 * (i + 1) + (j - i) - 6, 1.0 + i}, .shapes = {plumb::box({0.5, 0.5})}});
    run("pyramid", world, 300);
}

}  // namespace

int main() {
    heap();
    gas();
    pendulums();
    pyramid();
}
