// SPDX-License-Identifier: MIT
#include <compare/bench/measure.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
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
    return {"busy", "1", noSettings, [work](const Scene&) { return std::make_unique<BusySimulation>(work); }};
}

}  // namespace

TEST_CASE("steps of 5 ms are measured as 5 ms, however long the scene takes to build", "[compare][bench]") {
    const auto slowScene = [] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        return oneDisc();
    };
    const BenchRun run = measureRun(slowScene, busy([] { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }));
    CHECK(run.bodies == 1);
    CHECK(run.steps == 10);
    CHECK(run.msPerStep >= 5);
    CHECK(run.msPerStep < 15);  // a sleeper may be woken late, on a busy machine; built in it would be 10 ms more
    CHECK(run.busy < 0.5);      // it slept
    REQUIRE(run.phases.size() == 2);
    CHECK(run.phases[1].name == "two");
    CHECK_THAT(run.phases[1].seconds, WithinAbs(0.5, 1e-12));  // the mean of ten equal ones
}

TEST_CASE("what a run takes of memory shows in its peak, and not in the next run's", "[compare][bench]") {
    constexpr std::size_t size = 64u << 20;  // [byte]
    const auto fill = [] {
        static std::vector<char> memory;
        memory.assign(size, 1);
    };
    const BenchRun large = measureRun(oneDisc, busy(fill), 1);
    const BenchRun small = measureRun(oneDisc, busy([] {}), 1);
    CHECK(large.peakKb - small.peakKb > 60 << 10);
    CHECK(large.peakKb - small.peakKb < 70 << 10);
}

TEST_CASE("steps may be given, an engine may say no, and one that fails is told of", "[compare][bench]") {
    CHECK(measureRun(oneDisc, busy([] {}), 3).steps == 3);
    CHECK(measureRun(oneDisc, unsupporting("none")).unsupported == "it has no such thing");
    CHECK_THROWS_WITH(measureRun(oneDisc, busy([] { throw std::runtime_error("it broke"); })), "busy: it broke");
    CHECK_THROWS_WITH(measureRun(oneDisc, busy([] { std::_Exit(3); })), "busy ended before its time");
    CHECK_THROWS_WITH(measureRun(oneDisc, busy([] { raise(SIGKILL); })), "busy ended by signal 9");
}

}  // namespace plumb::compare
