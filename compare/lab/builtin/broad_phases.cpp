// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <string>

#include <compare/lab/builtin/labs.h>
#include <compare/lab/graph.h>
#include <compare/scene/crowd.h>
#include <plumb/math/random.h>

namespace plumb::compare {
namespace {

constexpr int sizes[] = {64, 128, 256, 512, 1024, 2048, 4096, 8192, 16384};
constexpr std::size_t fitted = 5;  // the largest n: few boxes have more edge, and half-empty blocks

struct WayToFind {
    BroadPhase phase;
    std::string name, tag;
};

/// The others are compared with the first.
const WayToFind ways[] = {{BroadPhase::BruteForce, "brute force", "brute_force"},
                          {BroadPhase::Grid, "grid", "grid"},
                          {BroadPhase::SweepAndPrune, "sweep and prune", "sweep_and_prune"},
                          {BroadPhase::Bvh, "hierarchy (BVH)", "bvh"}};

struct Kind {
    std::string name;
    std::vector<Aabb> (*scene)(int n, Random& random);
};

const Kind kinds[] = {{"even", evenBoxes}, {"uneven", unevenBoxes}};

struct TimedSearch {
    PairSearch found{};
    double time = std::numeric_limits<double>::infinity();  ///< [s]
};

/// The shortest time of several searches: other work of the machine makes a search longer, never shorter.
TimedSearch timedSearch(const PairFinder& find, BroadPhase phase, const std::vector<Aabb>& boxes) {
    TimedSearch result;
    double spent = 0;
    for (int run = 0; run < 5 && spent < 0.05; ++run) {
        const auto start = std::chrono::steady_clock::now();
        result.found = find(phase, boxes);
        const double time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        result.time = std::min(result.time, time);
        spent += time;
    }
    return result;
}

/// "134 million", "73 thousand".
std::string countText(double count) {
    if (count >= 1e6) return fmt::format("{:.3g} million", count / 1e6);
    if (count >= 1e4) return fmt::format("{:.0f} thousand", count / 1e3);
    return fmt::format("{:.0f}", count);
}

struct Measurement {
    std::vector<Point> tests{}, times{};  ///< over n
};

double growth(const std::vector<Point>& points) {
    const std::size_t skipped = points.size() - std::min(points.size(), fitted);
    return exponent(std::span(points).subspan(skipped)).value_or(std::nan(""));
}

std::string powerNote(const std::vector<Point>& points) {
    return fmt::format("n^{:.2f}", growth(points));
}

/// Measures how many tests and how much time each way needs for each n, and counts the searches whose pairs differ from
/// those of brute force.
void runKind(const Kind& kind, const PairFinder& find, LabRun& run) {
    std::vector<Measurement> measured(std::size(ways));
    Curve pairs{.name = "pairs that overlap", .theory = true};
    Random random(27);
    for (const int n : sizes) {
        const std::vector<Aabb> boxes = kind.scene(n, random);
        SortedPairs truth;
        for (std::size_t i = 0; i < std::size(ways); ++i) {
            const auto [found, time] = timedSearch(find, ways[i].phase, boxes);
            if (i == 0) truth = found.pairs;
            run.values["pairs_that_differ"] += found.pairs != truth;
            measured[i].tests.push_back({static_cast<double>(n), static_cast<double>(found.tests)});
            measured[i].times.push_back({static_cast<double>(n), time});
        }
        pairs.points.push_back({static_cast<double>(n), static_cast<double>(truth.size())});
    }
    Graph tests{.title = fmt::format("Tests made, {} scene", kind.name),
                .x = {"boxes n", "", true},
                .y = {"tests of two boxes", "", true}};
    Graph times{.title = fmt::format("Time, {} scene", kind.name),
                .x = {"boxes n", "", true},
                .y = {"time of a search", "s", true}};
    std::string told = fmt::format("{} boxes in the {} scene, {} pairs that overlap: tests made, and time, by",
                                   sizes[std::size(sizes) - 1], kind.name, countText(pairs.points.back().y));
    for (std::size_t i = 0; i < std::size(ways); ++i) {
        const Measurement& m = measured[i];
        tests.curves.push_back({.name = ways[i].name, .points = m.tests, .note = powerNote(m.tests)});
        times.curves.push_back({.name = ways[i].name, .points = m.times, .note = powerNote(m.times)});
        run.values["tests." + kind.name + "." + ways[i].tag] = growth(m.tests);
        told += fmt::format("{} {}: {}, {:.3g} ms", i == 0 ? "" : ";", ways[i].name, countText(m.tests.back().y),
                            1000 * m.times.back().y);
    }
    tests.curves.push_back(pairs);
    run.graphs.push_back(tests);
    run.graphs.push_back(times);
    run.seen.push_back(told + ".");
}

LabRun runBroadPhases(const PairFinder& find) {
    LabRun run;
    run.values["pairs_that_differ"] = 0;
    for (const Kind& kind : kinds) runKind(kind, find, run);
    const auto power = [&](const std::string& of) { return run.values.at("tests." + of); };
    run.values["tests.even.brute_force.off"] = std::fabs(power("even.brute_force") - 2);
    run.values["tests.even.sweep_and_prune.off"] = std::fabs(power("even.sweep_and_prune") - 1.5);
    run.seen.insert(
        run.seen.begin(),
        fmt::format("Tests grow as n to the power of {:.2f} by brute force, {:.2f} in a grid, {:.2f} by sweep and "
                    "prune and {:.2f} in a hierarchy, where boxes lie evenly; where they do not, {:.2f}, {:.2f}, "
                    "{:.2f} and {:.2f}.",
                    power("even.brute_force"), power("even.grid"), power("even.sweep_and_prune"), power("even.bvh"),
                    power("uneven.brute_force"), power("uneven.grid"), power("uneven.sweep_and_prune"),
                    power("uneven.bvh")));
    run.seen.push_back(
        "Why 1.5 for sweep and prune: the plane's side grows as the root of n, and the line that sweeps over it meets "
        "all boxes across it, which are as many, although most are far apart along the line. A hierarchy counts its "
        "tests by blocks of 8 by 8, which are made side by side: hence its time.");
    return run;
}

}  // namespace

Lab broadPhases(const PairFinder& find) {
    return {.name = "broad_phases",
            .question = "How do the tests that find all overlapping pairs grow with the number of boxes?",
            .varied =
                "boxes, from 64 to 16,384 at the same density; lying evenly, or half of them in a heap and of "
                "many sizes",
            .checks = {{.name = "pairs_that_differ",
                        .reason = "every way finds the same pairs as brute force, in the same order"},
                       {.name = "tests.even.brute_force.off",
                        .limit = 0.001,
                        .reason = "n (n - 1) / 2 tests: the slope is 2 + 1 / (n - 1), from 1,024 boxes on"},
                       {.name = "tests.even.grid",
                        .limit = 1.1,
                        .reason = "each box is tested against the boxes of nine cells; these are as many at any n, and "
                                  "fewer at the edge"},
                       {.name = "tests.even.sweep_and_prune.off",
                        .limit = 0.05,
                        .reason =
                            "of n (n - 1) / 2 pairs, those within 1 m along a side of 2 sqrt(n) m are tested: a share "
                            "of 1 / sqrt(n); the slope is 1.5 to 0.005, and some per cent off by chance"},
                       {.name = "tests.even.bvh",
                        .limit = 1.25,
                        .reason = "each box goes down a tree of log n levels, and almost nothing overlaps at its top"}},
            .run = [find](const std::vector<Engine>&) { return runBroadPhases(find); }};
}

}  // namespace plumb::compare
