// SPDX-License-Identifier: MIT
// Prints the hash of a state: the same whoever compiled it, and how.
#include <cinttypes>
#include <cstdio>

#include <plumb/plumb.h>
#include <plumb/record/state_hash.h>

int main() {
    plumb::World world({.gravity = {0, -9.81}});
    world.add({.type = plumb::BodyType::Static, .shapes = {plumb::box({10, 0.5})}});
    world.add({.position = {0, 5}, .shapes = {plumb::circle(0.5, {.restitution = 0.8})}});
    for (int tick = 0; tick < 600; ++tick) world.step(1.0 / 60);
    std::printf("%016" PRIx64 "\n", plumb::stateHash(world));
}
