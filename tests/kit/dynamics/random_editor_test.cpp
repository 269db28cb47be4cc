// SPDX-License-Identifier: MIT
#include "kit/dynamics/random_editor.h"

namespace {

using plumb::test::RandomEditor;

}  // namespace

TEST_CASE("a world that is edited in 100,000 random ways tells the truth about itself", "[dynamics][editing][law]") {
    long long begins = 0, hits = 0, visits = 0, quarantines = 0;
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        INFO("seed " << seed);
        RandomEditor editor(seed, 16);
        editor.run(plumb::test::bodyActions(), 2000);
        editor.check();
        begins += editor.begins;
        hits += editor.hits;
        visits += editor.visits;
        quarantines += editor.quarantines;
    }
    CHECK(begins > 10000);
    CHECK(hits > 1000);
    CHECK(visits > 1000);
    CHECK(quarantines > 10);
}

TEST_CASE("a world that is edited in 3,000 random ways has the same bits for 1, 4, 8 and 16 lanes",
          "[dynamics][editing][law]") {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        std::vector<std::uint64_t> hashes;
        for (const int lanes : {1, 4, 8, 16}) {
            RandomEditor editor(seed, lanes);
            editor.run(plumb::test::bodyActions(), 3000);
            hashes.push_back(plumb::stateHash(editor.world));
        }
        for (const std::uint64_t hash : hashes) CHECK(hash == hashes[0]);
    }
}
