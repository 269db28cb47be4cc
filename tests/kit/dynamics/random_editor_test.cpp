// SPDX-License-Identifier: MIT
#include "kit/dynamics/random_editor.h"

#include "cases.h"

namespace {

using namespace plumb;
using namespace plumb::test;

void addTally(RandomEditor::Tally& sum, const RandomEditor::Tally& part) {
    using Tally = RandomEditor::Tally;
    for (const auto count : {&Tally::steps, &Tally::begins, &Tally::hits, &Tally::visits, &Tally::quarantines,
                             &Tally::joints, &Tally::breaks, &Tally::gears, &Tally::refusals, &Tally::asked,
                             &Tally::found, &Tally::fields, &Tally::blasts, &Tally::copies})
        sum.*count += part.*count;
}

}  // namespace

TEST_CASE("a world that is edited and asked in 40,000 random ways tells the truth about itself",
          "[dynamics][editing][law]") {
    RandomEditor::Tally sum;
    // Every third one is wild: fewer than 20 worlds may have too few bodies that leave the range of numbers.
    const auto worlds = static_cast<std::uint64_t>(seeds(20, 500));
    for (std::uint64_t seed = 1; seed <= worlds; ++seed) {
        INFO("seed " << seed);
        RandomEditor editor(seed, {.wild = seed % 3 == 0, .ledger = seed % 5 == 0});
        editor.run(allActions(), 2000);
        editor.check();
        addTally(sum, editor.tally);
    }
    const auto share = static_cast<long long>(worlds);
    CHECK(sum.begins > 100 * share);
    CHECK(sum.hits > 20 * share);
    CHECK(sum.visits > 20 * share);
    CHECK(sum.quarantines > share / 5);
    CHECK(sum.joints > 100 * share);
    CHECK(sum.breaks > 10 * share);
    CHECK(sum.gears > share);
    CHECK(sum.refusals > 100 * share);
    CHECK(sum.asked > 200 * share);
    CHECK(sum.found > sum.asked / 4);
    CHECK(sum.fields > 10 * share);
    CHECK(sum.blasts > 5 * share);
    CHECK(sum.copies > share);
}

TEST_CASE("a world of 30 m x 24 m that wraps tells the truth about itself after 10,000 random calls",
          "[dynamics][editing][wrap][tiles]") {
    RandomEditor::Tally sum;
    const auto worlds = static_cast<std::uint64_t>(cases(100));
    for (std::uint64_t seed = 1; seed <= worlds; ++seed) {
        INFO("seed " << seed);
        Wrap wrap;
        if (seed % 3 != 0) wrap.width = 30;
        if (seed % 3 != 1) wrap.height = 24;
        RandomEditor editor(seed, {.ledger = seed % 5 == 0, .wrap = wrap});
        editor.run(wrappedActions(), 1000);
        editor.check();
        for (const BodyMoved& move : editor.world.moves()) CHECK(wrap.place(move.pose.position) == move.pose.position);
        addTally(sum, editor.tally);
    }
    const auto share = static_cast<long long>(worlds);
    CHECK(sum.begins > 50 * share);
    CHECK(sum.visits > 10 * share);
    CHECK(sum.joints > 50 * share);
    CHECK(sum.fields > 5 * share);
    CHECK(sum.copies > share / 2);
}

TEST_CASE("a world that is edited in 3,000 random ways has the same bits for 1, 4, 8 and 16 lanes",
          "[dynamics][editing][law]") {
    const auto last = static_cast<std::uint64_t>(seeds(3, 5));  // the third one is wild
    for (std::uint64_t seed = 1; seed <= last; ++seed) {
        std::vector<std::uint64_t> states, heard;
        for (const int lanes : {1, 4, 8, 16}) {
            RandomEditor editor(seed, {.lanes = lanes, .wild = seed % 3 == 0});
            editor.run(allActions(), allCases(3000));
            states.push_back(stateHash(editor.world));
            heard.push_back(editor.heard);
        }
        for (const std::uint64_t hash : states) CHECK(hash == states[0]);
        for (const std::uint64_t hash : heard) CHECK(hash == heard[0]);
    }
}

TEST_CASE("a world that wraps and is edited in 1,000 random ways has the same bits for 1, 4, 8 and 16 lanes",
          "[dynamics][editing][wrap][tiles]") {
    const auto last = static_cast<std::uint64_t>(seeds(1, 3));
    for (std::uint64_t seed = 1; seed <= last; ++seed) {
        std::vector<std::uint64_t> states;
        for (const int lanes : {1, 4, 8, 16}) {
            RandomEditor editor(seed, {.lanes = lanes, .wrap = {.width = 30.0, .height = 24.0}});
            editor.run(wrappedActions(), 1000);
            states.push_back(stateHash(editor.world));
        }
        for (const std::uint64_t hash : states) CHECK(hash == states[0]);
    }
}

TEST_CASE("a world that is asked 300 questions, or keeps account, goes on as one that does neither",
          "[dynamics][editing][law]") {
    const auto last = static_cast<std::uint64_t>(seeds(2, 5));
    for (std::uint64_t seed = 1; seed <= last; ++seed) {
        INFO("seed " << seed);
        std::vector<std::uint64_t> states;
        for (const bool asks : {true, false}) {
            for (const bool ledger : {true, false}) {
                RandomEditor editor(seed, {.ledger = ledger, .asks = asks});
                editor.run(allActions(), allCases(2000));
                if (asks) CHECK(editor.tally.asked > allCases(300));
                states.push_back(stateHash(editor.world));
            }
        }
        for (const std::uint64_t hash : states) CHECK(hash == states[0]);
    }
}
