// SPDX-License-Identifier: MIT
// Do bodies that fall onto a flat joint of a chain come to rest?
#include <cmath>

#include <plumb/math/random.h>
#include <plumb/plumb.h>

#include "cases.h"
#include "catch.h"

namespace plumb::test {

namespace {

struct Landing {
    double off = 0;    ///< the distance of its lowest point from the chain [m]
    double speed = 0;  ///< after 5 s [m/s]
};

Landing landingOf(const BodyDef& def) {
    World world;
    world.add({.type = BodyType::Static, .shapes = {chain({{2, 0}, {0, 0}, {-2, 0}})}});
    const BodyId body = world.add(def);
    for (int i = 0; i < 300; ++i) world.step(1.0 / 60);
    return {aabbOf(def.shapes[0].shape, world.body(body).pose()).lower.y(), world.body(body).velocity().norm()};
}

}  // namespace

// Over the joint with its lower end, its nearest point belonged to one segment, and the other, over which the rest of
// it hung, had no contact. The test for walls held it there step after step, while its velocity grew to 23 m/s.
TEST_CASE("a capsule that lands tilted over a flat joint of a chain is not held in the air", "[dynamics][symptom]") {
    Random random(3);
    for (int i = 0; i < cases(10'000); ++i) {
        const double s = random.uniform(0.003, 0.03);
        const ShapeDef shapes[] = {capsule({-2 * s, 0}, {2 * s, 0}, s), box({s, s}), box({5 * s, s}),
                                   roundedBox({s / 2, s / 2}, s / 2)};
        const Landing landing = landingOf({.position = {random.uniform(-s, s), 6 * s + random.uniform(0, 1.5)},
                                           .angle = random.uniform(-3, 3),
                                           .angularVelocity = random.uniform(-5, 5),
                                           .shapes = {shapes[i % 4]}});
        CAPTURE(i, s);
        REQUIRE(std::fabs(landing.off) < 1e-3);
        REQUIRE(landing.speed < 0.5);
    }
}

}  // namespace plumb::test
