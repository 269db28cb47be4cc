// SPDX-License-Identifier: MIT
#include <plumb/broad/bvh.h>

#include <algorithm>
#include <string>

#include <plumb/broad/brute_force.h>

#include "catch.h"
#include "kit/broad/box_scenes.h"

using namespace box_scenes;
using namespace plumb;

namespace {

std::vector<std::uint32_t> queriedBoxes(const Bvh& bvh, const Aabb& box) {
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
    CHECK(bruteForcePairs(boxes).pairs == SortedPairs{{0, 2}, {0, 3}, {2, 3}});
    CHECK(bruteForcePairs({}).pairs.empty());
}

TEST_CASE("the hierarchy's pairs equal brute force's in 576 scenes of 24 kinds", "[broad]") {
    Random random(59);
    Bvh bvh;  // one for all: what an earlier scene left must not show
    std::size_t total = 0;
    for (const Kind& kind : kinds)
        for (int round = 0; round < 24; ++round) {
            const Boxes boxes = sceneOf(kind, round < 20 ? random.integer(0, 200) : random.integer(500, 1500), random);
            bvh.build(boxes);
            const SortedPairs expected = bruteForcePairs(boxes).pairs;
            INFO(kind.name << ", " << boxes.size() << " boxes");
            CHECK((bvh.pairs() == expected));
            total += expected.size();
        }
    CHECK(total > 1'000'000);
}

TEST_CASE("the hierarchy's queries equal a search through all boxes, in 24 kinds of scenes", "[broad]") {
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
                    if (queriedBoxes(bvh, box) != searched(boxes, box)) ++wrong;
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
    CHECK((pairsOf(boxes) == bruteForcePairs(boxes).pairs));
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
    CHECK(queriedBoxes(bvh, everything).empty());
    bvh.build(Boxes(100, around({0, 0}, 1, 1)));
    CHECK(queriedBoxes(bvh, everything).size() == 100);
    bvh.build({});
    CHECK(bvh.pairs().empty());
    CHECK(queriedBoxes(bvh, everything).empty());
    bvh.build(Boxes{around({0, 0}, 1, 1)});
    CHECK(bvh.pairs().empty());
    CHECK(queriedBoxes(bvh, around({2, 0}, 1, 1)) == std::vector<std::uint32_t>{0});
}
