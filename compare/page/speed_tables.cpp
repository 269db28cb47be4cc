// SPDX-License-Identifier: MIT
#include <compare/page/speed_tables.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include <compare/bench/bench_table.h>
#include <compare/page/cells.h>
#include <compare/page/page_table.h>

namespace plumb::compare {
namespace {

/// "with AVX-512": the processor's feature by which the kit chooses its code when a program starts.
std::string processor() {
#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
    if (__builtin_cpu_supports("avx512f")) return " with AVX-512";
    if (__builtin_cpu_supports("avx2")) return " with AVX2";
    return " without AVX2";
#else
    return "";
#endif
}

std::vector<SceneBench> shownOneByOne(std::span<const SceneBench> results) {
    std::vector<SceneBench> shown;
    std::ranges::copy_if(results, std::back_inserter(shown),
                         [](const SceneBench& s) { return s.group != "scaling" && s.group != "random"; });
    return shown;
}

std::string nameOf(std::span<const SceneBench> results, const std::string& engine) {
    for (const EngineBench& bench : results.front().engines)
        if (bench.engine == engine) return displayName(bench);
    return engine;
}

std::string howMeasured(std::span<const SceneBench> results) {
    std::size_t repeats = 0;
    for (const SceneBench& scene : results)
        for (const EngineBench& bench : scene.engines) repeats = std::max(repeats, bench.runs.size());
    return fmt::format(
        "Processor time of a step on one thread{}: the mean of the run's steps, each step at its least of {} runs. An "
        "engine is run once where a run takes more than 10 s, and eight times as long as the fastest. How many times "
        "as "
        "long as Plumb's a step of {} takes: of these times, and run by run. Above 1, Plumb is faster.\n",
        processor(), repeats, nameOf(results, rivalName()));
}

std::string ratioCell(const SceneBench& scene) {
    const std::optional<Ratio> ratio = ratioToRival(scene);
    if (!ratio) return "–";
    return fmt::format("{} ({}–{}){}", ratioText(ratio->least), ratioText(ratio->ratio.min),
                       ratioText(ratio->ratio.max), ratio->broken ? ", broken" : "");
}

Block speedBlock(std::span<const SceneBench> scenes, std::span<const SceneBench> results) {
    PageTable table{{"scene", "bodies"}, {}};
    for (const EngineBench& bench : scenes.front().engines) table.head.push_back(displayName(bench));
    table.head.insert(table.head.end(),
                      {nameOf(scenes, rivalName()) + " over Plumb", "99 % of the steps within", "worst step", "MB"});
    for (const SceneBench& scene : scenes) {
        std::vector<std::string> row{scene.scene, std::to_string(scene.bodies)};
        for (std::string& cell : cells(scene, [](const EngineBench& b) { return milliseconds(b.leastMs()); }))
            row.push_back(std::move(cell));
        row.push_back(ratioCell(scene));
        row.push_back(joinedCells(scene, [](const EngineBench& b) { return milliseconds(b.stepMs().p99); }));
        row.push_back(joinedCells(scene, [](const EngineBench& b) { return milliseconds(b.stepMs().worst); }));
        row.push_back(joinedCells(
            scene, [](const EngineBench& b) { return fmt::format("{:.0f}", static_cast<double>(b.peakKb()) / 1024); }));
        table.rows.push_back(std::move(row));
    }
    std::string text = markdown(table) + "\n" + howMeasured(scenes);
    for (const MeanRatio& mean : meanRatiosOf(results))
        if (mean.group == "six")
            text += fmt::format("{} over Plumb, geometric mean of {} of the six: {:.2f}{}.\n",
                                nameOf(scenes, mean.against), mean.scenes, mean.ratio, leftOutText(mean));
    return {"bench", "speed", "", text};
}

Block integrityBlock(std::span<const SceneBench> scenes) {
    PageTable table{{"scene", "highest body", "deepest overlap", "largest gap of a joint", "passed a wall"}, {}};
    for (const SceneBench& scene : scenes)
        table.rows.push_back(
            {scene.scene, joinedCells(scene, [](const EngineBench& b) { return heightCell(b.integrity().highest); }),
             joinedCells(scene, [](const EngineBench& b) { return lengthCell(b.integrity().overlap); }),
             joinedCells(scene, [](const EngineBench& b) { return lengthCell(b.integrity().jointGap); }),
             joinedCells(scene, [](const EngineBench& b) {
                 const Integrity seen = b.integrity();
                 return seen.passedWalls ? std::to_string(*seen.passedWalls) : "–";
             })});
    std::vector<std::string> names;
    for (const EngineBench& bench : scenes.front().engines) names.push_back(displayName(bench));
    return {"bench", "integrity", "", markdown(table) + fmt::format("\nIn each cell: {}.\n", fmt::join(names, " / "))};
}

Block growthBlock(std::span<const SceneBench> results) {
    std::string text;
    for (const Growth& growth : growthsOf(results))
        if (growth.family == "pile" || growth.family == "pyramids")
            text += fmt::format("- {}, {} to {} bodies: the time of a step grows as n^{:.2f} in {}.\n", growth.family,
                                growth.from, growth.to, growth.exponent, nameOf(results, growth.engine));
    return {"bench", "growth", "", text};
}

/// "pairs 12 %, solve 60 %": the share of each phase in a step, as the engine reports it.
std::string sharesOf(const std::vector<Phase>& phases) {
    double whole = 0;
    for (const Phase& phase : phases) whole += phase.seconds;
    std::vector<std::string> shares;
    for (const Phase& phase : phases)
        shares.push_back(fmt::format("{} {:.0f} %", phase.name, 100 * phase.seconds / whole));
    return fmt::format("{}", fmt::join(shares, ", "));
}

Block phasesBlock(std::span<const SceneBench> scenes) {
    std::string text;
    for (const SceneBench& scene : scenes)
        if (const EngineBench* plumb = runOf(scene, subjectName()))
            text += fmt::format("- {}: {}\n", scene.scene, sharesOf(plumb->phases()));
    return {"bench", "phases", "", text};
}

}  // namespace

std::vector<Block> speedBlocks(std::span<const SceneBench> results) {
    const auto ran = [&](std::string_view engine) {
        return std::ranges::any_of(results.front().engines, [&](const EngineBench& b) { return b.engine == engine; });
    };
    if (!ran(subjectName()) || !ran(rivalName()))
        throw std::invalid_argument(
            fmt::format("the tables of speed compare {} with {}, wanted both", subjectName(), rivalName()));
    std::vector<Block> blocks;
    const std::vector<SceneBench> scenes = shownOneByOne(results);
    if (!scenes.empty()) {
        blocks.push_back(speedBlock(scenes, results));
        blocks.push_back(integrityBlock(scenes));
        blocks.push_back(phasesBlock(scenes));
    }
    for (const Block& block :
         {growthBlock(results), randomBlock(results), summaryBlock(results), jointedBlock(results)})
        if (!block.body.empty()) blocks.push_back(block);
    return blocks;
}

}  // namespace plumb::compare
