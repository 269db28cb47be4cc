// SPDX-License-Identifier: MIT
#include <iostream>

#include <plumb/plumb.h>

int main() {
    plumb::World world({.gravity = {0, -9.81}});
    world.add({.type = plumb::BodyType::Static, .shapes = {plumb::box({10, 0.5})}});
    plumb::BodyId ball = world.add({.position = {0, 5}, .shapes = {plumb::circle(0.5, {.restitution = 0.8})}});
    for (int tick = 0; tick < 600; ++tick) world.step(1.0 / 60);
    std::cout << world.body(ball).position() << '\n';  // 0 1, to a tenth of a millimetre: at rest
}
