// SPDX-License-Identifier: MIT
#include <plumb/broad/morton.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <plumb/math/random.h>

#include "catch.h"
#include "kit/broad/box_scenes.h"

using box_scenes::squareAround;
using namespace plumb;

namespace {

using Boxes = std::vector<Aabb>;
using Order = std::vector<std::uint32_t>;

constexpr std::uint32_t runLimit = 8;

Boxes evenBoxes(int count, Random& random) {
    Boxes boxes;
    const double side = std::sqrt(count);
    for (int i = 0; i < count; ++i)
        boxes.push_back(squareAround({random.uniform(0, side), random.uniform(0, side)}, random.uniform(0.2, 0.3)));
    return boxes;
}

bool isPermutation(Order order, std::size_t count) {
    std::sort(order.begin(), order.end());
    Order all(count);
    std::iota(all.begin(), all.end(), 0u);
    return order == all;
}

// The mean half perimeter of a block's bounds.
double blockSize(const Boxes& boxes, const Order& order) {
    double sum = 0;
    int blocks = 0;
    for (std::size_t begin = 0; begin + 8 <= order.size(); begin += 8, ++blocks) {
        Aabb bounds = boxes[order[begin]];
        for (std::size_t k = begin; k < begin + 8; ++k) bounds = merge(bounds, boxes[order[k]]);
        sum += (bounds.upper - bounds.lower).sum();
    }
    return sum / blocks;
}

double blockSize(const Boxes& boxes) {
    return blockSize(boxes, mortonOrder(boxes, runLimit));
}

}  // namespace

TEST_CASE("an order names each of 0 to 2,000 boxes once", "[broad]") {
    Random random(67);
    for (const int count : {0, 1, 2, 9, 300, 2000}) {
        const Boxes boxes = evenBoxes(count, random);
        CHECK(isPermutation(mortonOrder(boxes, runLimit), boxes.size()));
    }
}

TEST_CASE("boxes in one place keep the order they came in", "[broad]") {
    const Order order = mortonOrder(Boxes(1000, squareAround({3, 4}, 1)), runLimit);
    CHECK(std::is_sorted(order.begin(), order.end()));
}

TEST_CASE("eight boxes that follow each other lie near each other", "[broad]") {
    Random random(71);
    // Eight boxes at one a square metre fill a square of 2.8 m, half perimeter 5.7 m; a Z has blocks in two parts here
    // and there, which is why it is less than twice that.
    CHECK(blockSize(evenBoxes(10'000, random)) < 2 * 5.7);
}

TEST_CASE("boxes at 1e9 m and 1e300 m leave the others as near to each other as they were", "[broad]") {
    Random random(73);
    Boxes boxes = evenBoxes(10'000, random);
    const double alone = blockSize(boxes);
    for (const double far : {1e9, 1e300}) {
        boxes.push_back(squareAround({far, -far}, 1));
        Order order = mortonOrder(boxes, runLimit);
        std::erase_if(order, [](std::uint32_t index) { return index >= 10'000; });
        // The cells have other rims: no more than a tenth either way.
        CHECK(blockSize(boxes, order) < 1.1 * alone);
    }
}

TEST_CASE("the hundred largest of 10,000 boxes come last", "[broad]") {
    Random random(79);
    Boxes boxes = evenBoxes(10'000, random);
    for (std::size_t i = 0; i < 100; ++i) boxes[i * 97] = inflate(boxes[i * 97], 20);
    const Order order = mortonOrder(boxes, runLimit);
    const auto large = [&boxes](std::uint32_t index) { return boxes[index].upper.x() - boxes[index].lower.x() > 20; };
    CHECK(std::all_of(order.end() - 100, order.end(), large));
    CHECK(std::none_of(order.begin(), order.end() - 100, large));
}

TEST_CASE("of 16,000 boxes in a column that trembles sideways, sixteen that follow each other are neighbours",
          "[broad]") {
    Random random(83);
    for (const bool upright : {true, false}) {
        Boxes boxes;
        for (int i = 0; i < 16'000; ++i) {
            const double tremble = random.uniform(-0.1, 0.1);
            boxes.push_back(squareAround(upright ? Vec2(tremble, i) : Vec2(i, tremble), 0.5));
        }
        // Eight of a row are 9 m long and 1.2 m wide at most; runs of more than eight in a cell are divided anew.
        CHECK(blockSize(boxes) < 1.5 * 10.2);
    }
}

TEST_CASE("one sort does for many crowds", "[broad]") {
    Random random(89);
    MortonSort sort;
    for (const int count : {500, 3, 0, 2000, 40}) {
        const Boxes boxes = evenBoxes(count, random);
        const auto order = sort(boxes, runLimit);
        CHECK((Order(order.begin(), order.end()) == mortonOrder(boxes, runLimit)));
    }
}
