// SPDX-License-Identifier: MIT
#include <plumb/broad/bvh.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <plumb/broad/brute_force.h>
#include <plumb/math/random.h>

#include "catch.h"

using plumb::Aabb;
using plumb::Bvh;
using plumb::Pair;
using plumb::Random;
using plumb::SortedPairs;
using plumb::Vec2;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

using Boxes = std::vector<Aabb>;

Aabb around(const Vec2& center, double halfWidth, double halfHeight) {
    return {center - Vec2(halfWidth, halfHeight), center + Vec2(halfWidth, halfHeight)};
}

Vec2 somewhere(Random& random, double size) {
    return {random.uniform(-size, size), random.uniform(-size, size)};
}

Aabb evenBox(Random& random) {
    return around(somewhere(random, 20), random.uniform(0, 1), random.uniform(0, 1));
}

/// One box of a kind of scene.
struct Kind {
    const char* name;
    Aabb (*box)(Random& random);
};

const Kind kinds[] = {
    {"even", evenBox},
    {"crowded", [](Random& r) { return around(somewhere(r, 2), 0.3, 0.3); }},
    {"a grid whose cells touch", [](Random& r) { return around(Vec2(r.integer(0, 30), r.integer(0, 30)), 0.5, 0.5); }},
    {"points on a grid", [](Random& r) { return around(Vec2(r.integer(0, 9), r.integer(0, 9)), 0, 0); }},
    {"a row", [](Random& r) { return around(Vec2(r.uniform(-50, 50), 3), 0.2, 0.2); }},
    {"a column", [](Random& r) { return around(Vec2(-7, r.uniform(0, 100)), 0.5, 0.1); }},
    {"one point", [](Random&) { return around(Vec2(1, 2), 0.5, 0.5); }},
    {"sizes from 1e-4 to 1e4",
     [](Random& r) { return around(somewhere(r, 100), std::exp(r.uniform(-9, 9)), std::exp(r.uniform(-9, 9))); }},
    {"a few huge ones",
     [](Random& r) { return around(somewhere(r, 50), r.integer(0, 20) ? 0.2 : 100, r.integer(0, 20) ? 0.2 : 1e3); }},
    {"clusters 100 km apart",
     [](Random& r) { return around(somewhere(r, 5) + 1e5 * Vec2(r.integer(-1, 1), r.integer(-1, 1)), 0.3, 0.3); }},
    {"far from the origin", [](Random& r) { return around(somewhere(r, 20) + Vec2(1e9, -3e9), 0.5, 0.5); }},
    {"gaps that no float tells",
     [](Random& r) { return around(Vec2(1e6 + r.integer(0, 5) * 2e-9, r.integer(0, 5)), 0.9e-9, 0.4); }},
    {"one at 1e300",
     [](Random& r) { return r.integer(0, 99) ? evenBox(r) : around(Vec2(1e300, -1e300), 1, r.uniform(0, 1e300)); }},
    {"beyond floats", [](Random& r) { return around(somewhere(r, 1e305), 1e304, 1e304); }},
    {"smaller than floats", [](Random& r) { return around(somewhere(r, 1e-50), 1e-51, 1e-51); }},
    {"denormal", [](Random& r) { return around(somewhere(r, 1e-318), 1e-319, 1e-319); }},
    {"towards 0 by halves",
     [](Random& r) { return around(Vec2(std::exp2(-r.integer(0, 1000)), std::exp2(-r.integer(0, 60))), 1e-19, 1e-3); }},
    {"half planes, lines and the whole plane",
     [](Random& r) {
         Aabb box = evenBox(r);
         for (const int side : {0, 1}) {
             if (r.integer(0, 9) == 0) box.lower[side] = r.integer(0, 1) ? -infinity : infinity;
             if (r.integer(0, 9) == 0) box.upper[side] = r.integer(0, 9) ? infinity : -infinity;
         }
         return box;
     }},
    {"no numbers",
     [](Random& r) {
         Aabb box = evenBox(r);
         if (r.integer(0, 3) == 0) (r.integer(0, 1) ? box.lower : box.upper)[r.integer(0, 1)] = notANumber;
         return box;
     }},
    {"turned inside out", [](Random& r) { return around(somewhere(r, 10), r.uniform(-0.5, 1), r.uniform(-0.5, 1)); }},
};

Boxes sceneOf(const Kind& kind, int count, Random& random) {
    Boxes boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(kind.box(random));
    return boxes;
}

std::vector<std::uint32_t> queried(const Bvh& bvh, const Aabb& box) {
    std::vector<std::uint32_t> found;
    bvh.query(box, [&found](std::uint32_t index) { found.push_back(index); });
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<std::uint32_t> searched(const Boxes& boxes, const Aabb& box) {
    std::vector<std::uint32_t> found;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
        if (overlap(boxes[i], box)) found.push_back(i);
    return found;
}

SortedPairs pairsOf(const Boxes& boxes) {
    Bvh bvh;
    bvh.build(boxes);
    return bvh.pairs();
}

}  // namespace

