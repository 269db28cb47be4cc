// SPDX-License-Identifier: MIT
#include <plumb/broad/broad_phase.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include <plumb/broad/grid.h>
#include <plumb/broad/sweep_and_prune.h>

#include "catch.h"
#include "kit/broad/box_scenes.h"

using namespace box_scenes;
using namespace plumb;

namespace {

std::string nameOf(BroadPhase way) {
    switch (way) {
        case BroadPhase::BruteForce: return "brute force";
        case BroadPhase::Grid: return "grid";
        case BroadPhase::SweepAndPrune: return "sweep and prune";
        case BroadPhase::Bvh: break;
    }
    return "hierarchy";
}

/// Each two boxes, by the definition of an overlap and nothing of the kit.
SortedPairs pairsByDefinition(const Boxes& boxes) {
    SortedPairs pairs;
    for (std::uint32_t a = 0; a < boxes.size(); ++a)
        for (std::uint32_t b = a + 1; b < boxes.size(); ++b) {
            bool together = true;
            for (const int axis : {0, 1})
                together = together && boxes[a].lower[axis] <= boxes[b].upper[axis] &&
                           boxes[b].lower[axis] <= boxes[a].upper[axis];
            if (together) pairs.push_back({a, b});
        }
    return pairs;
}

/// Boxes of sides 0.5 to 2 m, one on 9 m^2, however many they are.
Boxes evenScene(int count, std::uint64_t seed) {
    Random random(seed);
    const double side = 3 * std::sqrt(count);
    Boxes boxes;
    for (int i = 0; i < count; ++i) {
        const Vec2 center = somewhere(random, side / 2);
        const double halfWidth = random.uniform(0.25, 1);
        boxes.push_back(around(center, halfWidth, random.uniform(0.25, 1)));
    }
    return boxes;
}

/// Of ln(tests) over ln(n), by least squares.
double growthOf(BroadPhase way, const std::vector<int>& counts) {
    double x = 0, y = 0, xx = 0, xy = 0;
    const auto n = static_cast<double>(counts.size());
    for (const int count : counts) {
        const PairSearch search = findPairs(way, evenScene(count, static_cast<std::uint64_t>(count)));
        const double lnCount = std::log(count), lnTests = std::log(static_cast<double>(search.tests));
        x += lnCount, y += lnTests, xx += lnCount * lnCount, xy += lnCount * lnTests;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace

TEST_CASE("all broad phases find equal pairs in 1,000 scenes of 24 kinds, from even to badly uneven", "[broad]") {
    Random random(67);
    std::size_t scenes = 0, total = 0;
    for (int round = 0; scenes < 1000; ++round) {
        const Kind& kind = kinds[static_cast<std::size_t>(round) % std::size(kinds)];
        const int count = round < 48        ? round / 24
                          : round % 20 == 0 ? random.integer(500, 1000)
                                            : random.integer(2, 200);
        const Boxes boxes = sceneOf(kind, count, random);
        const SortedPairs expected = pairsByDefinition(boxes);
        for (const BroadPhase way : broadPhases) {
            const PairSearch search = findPairs(way, boxes);
            INFO(nameOf(way) << ", scene " << round << ": " << kind.name << ", " << boxes.size() << " boxes");
            CHECK((search.pairs == expected));
            // Of brute force all are tested, of the others at least what is found.
            if (way == BroadPhase::BruteForce) CHECK(search.tests == boxes.size() * (boxes.size() - (count > 0)) / 2);
            CHECK(search.tests >= expected.size());
        }
        total += expected.size();
        ++scenes;
    }
    std::cout << "[broad] " << scenes << " scenes, " << total << " pairs, equal in all four ways\n";
    CHECK(total > 1'000'000);
}

TEST_CASE("a grid of any cell size finds the same pairs", "[broad]") {
    Random random(71);
    for (const Kind& kind : kinds) {
        const Boxes boxes = sceneOf(kind, 150, random);
        const SortedPairs expected = pairsByDefinition(boxes);
        for (const double size : {5e-324, 1e-300, 1e-9, 0.01, 0.7, 1.0, 30.0, 1e9, 1e300, 1.7e308}) {
            INFO(kind.name << ", cells of " << size << " m");
            CHECK((gridPairs(boxes, {.cellSize = size}).pairs == expected));
        }
    }
    CHECK_THROWS_WITH(gridPairs({}, {.cellSize = -1}), "GridSettings.cellSize: -1 is negative");
    CHECK_THROWS_WITH(gridPairs({}, {.cellSize = infinity}), "GridSettings.cellSize: inf is not finite");
}

TEST_CASE("tests grow as n^2 by brute force, n^1.5 by sweep and prune, and n by grid and hierarchy", "[broad]") {
    const std::vector<int> counts{1000, 2000, 4000, 8000, 16'000, 32'000};
    // Of n (n - 1) / 2, the same wherever the boxes lie.
    const double bruteForce = growthOf(BroadPhase::BruteForce, {1000, 2000, 4000, 8000});
    const double grid = growthOf(BroadPhase::Grid, counts), hierarchy = growthOf(BroadPhase::Bvh, counts);
    const double sweepAndPrune = growthOf(BroadPhase::SweepAndPrune, counts);
    std::cout << "[broad] tests grow as n to the power of: brute force " << bruteForce << ", grid " << grid
              << ", sweep and prune " << sweepAndPrune << ", hierarchy " << hierarchy << "\n";
    CHECK(std::fabs(bruteForce - 2) < 0.01);
    CHECK(grid < 1.1);
    CHECK(hierarchy < 1.25);
    // A stretch as wide as a box, of a square whose side is sqrt(n), is shared by sqrt(n) boxes.
    CHECK(std::fabs(sweepAndPrune - 1.5) < 0.05);
}

TEST_CASE("sweep and prune tests boxes in a row only against their neighbours, whichever axis the row is along",
          "[broad]") {
    for (const int axis : {0, 1}) {
        Boxes boxes;
        for (int i = 0; i < 10'000; ++i) {
            Vec2 center(0, 0);
            center[axis] = 0.9 * i;
            boxes.push_back(around(center, 0.5, 0.5));
        }
        const PairSearch search = sweepAndPrunePairs(boxes);
        CHECK(search.pairs.size() == 9999);
        CHECK(search.tests == 9999);
    }
}

// Cells as wide as boxes lie apart held, where half of the boxes lie dense, a hundred boxes each.
TEST_CASE("a grid that is told nothing makes no more tests than one told twice the boxes' size, dense or sparse",
          "[broad]") {
    Random random(73);
    for (const double wider : {1.0, 10.0, 20.0, 1e4}) {
        for (const bool half : {false, true}) {
            Boxes boxes;
            for (int i = 0; i < 10'000; ++i) {
                const double side = half && i % 2 == 0 ? 75 : 75 * wider;
                boxes.push_back(around(somewhere(random, side), 0.5, 0.5));
            }
            const PairSearch chosen = gridPairs(boxes), told = gridPairs(boxes, {.cellSize = 2});
            INFO("every " << (half ? "second" : "") << " box in a square " << wider << " times as wide");
            CHECK((chosen.pairs == told.pairs));
            // Sides are a metre but for a rounding, so cells are told but for a rounding as well.
            CHECK(std::fabs(static_cast<double>(chosen.tests) - static_cast<double>(told.tests)) <=
                  0.01 * static_cast<double>(told.tests));
        }
    }
}

// A cell is at most 2^40 from the middle: all that lie beyond would share one.
TEST_CASE("points in a row and in a square share no cell, at any distance from each other", "[broad]") {
    for (const double apart : {1e-300, 1e-9, 1.0, 1e9, 1e290}) {
        Boxes row, square;
        for (int i = 0; i < 10'000; ++i) {
            row.push_back(around(Vec2(i, 3) * apart, 0, 0));
            square.push_back(around(Vec2(i % 100, i / 100) * apart, 0, 0));
        }
        CHECK(gridPairs(row).tests == 0);
        CHECK(gridPairs(square).tests == 0);
    }
}

TEST_CASE("one box as large as the scene costs a grid one test a box", "[broad]") {
    Boxes boxes = evenScene(10'000, 3);
    const GridSettings cells{.cellSize = 4};  // chosen from one box more, they would be a trifle wider
    const std::uint64_t without = gridPairs(boxes, cells).tests;
    boxes.push_back(around({0, 0}, 1e6, 1e6));
    const PairSearch search = gridPairs(boxes, cells);
    CHECK(search.tests == without + 10'000);
    boxes.back() = {{-infinity, -infinity}, {infinity, infinity}};
    CHECK(gridPairs(boxes, cells).tests == without + 10'000);
}

TEST_CASE("a few boxes far away cost a grid nothing: a crowd of 1 m at 1e9 m and one at -1e12 m", "[broad]") {
    Boxes boxes = evenScene(10'000, 5);
    const std::uint64_t near = gridPairs(boxes).tests;
    for (Aabb& box : boxes) box = {box.lower + Vec2(1e9, 1e9), box.upper + Vec2(1e9, 1e9)};
    boxes.push_back(around({-1e12, -1e12}, 1, 1));
    const std::uint64_t far = gridPairs(boxes).tests;
    // The crowd's middle, and the cells with it, are moved a little by the one.
    CHECK(std::fabs(static_cast<double>(far) / static_cast<double>(near) - 1) < 0.01);
}
