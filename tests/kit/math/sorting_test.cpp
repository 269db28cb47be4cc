// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <plumb/math/detail/sorting.h>
#include <plumb/math/random.h>

namespace {

using plumb::Random;
using plumb::sortBy;
using plumb::sortOnceBy;

struct Card {
    int rank = 0;
    std::string name;
    bool operator==(const Card&) const = default;
};

int rankOf(const Card& card) {
    return card.rank;
}

bool isLower(const Card& a, const Card& b) {
    return a.rank < b.rank;
}

/// Few ranks, so that many are equal; every third list is in order already but for its last card.
std::vector<Card> randomCards(Random& random, int seed) {
    std::vector<Card> cards(static_cast<std::size_t>(seed % 70));
    for (std::size_t i = 0; i < cards.size(); ++i)
        cards[i] = {static_cast<int>(random.uniform(0, 12)), "card number " + std::to_string(i)};
    if (seed % 3 == 0 && !cards.empty()) std::stable_sort(cards.begin(), cards.end() - 1, isLower);
    return cards;
}

}  // namespace

TEST_CASE("lists are sorted as by the standard library, and equal items keep their order", "[math]") {
    Random random(67);
    for (int seed = 0; seed < 2000; ++seed) {
        std::vector<Card> cards = randomCards(random, seed), expected = cards;
        std::stable_sort(expected.begin(), expected.end(), isLower);
        sortBy(cards, rankOf);
        REQUIRE(cards == expected);
    }
}

TEST_CASE("of items with equal keys the first is kept", "[math]") {
    std::vector<Card> cards = {{3, "a"}, {1, "b"}, {3, "c"}, {2, "d"}, {1, "e"}};
    sortOnceBy(cards, rankOf);
    CHECK(cards == std::vector<Card>{{1, "b"}, {2, "d"}, {3, "a"}});
    std::vector<int> none;
    sortOnceBy(none, std::identity{});
    CHECK(none.empty());
}
