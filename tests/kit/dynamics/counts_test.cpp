// SPDX-License-Identifier: MIT
#include <cmath>
#include <cstdlib>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/dynamics/worlds.h"

// What malloc says can be asked of GNU's, and not where a sanitizer has taken its place.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#if __GLIBC_PREREQ(2, 33)
#include <malloc.h>
#define PLUMB_TEST_MALLOC_SAYS 1
#endif
#endif

using namespace plumb;
using namespace plumb::test;

namespace {

/// A floor and a pyramid of so many rows.
std::vector<BodyId> addPyramid(World& world, int rows, const ShapeDef& shape) {
    world.add({.type = BodyType::Static, .shapes = {segment({-100, 0}, {100, 0})}});
    std::vector<BodyId> boxes;
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < rows - row; ++i)
            boxes.push_back(world.add({.position = {1.1 * i + 0.55 * row, 0.5 + row}, .shapes = {shape}}));
    return boxes;
}

}  // namespace

TEST_CASE("a pyramid of three rows counts 7 bodies, 6 awake, 9 shapes, 9 touches, and none awake when it sleeps",
          "[dynamics][counts]") {
    World world;
    const std::vector<BodyId> boxes = addPyramid(world, 3, box({0.5, 0.5}));
    world.add(boxes[0], {.shape = Circle{.radius = 0.1}});
    const BodyId path =
        world.add({.type = BodyType::Static, .position = {50, 50}, .shapes = {chain({{0, 0}, {1, 0}, {2, 0}})}});
    world.join(DistanceJointDef{.bodyA = boxes[0], .bodyB = boxes[1], .anchorA = {0, 0.5}, .anchorB = {1.1, 0.5}});
    steps(world, 5);
    WorldCounts counts = world.counts();
    CHECK(counts.bodies == 8);
    CHECK(counts.awakeBodies == 6);
    CHECK(counts.shapes == 9);
    CHECK(counts.joints == 1);
    CHECK(counts.touchingContacts == 3 + 4 + 2);
    CHECK(counts.contacts >= counts.touchingContacts);
    CHECK(counts.colours >= 2);
    world.remove(path);
    steps(world, 240);
    counts = world.counts();
    CHECK(counts.bodies == 7);
    CHECK(counts.shapes == 8);
    CHECK(counts.awakeBodies == 0);
    CHECK(counts.colours == 0);
    CHECK(counts.touchingContacts == 9);
}

TEST_CASE("a world with room for 1000 bodies takes them in without moving what it has", "[dynamics][counts]") {
    World world;
    world.reserve({.bodies = 1000, .shapes = 1000, .contacts = 4000});
    const std::size_t before = world.counts().bytes;
    for (int i = 0; i < 1000; ++i) world.add({.position = {i % 32 * 1.1, i / 32 * 1.1}, .shapes = {circle(0.5)}});
    CHECK(world.counts().bytes - before <= 1000 * sizeof(std::uint32_t));  // each body's list of its one shape
    World small;
    CHECK(small.counts().bytes < before / 10);
    CHECK_THROWS_WITH(world.reserve({.bodies = std::size_t{1} << 40}), containsText("Capacity.bodies: "));
}

#if defined(PLUMB_TEST_MALLOC_SAYS)
// Where more memory is promised than there is, there is room.
TEST_CASE("room for 4 billion of anything is made, or refused by name and number", "[dynamics][counts]") {
    const std::size_t most = ~std::uint32_t{0} - std::size_t{1};
    const std::vector<std::pair<std::size_t Capacity::*, std::string>> fields{{&Capacity::bodies, "bodies"},
                                                                              {&Capacity::shapes, "shapes"},
                                                                              {&Capacity::contacts, "contacts"},
                                                                              {&Capacity::joints, "joints"}};
    for (const auto& [field, name] : fields) {
        World world;
        const BodyId body = world.add({.shapes = {circle(0.5)}});
        Capacity capacity;
        capacity.*field = most;
        std::string said;
        try {
            world.reserve(capacity);
        } catch (const std::invalid_argument& refusal) {
            said = refusal.what();
        }
        const std::string expected = "Capacity." + name + ": 4294967294 is more than there is memory for";
        CHECK((said.empty() || said == expected));
        world.step(1.0 / 60);
        CHECK(world.body(body).position().y() < 0);
    }
}

namespace {

std::size_t allocated() {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

}  // namespace

// malloc adds 8 bytes to a block and rounds up to 16: most to the small lists of each body.
TEST_CASE("the bytes that a world of 1275 bodies counts are what malloc gave it, within 5 %", "[dynamics][counts]") {
    for (const ShapeDef& shape :
         {box({0.5, 0.5}), circle(0.5),
          polygon({{0.5, -0.5}, {0.5, 0.4}, {0.4, 0.5}, {-0.4, 0.5}, {-0.5, 0.4}, {-0.5, -0.5}})}) {
        const auto settled = [&shape] {
            World world;
            addPyramid(world, 50, shape);
            steps(world, 10);
            return world;
        };
        settled();  // lists within steps keep their memory (math/detail/step_list.h)
        const std::size_t before = allocated();
        const World world = settled();
        const auto taken = static_cast<double>(allocated() - before);
        const auto counted = static_cast<double>(world.counts().bytes);
        CHECK(counted < taken);
        CHECK(counted > 0.95 * taken);
    }
}
#endif

TEST_CASE("each phase of a step takes time, and the phases are the whole", "[dynamics]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {segment({-20, 0}, {20, 0})}});
    for (int i = 0; i < 30; ++i) world.add({.position = {-15.0 + i, 0.5}, .shapes = {box({0.4, 0.5})}});
    for (int tick = 0; tick < 5; ++tick) world.step(1.0 / 60);
    const StepProfile p = world.profile();
    for (const double phase : {p.pairs, p.collide, p.impacts, p.solve, p.finish}) CHECK(phase > 0);
    CHECK(std::fabs(p.pairs + p.collide + p.impacts + p.solve + p.finish - p.total) < 1e-9);
}
