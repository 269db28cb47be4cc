// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>

#include <compare/report/report.h>

namespace plumb::compare {
namespace {

/// In quotes where it would otherwise fall apart (RFC 4180).
std::string quoted(const std::string& name) {
    if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
    std::string text(1, '"');
    for (const char c : name) text.append(c == '"' ? 2 : 1, c);
    text += '"';
    return text;
}

/// The fewest digits that read back as the same number; nothing where there is none.
std::string cell(double value) {
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

void write(std::ostream& file, const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) file << (i > 0 ? "," : "") << cells[i];
    file << '\n';
}

std::vector<std::string> header(const SceneResult& result) {
    std::vector<std::string> cells{"t"};
    for (const EngineResult& run : result.engines) {
        const std::string& engine = run.observation.engine;
        if (!run.observation.unsupported.empty()) continue;
        for (const SceneBody& body : result.scene.bodies)
            for (const char* what : {"x", "y", "angle"})
                cells.push_back(quoted(fmt::format("{}.{}.{}", engine, body.name, what)));
        for (const char* what : {"error", "energy"}) cells.push_back(fmt::format("{}.{}", engine, what));
    }
    return cells;
}

std::vector<std::string> row(const SceneResult& result, std::size_t tick) {
    std::vector<std::string> cells{cell(static_cast<double>(tick) * result.scene.dt)};
    for (const EngineResult& run : result.engines) {
        if (!run.observation.unsupported.empty()) continue;
        for (const BodyState& state : run.observation.states[tick])
            for (const double value : {state.position.x(), state.position.y(), state.angle})
                cells.push_back(cell(value));
        for (const std::vector<double>* series : {&run.measured.series.error, &run.measured.series.energy})
            cells.push_back(tick < series->size() ? cell((*series)[tick]) : "");
    }
    return cells;
}

std::size_t tickCount(const SceneResult& result) {
    std::size_t ticks = 0;
    for (const EngineResult& run : result.engines) ticks = std::max(ticks, run.observation.states.size());
    return ticks;
}

}  // namespace

void writeCsv(const std::vector<SceneResult>& results, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    for (const SceneResult& result : results) {
        const std::filesystem::path path = folder / (result.scene.name + ".csv");
        std::ofstream file(path, std::ios::binary);
        write(file, header(result));
        for (std::size_t tick = 0; tick < tickCount(result); ++tick) write(file, row(result, tick));
        file.close();
        if (!file) throw std::runtime_error("csv: cannot write " + path.string());
    }
}

void writeLabCsv(const std::vector<LabResult>& results, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    for (const LabResult& result : results) {
        const std::filesystem::path path = folder / (result.lab.name + ".csv");
        std::ofstream file(path, std::ios::binary);
        write(file, {"graph", "curve", "x", "y"});
        for (const Graph& graph : result.run.graphs)
            for (const Curve& curve : graph.curves)
                for (const Point& point : curve.points)
                    write(file, {quoted(graph.title), quoted(curve.name), cell(point.x), cell(point.y)});
        file.close();
        if (!file) throw std::runtime_error("csv: cannot write " + path.string());
    }
}

}  // namespace plumb::compare
