// SPDX-License-Identifier: MIT
#include <plumb/broad/radix_sort.h>

#include <algorithm>

#include <plumb/broad/pair.h>
#include <plumb/math/random.h>

#include "catch.h"

using namespace plumb;

TEST_CASE("pairs sorted byte by byte stand as those sorted by comparing do, 400 times", "[broad]") {
    Random random(47);
    RadixSort<Pair, 8> sort;
    int wrong = 0;
    for (int round = 0; round < 400; ++round) {
        const int most = 1 << random.integer(0, 30);
        std::vector<Pair> pairs(static_cast<std::size_t>(random.integer(0, round % 10 == 0 ? 3000 : 40)));
        for (Pair& pair : pairs)
            pair = {static_cast<std::uint32_t>(random.integer(0, most)), static_cast<std::uint32_t>(random.bits())};
        std::vector<Pair> expected = pairs;
        std::sort(expected.begin(), expected.end());
        sort(pairs, [](const Pair& pair) { return std::uint64_t{pair.a} << 32 | pair.b; });
        if (pairs != expected) ++wrong;
    }
    CHECK(wrong == 0);
}

TEST_CASE("items of equal keys keep the order they came in", "[broad]") {
    std::vector<Pair> items;
    for (std::uint32_t i = 0; i < 1000; ++i) items.push_back({i * 7919 % 13, i});
    RadixSort<Pair, 4> sort;
    sort(items, [](const Pair& item) { return item.a; });
    CHECK(std::is_sorted(items.begin(), items.end()));
}
