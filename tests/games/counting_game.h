// SPDX-License-Identifier: MIT
// Which game is so simple that a test knows all of it?
#pragma once
#include <games/frame/game.h>
#include <games/frame/hash.h>

namespace plumb::test {

/// Counts its ticks and the presses of "hit". Ten hits win, "give-up" loses. Each hit plays a cue.
class CountingGame final : public games::Game {
public:
    explicit CountingGame(const games::GameSetup& setup) : setup_(setup) {}

    void update(const games::Input& input) override {
        ++ticks;
        if (input.pressed("hit")) {
            ++hits;
            play({.from = 100});
        }
        lost = input.held("give-up");
    }
    void draw(games::Canvas& canvas) const override {
        canvas.look({.center = {1, 2}, .height = 4});
        canvas.circle({canvas.between(), 0}, 1, games::Color{});
        if (canvas.behind() == games::Behind::Nothing) canvas.text({1, 2}, "Ready!", {.size = 0.1});
        if (canvas.behind() != games::Behind::Title) canvas.text({1, 1}, "hits so far", {.size = 0.1});
    }
    void drawDebug(games::Canvas& canvas) const override { canvas.text({1, 1.5}, "plans", {.size = 0.1}); }
    games::Progress progress() const override {
        const auto outcome = hits >= 10 ? games::Outcome::Won : lost ? games::Outcome::Lost : games::Outcome::Running;
        return {outcome, 10 * hits};
    }
    std::uint64_t hash() const override { return games::Hash().add(ticks).add(hits).add(setup_.seed).value(); }

    int ticks = 0, hits = 0;
    bool lost = false;

private:
    games::GameSetup setup_;
};

/// Presses "hit" in every other tick.
class CountingPlayer final : public games::Player {
public:
    games::Buttons decide(const games::Game& game) override {
        return static_cast<const CountingGame&>(game).ticks % 2 == 0 ? 1 : 0;
    }
};

inline games::GameInfo countingGame() {
    using games::Key, games::Pad;
    return {.name = "counting",
            .title = "Counting",
            .about = "Ten hits win.",
            .actions = {{"hit", {Key::Space}, {Pad::South}, "hit"}, {"give-up", {Key::G}}},
            .options = {{"strength", "of the other", "weak", {"weak", "strong"}, "Other"}, {"level", "a file", "one"}},
            .make = [](const games::GameSetup& setup) { return std::make_unique<CountingGame>(setup); },
            .computer = [](const games::GameSetup&) { return std::make_unique<CountingPlayer>(); }};
}

}  // namespace plumb::test
