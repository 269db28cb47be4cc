// SPDX-License-Identifier: MIT
// What do repeated runs of several engines say together?
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <compare/bench/measure.h>

namespace plumb::compare {

struct Spread {
    double min = 0, median = 0, max = 0;
};

/// Of at least one value; the median of an even number is the mean of the two in the middle.
Spread spreadOf(std::vector<double> values);

/// Of the steps of a run: the middle one, the one below which 99 % are, and the longest.
struct StepTimes {
    double median = 0, p99 = 0, worst = 0;
};

/// Of at least one step; by nearest rank.
StepTimes stepTimesOf(std::vector<double> milliseconds);

/// One engine in one scene.
struct EngineBench {
    std::string engine{};
    std::string version{};
    std::vector<BenchRun> runs{};  ///< a run a repeat; the first says whether the engine can

    bool supported() const { return !runs.empty() && runs.front().unsupported.empty(); }
    Spread msPerStep() const;           ///< over the repeats
    double leastMs() const;             ///< mean of the steps, a step's time being its least over the repeats
    StepTimes stepMs() const;           ///< of the steps, likewise
    Integrity integrity() const;        ///< of the first repeat that was looked at; empty when none was
    long peakKb() const;                ///< the smallest of the repeats: a look takes some
    double busy() const;                ///< the smallest of the repeats
    std::vector<Phase> phases() const;  ///< mean of the repeats [s]
};

struct SceneBench {
    std::string scene{};
    std::string group{};   ///< as in BenchScene
    std::string family{};  ///< likewise
    std::string question{};
    std::size_t bodies = 0, joints = 0;
    int steps = 0;
    std::vector<EngineBench> engines{};
};

/// How many times longer another engine takes than Plumb: above 1 Plumb is faster.
struct Ratio {
    std::string scene{};
    std::string against{};
    Spread ratio{};    ///< repeat by repeat, as far as both were run
    double least = 0;  ///< of the times that leastMs gives
};

/// Of all scenes in which both were run; none when Plumb was not.
std::vector<Ratio> ratiosOf(std::span<const SceneBench> results);

/// The geometric mean of Ratio::least against an engine, over the scenes of a group.
struct MeanRatio {
    std::string group{};
    std::string against{};
    double ratio = 0;
    std::size_t scenes = 0;
};
/// Of "six" and "random", where scenes of them were run.
std::vector<MeanRatio> meanRatiosOf(std::span<const SceneBench> results);

/// The time of a step grows as bodies^exponent: the slope of the least-squares line through log time over log bodies.
struct Growth {
    std::string family{};
    std::string engine{};
    double exponent = 0;
    std::size_t from = 0, to = 0;  ///< bodies of the smallest and the largest scene
};

/// Of each family of which an engine ran scenes of two sizes or more.
std::vector<Growth> growthsOf(std::span<const SceneBench> results);

}  // namespace plumb::compare