TEST_CASE("brute force finds each touching pair once, in order", "[broad]") {
    const Boxes boxes = {around({0, 0}, 1, 1), around({9, 9}, 1, 1), around({2, 0}, 1, 1), around({1, 1}, 0, 0)};
    CHECK(plumb::bruteForcePairs(boxes).pairs == SortedPairs{{0, 2}, {0, 3}, {2, 3}});
    CHECK(plumb::bruteForcePairs({}).pairs.empty());
}

TEST_CASE("the hierarchy's pairs equal brute force's in 480 scenes of 20 kinds", "[broad]") {
    Random random(59);
    Bvh bvh;  // one for all: what an earlier scene left must not show
    std::size_t total = 0;
    for (const Kind& kind : kinds)
        for (int round = 0; round < 24; ++round) {
            const Boxes boxes = sceneOf(kind, round < 20 ? random.integer(0, 200) : random.integer(500, 1500), random);
            bvh.build(boxes);
            const SortedPairs expected = plumb::bruteForcePairs(boxes).pairs;
            INFO(kind.name << ", " << boxes.size() << " boxes");
            CHECK((bvh.pairs() == expected));
            total += expected.size();
        }
    CHECK(total > 1'000'000);
}

TEST_CASE("the hierarchy's queries equal a search through all boxes, in 20 kinds of scenes", "[broad]") {
    Random random(61);
    Bvh bvh;
    std::size_t wrong = 0;
    for (const Kind& kind : kinds)
        for (int round = 0; round < 5; ++round) {
            const Boxes boxes = sceneOf(kind, random.integer(1, 600), random);
            bvh.build(boxes);
            for (const Kind& asked : kinds)
                for (int i = 0; i < 5; ++i) {
                    const Aabb box = (i == 0 ? kind : asked).box(random);
                    if (queried(bvh, box) != searched(boxes, box)) ++wrong;
                }
        }
    CHECK(wrong == 0);
}

TEST_CASE("sets of 0 to 70 boxes at one point pair each with each", "[broad]") {
    for (std::uint32_t count = 0; count <= 70; ++count) {
        const SortedPairs pairs = pairsOf(Boxes(count, around({3, 4}, 1, 1)));
        CHECK(pairs.size() == std::size_t{count} * (std::max(count, 1u) - 1) / 2);
    }
}

TEST_CASE("1,024 boxes at one point make 523,776 pairs", "[broad]") {
    const Boxes boxes(1024, around({3, 4}, 1, 1));
    CHECK((pairsOf(boxes) == plumb::bruteForcePairs(boxes).pairs));
    CHECK(pairsOf(boxes).size() == 523'776);
    // Points are boxes, too.
    CHECK(pairsOf(Boxes(1024, around({3, 4}, 0, 0))).size() == 523'776);
}

TEST_CASE("a column of 16,000 boxes makes 15,999 pairs", "[broad]") {
    Boxes boxes;
    for (int i = 0; i < 16'000; ++i) boxes.push_back(around(Vec2(0, i), 0.5, 0.5));
    const SortedPairs pairs = pairsOf(boxes);
    REQUIRE(pairs.size() == 15'999);
    bool neighbours = true;
    for (std::uint32_t i = 0; i < 15'999; ++i) neighbours = neighbours && pairs[i] == Pair{i, i + 1};
    CHECK(neighbours);
}

TEST_CASE("a grid of 1,000 x 1,000 boxes pairs each with its eight neighbours", "[broad]") {
    const int side = 1000;
    Boxes boxes;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) boxes.push_back(around(Vec2(x, y), 0.5, 0.5));
    // 4 neighbours forward a box, but for the rims: 2 n (n - 1) beside and above, 2 (n - 1)^2 across.
    CHECK(pairsOf(boxes).size() == std::size_t{2} * side * (side - 1) + 2 * (side - 1) * (side - 1));
}

TEST_CASE("a hierarchy of no boxes has no pairs and answers no query", "[broad]") {
    Bvh bvh;
    const Aabb everything{{-infinity, -infinity}, {infinity, infinity}};
    CHECK(bvh.pairs().empty());
    CHECK(queried(bvh, everything).empty());
    bvh.build(Boxes(100, around({0, 0}, 1, 1)));
    CHECK(queried(bvh, everything).size() == 100);
    bvh.build({});
    CHECK(bvh.pairs().empty());
    CHECK(queried(bvh, everything).empty());
    bvh.build(Boxes{around({0, 0}, 1, 1)});
    CHECK(bvh.pairs().empty());
    CHECK(queried(bvh, around({2, 0}, 1, 1)) == std::vector<std::uint32_t>{0});
}
