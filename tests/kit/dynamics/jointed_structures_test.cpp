// SPDX-License-Identifier: MIT
// Do structures of many joints hold, and come to rest?
#include "kit/dynamics/jointed_structures.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::test;

namespace {

constexpr double direct = 1e-5;  // the gap of what is solved at once [m]
/// Of what is swept: 0.5 % of a link of 1 m. It is a length, whatever the links are: it follows from what gravity adds
/// in a sub-step.
constexpr double swept = 0.005;
constexpr double still = 0.01;  // [m/s]
/// Of a long truss that is solved at once, velocities keep up to what gravity adds in half a sub-step, which its rows
/// take back too softly; its places do not change.
constexpr double kept = 0.0225;  // [m/s]

/// How far a body gets in a second at most [m].
double secondOf(Structure& s) {
    std::vector<Vec2> before;
    for (const BodyId body : s.bodies) before.push_back(s.world.body(body).position());
    for (int tick = 0; tick < 60; ++tick) s.world.step(dt);
    double farthest = 0;
    for (std::size_t i = 0; i < before.size(); ++i)
        farthest = std::max(farthest, (s.world.body(s.bodies[i]).position() - before[i]).norm());
    return farthest;
}

/// Lets it hang until it is at rest, for 40 s at most.
void hangs(Structure&& s) {
    const bool isSwept = s.isSwept();
    double moved = still;
    for (int second = 0; second < 40 && (second < 3 || moved > still || s.speed() > kept); ++second)
        moved = secondOf(s);
    INFO(s.name << ", link " << s.link << " m, " << (isSwept ? "swept" : "direct") << ": gap " << s.gap() << " m, "
                << s.speed() << " m/s, " << moved << " m in a second");
    CHECK(s.gap() <= (isSwept ? swept : direct));
    CHECK(moved <= still);
    CHECK(s.speed() <= kept);
}

}  // namespace

TEST_CASE("a long truss bears its weight: what its rods add to its nodes has none", "[dynamics][joints]") {
    // Rods under load make the nodes at their ends heavier, so that these do not swing too fast for the sub-step. When
    // that had weight, it loaded the rods, and a truss of 24 m sank by 0.7 m.
    for (const int bays : {48, 64}) {
        Structure s = truss(0.5, bays, 0);
        for (int tick = 0; tick < 300; ++tick) s.world.step(dt);
        double lowest = 0;
        for (const BodyId body : s.bodies) lowest = std::min(lowest, s.world.body(body).position().y());
        INFO(bays << " bays");
        CHECK(lowest > -0.005);
        CHECK(s.gap() < direct);
    }
}

TEST_CASE("a swept cloth of ropes comes to rest", "[dynamics][joints]") {
    // Its stops were firmer than what holds: their corrections overshot, so that the discs jumped for good at 1 m/s.
    for (const int rows : {12, 20, 30}) {
        Structure s = cloth(1, LinkKind::Rope, 8, rows);
        for (int tick = 0; tick < 240; ++tick) s.world.step(dt);
        INFO(rows << " rows");
        CHECK(s.speed() < 1e-3);
    }
}

TEST_CASE("250 structures of many joints hang or stand at rest, and stay closed", "[dynamics][joints]") {
    for (std::uint64_t seed = 1; seed <= 250; ++seed) hangs(randomStructure(seed, false));
}

TEST_CASE("50 large structures of many joints hang or stand at rest, and stay closed", "[dynamics][joints][slow]") {
    for (std::uint64_t seed = 251; seed <= 300; ++seed) hangs(randomStructure(seed, true));
    hangs(hingedNet(1, 100, 100, 7));
}
