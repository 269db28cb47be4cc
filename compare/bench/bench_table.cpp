// SPDX-License-Identifier: MIT
#include <compare/bench/bench_table.h>

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <algorithm>
#include <ostream>

namespace plumb::compare {
namespace {

constexpr int timeWidth = 11, ratioWidth = 22, memoryWidth = 8;
constexpr double disturbed = 0.9;  // of the time a run had the processor to itself: below, times are of little use [-]

const EngineBench* find(const SceneBench& scene, const std::string& engine) {
    for (const EngineBench& bench : scene.engines)
        if (bench.engine == engine) return &bench;
    return nullptr;
}

std::string timeCell(const EngineBench* bench) {
    if (!bench) return "-";
    return bench->supported() ? timeText(bench->msPerStep().median) : "unsupported";
}

std::string memoryCell(const EngineBench* bench) {
    if (!bench || !bench->supported()) return "-";
    return fmt::format("{:.1f}", static_cast<double>(bench->peakKb()) / 1024);
}

std::string ratioCell(const std::vector<Ratio>& ratios, const std::string& against) {
    for (const Ratio& ratio : ratios)
        if (ratio.against == against)
            return fmt::format("{:.2f} ({:.2f} to {:.2f})", ratio.ratio.median, ratio.ratio.min, ratio.ratio.max);
    return "-";
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

BenchTable::BenchTable(std::ostream& out, std::vector<std::string> engines, std::size_t nameWidth)
    : out_(out), engines_(std::move(engines)), nameWidth_(std::max<std::size_t>(nameWidth, 5)) {}

bool BenchTable::comparesWithPlumb() const {
    return std::ranges::find(engines_, plumbName) != engines_.end();
}

void BenchTable::head() const {
    fmt::print(out_,
               "median of a step; how many times longer than Plumb another takes (least to most); peak memory [MB]\n");
    fmt::print(out_, "{:{}}  {:>6}  {:>5}", "scene", nameWidth_, "bodies", "steps");
    for (const std::string& engine : engines_) fmt::print(out_, "  {:>{}}", engine, timeWidth);
    for (const std::string& engine : engines_)
        if (comparesWithPlumb() && engine != plumbName) fmt::print(out_, "  {:>{}}", engine + " / plumb", ratioWidth);
    for (const std::string& engine : engines_) fmt::print(out_, "  {:>{}}", engine + " MB", memoryWidth);
    fmt::print(out_, "\n");
    out_.flush();
}

void BenchTable::row(const SceneBench& scene) const {
    const std::vector<Ratio> ratios = ratiosOf({&scene, 1});
    fmt::print(out_, "{:{}}  {:>6}  {:>5}", scene.scene, nameWidth_, scene.bodies, scene.steps);
    for (const std::string& engine : engines_) fmt::print(out_, "  {:>{}}", timeCell(find(scene, engine)), timeWidth);
    for (const std::string& engine : engines_)
        if (comparesWithPlumb() && engine != plumbName)
            fmt::print(out_, "  {:>{}}", ratioCell(ratios, engine), ratioWidth);
    for (const std::string& engine : engines_)
        fmt::print(out_, "  {:>{}}", memoryCell(find(scene, engine)),
                   std::max(memoryWidth, static_cast<int>(engine.size()) + 3));
    fmt::print(out_, "\n");
    for (const EngineBench& bench : scene.engines) {
        if (!bench.supported()) fmt::print(out_, "    {}: {}\n", bench.engine, bench.runs.front().unsupported);
        if (bench.supported() && bench.busy() < disturbed)
            fmt::print(out_, "    {} had the processor for {:.0f} % of a run only: others were at work\n", bench.engine,
                       bench.busy() * 100);
    }
    out_.flush();
}

void BenchTable::summary(std::span<const SceneBench> results) const {
    const std::vector<MeanRatio> means = meanRatiosOf(results);
    if (!means.empty()) fmt::print(out_, "\n");
    for (const MeanRatio& mean : means)
        fmt::print(out_, "{} / plumb, geometric mean of {}: {:.2f}\n", mean.against, mean.scenes, mean.ratio);
    const std::vector<Growth> growths = growthsOf(results);
    if (!growths.empty()) fmt::print(out_, "\n");
    for (const Growth& growth : growths)
        fmt::print(out_, "{}, {}: the time of a step grows as bodies^{:.3f} from {} to {}\n", growth.family,
                   growth.engine, growth.exponent, growth.from, growth.to);
    printPhases(out_, results);
    out_.flush();
}

}  // namespace plumb::compare
