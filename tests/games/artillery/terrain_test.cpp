// SPDX-License-Identifier: MIT
#include <games/artillery/terrain.h>

#include <games/artillery/pieces.h>
#include <plumb/dynamics/world.h>
#include <algorithm>
#include <cmath>

#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::games::artillery;

namespace {

double areaUnder(const Terrain& terrain) {
    double area = 0;
    for (int i = 0; i < Terrain::columns; ++i) area += terrain.height(i) * Terrain::spacing;
    return area;
}

std::vector<BodyId> raise(World& world, const Building& building) {
    std::vector<BodyId> pieces;
    for (const Piece& piece : building.pieces) pieces.push_back(world.add(pieceDef(piece.kind, piece.at)));
    return pieces;
}

}  // namespace

TEST_CASE("a blast of 2 m removes its whole disc deep in the ground, half of it at the surface, and its rims slide",
          "[games][artillery]") {
    const double disc = 3.14159265 * 4;
    for (const double depth : {0.0, 6.0}) {
        Terrain terrain(3.0);
        const double before = areaUnder(terrain);
        terrain.carve({0, 3.0 - depth}, 2);
        // The ground sinks by h(x) = f sqrt(4 - x^2), f = 1 or 2. Beyond c = 2 s / sqrt(f^2 + s^2) this is steeper
        // than s = 2.4. A slope replaces it there: its area is h(c)^2 / 2 s instead of the area of h beyond c.
        const double f = depth > 0 ? 2 : 1, s = Terrain::steepest;
        const double c = 2 * s / std::sqrt(f * f + s * s), h = f * std::sqrt(4 - c * c);
        const double beyond = f * (2 * std::acos(c / 2) - c * std::sqrt(4 - c * c) / 2);
        const double slid = 2 * (h * h / (2 * s) - beyond);
        // A sum over columns of 0.25 m; each of the two rims has an error of half a column at h(c).
        const double margin = 2 * 0.125 * h + 0.1;
        REQUIRE(before - areaUnder(terrain) == Approx(f / 2 * disc + slid).margin(margin));
    }
}

TEST_CASE("after 1,000 blasts the ground is nowhere higher than before, and no crater wall is too steep",
          "[games][artillery]") {
    for (int island = 0; island < plumb::test::cases(50); ++island) {
        Random random(static_cast<std::uint64_t>(island));
        Terrain terrain(random);
        for (int blast = 0; blast < 20; ++blast) {
            const Terrain before = terrain;
            const double x = random.uniform(-30, 30);
            const double radius = random.uniform(1, 4);
            terrain.carve({x, terrain.heightAt(x) + random.uniform(-2, 1)}, radius);
            for (int i = 1; i < Terrain::columns; ++i) {
                REQUIRE(terrain.height(i) <= before.height(i));
                const double rise = std::abs(terrain.height(i) - terrain.height(i - 1));
                const bool was = terrain.height(i) == before.height(i) && terrain.height(i - 1) == before.height(i - 1);
                if (!was) REQUIRE(rise <= std::max(Terrain::steepest * Terrain::spacing + 1e-9, 0.0));
            }
        }
    }
}

TEST_CASE("a sleeping crate wakes when the ground below it is removed, and falls into the crater of 2 m",
          "[games][artillery]") {
    Terrain terrain(3.0);
    World world;
    const BodyId earth = world.add({.type = BodyType::Static, .shapes = {terrain.shape()}});
    const ShapeId ground = world.body(earth).shapes().front();
    const BodyId crate = world.add(pieceDef(PieceKind::Crate, {0, 3.5}));
    const BodyId far = world.add(pieceDef(PieceKind::Crate, {20, 3.5}));
    for (int tick = 0; tick < 120; ++tick) world.step(1.0 / 60);
    REQUIRE_FALSE(world.body(crate).awake());
    terrain.carve({0, 3}, 2);
    world.shape(ground).set(terrain.shape());
    for (int tick = 0; tick < 180; ++tick) world.step(1.0 / 60);
    // The crater is a bowl 2 m deep; a crate 1 m wide stands on its edges, or on one of its sides.
    REQUIRE(world.body(crate).position().y() < 2.3);
    REQUIRE(world.body(crate).position().y() > 1.3);
    REQUIRE(std::abs(world.body(far).position().y() - 3.5) < 0.02);
}

TEST_CASE("a watchtower stands for 20 s, and falls when a shell explodes between its pillars", "[games][artillery]") {
    World world;
    world.add({.type = BodyType::Static, .shapes = {Terrain(0.0).shape()}});
    const std::vector<BodyId> pieces = raise(world, watchtower);
    const double top = world.body(pieces.back()).position().y();
    for (int tick = 0; tick < 1200; ++tick) world.step(1.0 / 60);
    REQUIRE(std::abs(world.body(pieces.back()).position().y() - top) < 0.05);
    world.explode({.center = {0.9, 0.3}, .radius = 1.5, .falloff = 2.8, .impulsePerLength = weapons[0].push});
    for (int tick = 0; tick < 300; ++tick) world.step(1.0 / 60);
    REQUIRE(world.body(pieces.back()).position().y() < top - 1.5);
}
