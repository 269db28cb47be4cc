// SPDX-License-Identifier: MIT
// Counts what asks the system for memory, by operators new of its own. Sanitizers have theirs: there nothing is
// counted.
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"

using namespace plumb;
using namespace plumb::test;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__GLIBC__)
constexpr bool counts = false;
#else
constexpr bool counts = true;
#endif

namespace {

thread_local bool counting = false;
thread_local int requests = 0;

}  // namespace

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && defined(__GLIBC__)
[[gnu::noinline]] void* operator new(std::size_t bytes) {
    requests += counting ? 1 : 0;
    if (void* block = std::malloc(bytes > 0 ? bytes : 1)) return block;
    throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t bytes, std::align_val_t alignment) {
    requests += counting ? 1 : 0;
    const std::size_t step = static_cast<std::size_t>(alignment);
    if (void* block = std::aligned_alloc(step, (bytes + step - 1) / step * step)) return block;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* block) noexcept {
    std::free(block);
}
[[gnu::noinline]] void operator delete(void* block, std::size_t) noexcept {
    std::free(block);
}
[[gnu::noinline]] void operator delete(void* block, std::align_val_t) noexcept {
    std::free(block);
}
[[gnu::noinline]] void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
    std::free(block);
}
#endif

namespace {

BodyId addGround(World& world) {
    return world.add({.type = BodyType::Static,
                      .shapes = {segment({-50, 0}, {50, 0}), segment({-8, 0}, {-8, 9}), segment({8, 0}, {8, 9})}});
}

void pyramid(World& world) {
    addGround(world);
    for (int row = 0; row < 8; ++row)
        for (int i = 0; i < 8 - row; ++i)
            world.add({.position = {i - 0.5 * (7 - row), 0.5 + row}, .shapes = {box({0.45, 0.5})}});
}

void pendulums(World& world) {
    const BodyId ground = addGround(world);
    for (int i = 0; i < 5; ++i) {
        const Vec2 pivot(i - 2.0, 5);
        const BodyId disc = world.add({.position = pivot + Vec2(i == 0 ? -2 : 0, i == 0 ? 0 : -2),
                                       .shapes = {circle(0.5, {.friction = 0, .restitution = 1})}});
        world.join(
            DistanceJointDef{.bodyA = ground, .bodyB = disc, .anchorA = pivot, .anchorB = world.body(disc).position()});
    }
}

/// Chains of hinged bars that lie on the ground, and one that swings.
void chains(World& world) {
    const BodyId ground = addGround(world);
    for (const double height : {0.3, 1.0, 6.0}) {
        BodyId last = ground;
        for (int i = 0; i < 6; ++i) {
            const BodyId bar = world.add({.position = {i + 0.5 - 3, height}, .shapes = {box({0.45, 0.1})}});
            if (last != ground || height > 5)
                world.join(RevoluteJointDef{.bodyA = last, .bodyB = bar, .anchor = {i - 3.0, height}});
            last = bar;
        }
    }
}

void heavyOnLight(World& world) {
    addGround(world);
    for (int i = 0; i < 3; ++i) world.add({.position = {0, 0.2 + 0.4 * i}, .shapes = {box({0.5, 0.2})}});
    world.add({.position = {0, 2.2}, .shapes = {box({1, 1}, {.density = 100})}});
}

void fields(World& world) {
    addGround(world);
    world.addField({.law = Pool{.fluid = {.density = 1000, .surface = {0, 3}}, .drag = 300}});
    for (int i = 0; i < 6; ++i)
        world.add({.position = {2.0 * i - 5, 3}, .shapes = {box({0.5, 0.3}, {.density = 400})}});
}

void bouncing(World& world) {
    addGround(world);
    const Material elastic{.friction = 0, .restitution = 1};
    for (int i = 0; i < 6; ++i)
        world.add({.position = {2.0 * i - 5, 2.0 + i % 3}, .fixedRotation = true, .shapes = {circle(0.4, elastic)}});
}

void rolling(World& world) {
    std::vector<Vec2> bowl;
    for (int i = 0; i <= 60; ++i) bowl.push_back(Rot::fromAngle(-3.1 + 0.05 * i) * Vec2(5, 0));
    world.add({.type = BodyType::Static, .shapes = {chain(bowl, {.friction = 0})}});
    world.add({.position = {-3, -3.2}, .shapes = {circle(0.5, {.friction = 0})}});
}

}  // namespace

TEST_CASE("a warm world steps without asking for memory", "[dynamics][memory]") {
    if (!counts) return;
    struct Scene {
        std::string name;
        std::function<void(World&)> add;
    };
    const Scene scenes[] = {{"pyramid", pyramid}, {"pendulums", pendulums}, {"chains", chains},  {"load", heavyOnLight},
                            {"fields", fields},   {"bouncing", bouncing},   {"rolling", rolling}};
    for (const Scene& scene : scenes) {
        World world({.sleeping = false});
        scene.add(world);
        for (int tick = 0; tick < 900; ++tick) world.step(dt);
        requests = 0;
        counting = true;
        for (int tick = 0; tick < 120; ++tick) world.step(dt);
        counting = false;
        INFO(scene.name);
        CHECK(requests == 0);
    }
    // The counter counts.
    requests = 0;
    counting = true;
    World{};
    counting = false;
    CHECK(requests > 0);
}
