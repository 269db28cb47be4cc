// SPDX-License-Identifier: MIT
// What is the result of repeated runs of several engines?
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

/// It needs at least one value. The median of an even number of values is the mean of the two in the middle.
Spread spreadOf(std::vector<double> values);

/// Times of a run's steps: the middle one, the one below which 99 % of the steps are, and the longest.
struct StepTimes {
    double median = 0, p99 = 0, worst = 0;
};

/// It needs at least one step; by nearest rank.
StepTimes stepTimesOf(std::vector<double> milliseconds);

/// The runs of one engine in one scene.
struct EngineBench {
    std::string engine{};
    std::string version{};
    std::vector<BenchRun> runs{};  ///< one run for each repeat; the first says whether the engine can run the scene

    bool supported() const { return !runs.empty() && runs.front().unsupported.empty(); }
    Spread msPerStep() const;           ///< over the repeats
    double leastMs() const;             ///< mean of the steps; a step's time is its least of all repeats
    StepTimes stepMs() const;           ///< a step's time is again its least of all repeats
    Integrity integrity() const;        ///< of the first repeat that was looked at; empty if there is none
    long peakKb() const;                ///< the smallest of the repeats, because a look takes memory
    double busy() const;                ///< the smallest of the repeats
    std::vector<Phase> phases() const;  ///< mean of the repeats [s]
};

struct SceneBench {
    std::string scene{};
    std::string group{};   ///< as in BenchScene
    std::string family{};  ///< as in BenchScene
    std::string question{};
    std::size_t bodies = 0, joints = 0;
    int steps = 0;
    std::vector<EngineBench> engines{};
};

/// Another engine's time divided by Plumb's: above 1, Plumb is faster.
struct Ratio {
    std::string scene{};
    std::string against{};
    Spread ratio{};       ///< of each repeat in which both were run
    double least = 0;     ///< the ratio of the times from leastMs
    bool broken = false;  ///< what one of the two made is of no use: see isBroken
};

/// The ratios of all scenes in which both engines were run; empty if Plumb was not run.
std::vector<Ratio> ratiosOf(std::span<const SceneBench> results);

/// The geometric mean of Ratio::least of one engine, over the scenes of a group that are not broken.
struct MeanRatio {
    std::string group{};
    std::string against{};
    double ratio = 0;                    ///< NaN if all scenes are broken
    std::size_t scenes = 0;              ///< how many count
    std::vector<std::string> leftOut{};  ///< those that are broken
};
/// The means of the groups "six" and "random", if any of their scenes were run.
std::vector<MeanRatio> meanRatiosOf(std::span<const SceneBench> results);

/// The time of a step grows as bodies^exponent: the slope of the least-squares line through log time over log bodies.
struct Growth {
    std::string family{};
    std::string engine{};
    double exponent = 0;
    std::size_t from = 0, to = 0;  ///< number of bodies in the smallest and the largest scene
};

/// One growth for each engine and each family of which it ran scenes of at least two sizes.
std::vector<Growth> growthsOf(std::span<const SceneBench> results);

}  // namespace plumb::compare
