// SPDX-License-Identifier: MIT
#include <compare/bench/readme.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace plumb::compare {
namespace {

constexpr std::string_view beginLine = "<!-- bench begin -->\n", endLine = "<!-- bench end -->";

std::string displayName(const EngineBench& bench) {
    if (bench.engine == plumbName) return "Plumb";
    return isBox2d(bench.engine) ? "Box2D " + bench.version : bench.engine;
}

std::string timeCell(const EngineBench& bench) {
    if (!bench.supported()) return "unsupported";
    const double ms = bench.msPerStep().median;
    return ms < 0.1 ? fmt::format("{:.3g} µs", ms * 1000) : fmt::format("{:.3g} ms", ms);
}

std::string memoryCell(const EngineBench& bench) {
    return bench.supported() ? fmt::format("{:.0f}", static_cast<double>(bench.peakKb()) / 1024) : "–";
}

std::string ratioCell(const std::vector<Ratio>& ratios, const EngineBench& against) {
    for (const Ratio& ratio : ratios)
        if (ratio.against == against.engine)
            return fmt::format("{:.2f} ({:.2f}–{:.2f})", ratio.ratio.median, ratio.ratio.min, ratio.ratio.max);
    return "–";
}

bool isRival(const EngineBench& bench) {
    return bench.engine != plumbName;
}

std::string headOf(const SceneBench& scene) {
    std::string head = "| scene | bodies |", rule = "|---|---|", memory;
    for (const EngineBench& bench : scene.engines) {
        head += " " + displayName(bench) + " |";
        rule += "---|";
        memory += (memory.empty() ? "" : " / ") + displayName(bench);
    }
    for (const EngineBench& bench : scene.engines) {
        if (!isRival(bench)) continue;
        head += " " + displayName(bench) + " over Plumb |";
        rule += "---|";
    }
    return head + " peak MB: " + memory + " |\n" + rule + "---|\n";
}

std::string rowOf(const SceneBench& scene) {
    const std::vector<Ratio> ratios = ratiosOf({&scene, 1});
    std::string row = fmt::format("| {} | {} |", scene.scene, scene.bodies), memory;
    for (const EngineBench& bench : scene.engines) {
        row += " " + timeCell(bench) + " |";
        memory += (memory.empty() ? "" : " / ") + memoryCell(bench);
    }
    for (const EngineBench& bench : scene.engines)
        if (isRival(bench)) row += " " + ratioCell(ratios, bench) + " |";
    return row + " " + memory + " |\n";
}

/// "pairs 12 %, solve 60 %": what share of a step each phase has, as the engine tells it.
std::string sharesOf(const std::vector<Phase>& phases) {
    double whole = 0;
    for (const Phase& phase : phases) whole += phase.seconds;
    std::vector<std::string> shares;
    for (const Phase& phase : phases)
        shares.push_back(fmt::format("{} {:.0f} %", phase.name, 100 * phase.seconds / whole));
    return fmt::format("{}", fmt::join(shares, ", "));
}

std::string whereItGoes(const SceneBench& scene) {
    for (const EngineBench& bench : scene.engines)
        if (!isRival(bench) && bench.supported() && !bench.phases().empty())
            return fmt::format("- {}: {}\n", scene.scene, sharesOf(bench.phases()));
    return "";
}

/// Scenes of one kind and many sizes count for their growth, not one by one.
bool standsAlone(const SceneBench& scene, const std::vector<Growth>& growths) {
    return std::ranges::none_of(growths, [&](const Growth& growth) { return growth.family == scene.family; });
}

std::string nameOf(const SceneBench& scene, const std::string& engine) {
    for (const EngineBench& bench : scene.engines)
        if (bench.engine == engine) return displayName(bench);
    return engine;
}

}  // namespace

std::string benchMarkdown(std::span<const SceneBench> results) {
    const SceneBench& first = results.front();
    const std::vector<Growth> growths = growthsOf(results);
    std::string text = headOf(first), shares;
    for (const SceneBench& scene : results) {
        if (!standsAlone(scene, growths)) continue;
        text += rowOf(scene);
        shares += whereItGoes(scene);
    }
    text += fmt::format(
        "\nTime of a step on one thread, median of {} runs; how many times longer than Plumb's it is, run by run, "
        "median and spread.\n",
        first.engines.front().runs.size());
    for (const MeanRatio& mean : meanRatiosOf(results))
        text += fmt::format("{} over Plumb, geometric mean of {} scene{}: {:.2f}.\n", nameOf(first, mean.against),
                            mean.scenes, mean.scenes == 1 ? "" : "s", mean.ratio);
    for (const Growth& growth : growths)
        text += fmt::format("From {} to {} bodies ({}) the time of a step grows as n^{:.2f} in {}.\n", growth.from,
                            growth.to, growth.family, growth.exponent, nameOf(first, growth.engine));
    if (!shares.empty()) text += "\nWhere a step of Plumb's goes:\n\n" + shares;
    return text;
}

std::string withBench(const std::string& text, const std::string& markdown) {
    const std::size_t begin = text.find(beginLine);
    const std::size_t end = text.find(endLine);
    const bool once =
        text.find(beginLine, begin + 1) == std::string::npos && text.find(endLine, end + 1) == std::string::npos;
    if (begin == std::string::npos || end == std::string::npos || end < begin || !once)
        throw std::invalid_argument("it has no lines <!-- bench begin --> and <!-- bench end -->, once each");
    return text.substr(0, begin + beginLine.size()) + markdown + text.substr(end);
}

std::string readReadme(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    if (!file) throw std::invalid_argument(path.string() + ": cannot be read");
    try {
        (void)withBench(text, "");
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument(path.string() + ": " + error.what());
    }
    return text;
}

}  // namespace plumb::compare
