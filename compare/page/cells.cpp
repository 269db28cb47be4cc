// SPDX-License-Identifier: MIT
#include <compare/page/cells.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include <compare/metric/length_text.h>

namespace plumb::compare {

const EngineBench* runOf(const SceneBench& scene, std::string_view engine) {
    for (const EngineBench& bench : scene.engines)
        if (bench.engine == engine && bench.supported()) return &bench;
    return nullptr;
}

std::string displayName(const EngineBench& bench) {
    return columnName(bench.engine, bench.version);
}

std::string milliseconds(double ms) {
    if (ms >= 1000) return fmt::format("{:.3g} s", ms / 1000);
    return ms < 0.1 ? fmt::format("{:.3g} µs", ms * 1000) : fmt::format("{:.3g} ms", ms);
}

std::vector<std::string> cells(const SceneBench& scene, const std::function<std::string(const EngineBench&)>& cell) {
    std::vector<std::string> result;
    for (const EngineBench& bench : scene.engines) result.push_back(bench.supported() ? cell(bench) : "–");
    return result;
}

std::string joinedCells(const SceneBench& scene, const std::function<std::string(const EngineBench&)>& cell) {
    return fmt::format("{}", fmt::join(cells(scene, cell), " / "));
}

std::string heightCell(const std::optional<double>& height) {
    if (!height) return "–";
    return std::isinf(*height) ? "infinite" : fmt::format("{:.3g} m", *height);
}

std::string lengthCell(const std::optional<double>& length) {
    return length ? lengthText(*length) : "–";
}

std::optional<Ratio> ratioToRival(const SceneBench& scene) {
    for (const Ratio& ratio : ratiosOf({&scene, 1}))
        if (ratio.against == rivalName()) return ratio;
    return {};
}

std::string ratioText(double ratio) {
    return ratio >= 10 ? fmt::format("{:.0f}", ratio) : fmt::format("{:#.2g}", ratio);
}

}  // namespace plumb::compare
