// SPDX-License-Identifier: MIT
#include <compare/bench/measure.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <thread>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

/// Its steps do what they are told.
class BusySimulation : public ScriptedSimulation {
public:
    explicit BusySimulation(std::function<void()> work)
        : ScriptedSimulation({[](double) { return std::vector<BodyState>{}; }}, 0), work_(std::move(work)) {}
    void step(double) override { work_(); }
    std::vector<Phase> phases() const override { return {{"one", 0.25}, {"two", 0.5}}; }

private:
    std::function<void()> work_;
};

Engine busy(const std::function<void()>& work) {
    return namedEngine("busy", [work](const Scene&) { return std::make_unique<BusySimulation>(work); });
}

}  // namespace

TEST_CASE("work of 5 ms of the processor is measured as 5 ms, sleep and building as nothing", "[compare][bench]") {
    const auto slowScene = [] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        return oneDisc();
    };
    const auto workAndSleep = [] {
        const std::clock_t begin = std::clock();
        while (std::clock() - begin < CLOCKS_PER_SEC / 200) {
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    };
    const BenchRun run = measureRun(slowScene, busy(workAndSleep));
    CHECK(run.bodies == 1);
    CHECK(run.steps == 10);
    CHECK_THAT(run.msPerStep, WithinAbs(5, 1));  // a clock of the processor that counts in microseconds
    CHECK(run.busy < 0.5);                       // it slept
    CHECK_FALSE(run.integrity);
    REQUIRE(run.phases.size() == 2);
    CHECK(run.phases[1].name == "two");
    CHECK_THAT(run.phases[1].seconds, WithinAbs(0.5, 1e-12));  // the mean of ten equal ones
}

TEST_CASE("a run that is looked at says where its bodies were, and takes no memory for it", "[compare][bench]") {
    const auto thrown = [](double time) {
        BodyState disc;
        disc.position = {0, 3 * time};
        return std::vector<BodyState>{disc};
    };
    const BenchRun run = measureRun(oneDisc, scripted("rising", {thrown}), {.look = true});
    REQUIRE(run.integrity);
    CHECK_THAT(run.integrity->highest.value(), WithinAbs(3, 1e-12));  // at the end
    CHECK_FALSE(run.integrity->overlap);                              // it is alone
    CHECK_FALSE(run.integrity->jointGap);
    CHECK_FALSE(run.integrity->passedWalls);
    const auto lost = [](double) { return std::vector<BodyState>{at(nan, 0)}; };
    CHECK(measureRun(oneDisc, scripted("lost", {lost}), {.look = true}).integrity->highest == infinity);
}

TEST_CASE("what a run takes of memory shows in its peak, and not in the next run's", "[compare][bench]") {
    constexpr std::size_t size = 64u << 20;  // [byte]
    const auto fill = [] {
        static std::vector<char> memory;
        memory.assign(size, 1);
    };
    const BenchRun large = measureRun(oneDisc, busy(fill), {.steps = 1});
    const BenchRun small = measureRun(oneDisc, busy([] {}), {.steps = 1});
    CHECK(large.peakKb - small.peakKb > 60 << 10);
#ifdef __SANITIZE_ADDRESS__
    CHECK(large.peakKb - small.peakKb < 74 << 10);  // an eighth more: its shadow
#else
    CHECK(large.peakKb - small.peakKb < 70 << 10);
#endif
}

TEST_CASE("steps may be given, an engine may say no, and one that fails is told of", "[compare][bench]") {
    CHECK(measureRun(oneDisc, busy([] {}), {.steps = 3}).steps == 3);
    CHECK(measureRun(oneDisc, unsupporting("none")).unsupported == "it has no such thing");
    CHECK_THROWS_WITH(measureRun(oneDisc, busy([] { throw std::runtime_error("it broke"); })), "busy: it broke");
    CHECK_THROWS_WITH(measureRun(oneDisc, busy([] { std::_Exit(3); })), "busy ended before its time");
    CHECK_THROWS_WITH(measureRun(oneDisc, busy([] { raise(SIGKILL); })), "busy ended by signal 9");
}

}  // namespace plumb::compare
