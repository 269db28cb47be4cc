// SPDX-License-Identifier: MIT
// What can be done to a world as a whole, and leaves it what it is?
#include <utility>

#include "kit/dynamics/random_editor.h"

namespace plumb::test {

namespace {

void moveWorld(RandomEditor& e) {
    const std::uint64_t before = stateHash(e.world);
    World elsewhere = std::move(e.world);
    World other({.gravity = {0, 1}});
    other.add({.shapes = {box({1, 1})}});
    other.step(1.0 / 60);
    other = std::move(elsewhere);
    e.world = std::move(other);
    if (stateHash(e.world) != before) FAIL("a world that was moved is another");
}

void reserve(RandomEditor& e) {
    const std::uint64_t before = stateHash(e.world);
    Capacity capacity;
    for (const auto count : {&Capacity::bodies, &Capacity::shapes, &Capacity::contacts, &Capacity::joints})
        if (e.chance(2)) capacity.*count = static_cast<std::size_t>(e.random.integer(0, 300));
    e.world.reserve(capacity);
    if (stateHash(e.world) != before) FAIL("making room changed the world");
    if (e.tryTo([&] { e.world.reserve({.joints = std::size_t{1} << 40}); })) FAIL("room was made for too much");
}

/// The copy goes on for a while as the world does; then it is the world.
void copyWorld(RandomEditor& e) {
    World copy = e.world;
    if (stateHash(copy) != stateHash(e.world)) FAIL("a copy is another world");
    for (int i = 0; i < 3; ++i) {
        e.step(1.0 / 60);
        copy.step(1.0 / 60);
        if (stateHash(copy) != stateHash(e.world)) FAIL("a copy does not go on as the world does");
    }
    e.world = copy;
    ++e.tally.copies;
}

}  // namespace

std::vector<RandomEditor::Action> worldActions() {
    return {{1, moveWorld}, {1, reserve}};
}

std::vector<RandomEditor::Action> copyActions() {
    return {{1, copyWorld}};
}

}  // namespace plumb::test
