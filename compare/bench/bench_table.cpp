// SPDX-License-Identifier: MIT
#include <compare/bench/bench_table.h>

#include <fmt/format.h>
#include <fmt/ostream.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <ostream>

#include <compare/metric/length_text.h>

namespace plumb::compare {
namespace {

constexpr double disturbed = 0.9;  // a run that had the processor for less of its time is of little use [-]
constexpr const char* layout =
    "{:{}}  {:>6}  {:>5}  {:10}  {:>8}  {:>8}  {:>8}  {:>8}  {:>20}  {:>6}  {:>9}  {:>8}  {:>8}  {:>6}\n";

std::string ratioCell(const SceneBench& scene, const EngineBench& bench) {
    for (const Ratio& ratio : ratiosOf({&scene, 1}))
        if (ratio.against == bench.engine)
            return fmt::format("{:.3g} ({:.3g} to {:.3g}){}", ratio.least, ratio.ratio.min, ratio.ratio.max,
                               ratio.broken ? " broken" : "");
    return "";
}

std::string heightText(const std::optional<double>& height) {
    return height ? fmt::format("{:.3g} m", *height) : "-";
}

std::string gapText(const std::optional<double>& length) {
    return length ? lengthText(*length) : "-";
}

void printPhases(std::ostream& out, std::span<const SceneBench> results) {
    fmt::print(out, "\nWhere a step goes, as each engine tells it [ms]\n");
    for (const SceneBench& scene : results) {
        fmt::print(out, "{}\n", scene.scene);
        for (const EngineBench& bench : scene.engines) {
            if (!bench.supported() || bench.phases().empty()) continue;
            fmt::print(out, "    {:10}", bench.engine);
            for (const Phase& phase : bench.phases()) fmt::print(out, "  {} {:.3g}", phase.name, phase.seconds * 1000);
            fmt::print(out, "\n");
        }
    }
}

}  // namespace

std::string timeText(double milliseconds) {
    if (milliseconds < 0.1) return fmt::format("{:.3g} us", milliseconds * 1000);
    return fmt::format("{:.3g} ms", milliseconds);
}

std::string leftOutText(const MeanRatio& mean) {
    if (mean.leftOut.empty()) return "";
    return fmt::format("; left out, because a joint opened by more than 1 m or a body was lost: {}",
                       fmt::join(mean.leftOut, ", "));
}

BenchTable::BenchTable(std::ostream& out, std::size_t nameWidth)
    : out_(out), nameWidth_(std::max<std::size_t>(nameWidth, 5)) {}

void BenchTable::head() const {
    fmt::print(
        out_,
        "Processor time of a step, each step at its least over the repeats; over Plumb: how many times as long "
        "(repeat by repeat);\nthen the highest body at the end, the deepest overlap, the largest gap of a joint, "
        "and what passed a wall\n");
    fmt::print(out_, layout, "scene", nameWidth_, "bodies", "steps", "engine", "mean", "median", "p99", "worst",
               "over Plumb", "MB", "highest", "overlap", "gap", "passed");
    out_.flush();
}

void BenchTable::row(const SceneBench& scene, const EngineBench& bench) const {
    const StepTimes steps = bench.stepMs();
    const Integrity seen = bench.integrity();
    fmt::print(out_, layout, scene.scene, nameWidth_, scene.bodies, scene.steps, bench.engine,
               timeText(bench.leastMs()), timeText(steps.median), timeText(steps.p99), timeText(steps.worst),
               ratioCell(scene, bench), fmt::format("{:.1f}", static_cast<double>(bench.peakKb()) / 1024),
               heightText(seen.highest), gapText(seen.overlap), gapText(seen.jointGap),
               seen.passedWalls ? std::to_string(*seen.passedWalls) : "-");
    if (bench.busy() < disturbed)
        fmt::print(out_, "    {} had the processor for {:.0f} % of a run only: others were at work\n", bench.engine,
                   bench.busy() * 100);
}

void BenchTable::rows(const SceneBench& scene) const {
    for (const EngineBench& bench : scene.engines) {
        if (bench.supported())
            row(scene, bench);
        else
            fmt::print(out_, "{:{}}  unsupported by {}: {}\n", scene.scene, nameWidth_, bench.engine,
                       bench.runs.front().unsupported);
    }
    out_.flush();
}

void BenchTable::summary(std::span<const SceneBench> results) const {
    const std::vector<MeanRatio> means = meanRatiosOf(results);
    if (!means.empty()) fmt::print(out_, "\n");
    for (const MeanRatio& mean : means)
        fmt::print(out_, "{} over Plumb, geometric mean of {} of {}: {:.2f}{}\n", mean.against, mean.scenes, mean.group,
                   mean.ratio, leftOutText(mean));
    const std::vector<Growth> growths = growthsOf(results);
    if (!growths.empty()) fmt::print(out_, "\n");
    for (const Growth& growth : growths)
        fmt::print(out_, "{}, {}: the time of a step grows as bodies^{:.3f} from {} to {}\n", growth.family,
                   growth.engine, growth.exponent, growth.from, growth.to);
    printPhases(out_, results);
    out_.flush();
}

}  // namespace plumb::compare
