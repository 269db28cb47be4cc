// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <utility>

#include <compare/report/report.h>

namespace plumb::compare {
namespace {

/// In quotes if it would otherwise be read wrongly (RFC 4180).
std::string quoted(const std::string& name) {
    if (name.find_first_of(",\"\r\n") == std::string::npos) return name;
    std::string text(1, '"');
    for (const char c : name) text.append(c == '"' ? 2 : 1, c);
    text += '"';
    return text;
}

/// The fewest digits that read back as the same number; empty if there is no number.
std::string cell(double value) {
    return std::isnan(value) ? "" : fmt::format("{}", value);
}

void write(std::ostream& file, const std::vector<std::string>& cells) {
    for (std::size_t i = 0; i < cells.size(); ++i) file << (i > 0 ? "," : "") << cells[i];
    file << '\n';
}

/// One engine's run as a table.
class RunTable {
public:
    RunTable(const SceneResult& result, const EngineResult& run)
        : scene_(result.scene), run_(run.observation), measured_(run.measured) {
        for (const EngineResult& other : result.engines)
            if (other.observation.role == Role::Truth && other.observation.states.size() == run_.states.size())
                truth_ = &other.observation;
        for (std::size_t body = 0; body < scene_.bodies.size(); ++body)
            if (scene_.bodies[body].def.type != BodyType::Static) moving_.push_back(body);
    }

    std::vector<std::string> header() const {
        std::vector<std::string> cells{"t [s]"};
        const auto add = [&](const std::string& name, const char* unit) {
            cells.push_back(quoted(fmt::format("{} [{}]", name, unit)));
        };
        for (const std::size_t body : moving_) {
            const std::string& name = scene_.bodies[body].name;
            for (const auto& [what, unit] : ofBody) add(name + "." + what, unit);
            if (truth_) add(name + ".to_truth", "m");
        }
        for (const char* kind : energyKinds) add(std::string("energy.") + kind, "J");
        for (const Probe& probe : scene_.probes) add("probe." + probe.name, probe.unit.c_str());
        if (!run_.jointForces.empty() && !run_.jointForces.front().empty())
            for (const SceneJoint& joint : scene_.joints) add(joint.name + ".force", "N");
        if (truth_) add("to_truth", "m");
        return cells;
    }

    std::vector<std::string> row(std::size_t tick) const {
        std::vector<std::string> cells{cell(static_cast<double>(tick) * run_.dt)};
        const auto add = [&](double value) { cells.push_back(cell(value)); };
        for (const std::size_t body : moving_) {
            const BodyState& state = run_.states[tick][body];
            for (const double value : {state.position.x(), state.position.y(), state.angle, state.velocity.x(),
                                       state.velocity.y(), state.angularVelocity})
                add(value);
            if (truth_) add((state.position - truth_->states[tick][body].position).norm());
        }
        for (const std::vector<double>& energy : measured_.series.energies) add(valueAt(energy, tick));
        for (const double value : run_.probes[tick]) add(value);
        for (const double value : run_.jointForces[tick]) add(value);
        if (truth_) add(valueAt(measured_.series.error, tick));
        return cells;
    }

private:
    static constexpr std::pair<const char*, const char*> ofBody[] = {{"x", "m"},    {"y", "m"},    {"angle", "rad"},
                                                                     {"vx", "m/s"}, {"vy", "m/s"}, {"spin", "rad/s"}};

    /// Nothing where the series does not exist.
    static double valueAt(const std::vector<double>& series, std::size_t tick) {
        return tick < series.size() ? series[tick] : std::nan("");
    }

    const Scene& scene_;
    const Observation& run_;
    const Measured& measured_;
    const Observation* truth_ = nullptr;
    std::vector<std::size_t> moving_;
};

void writeRun(const SceneResult& result, const EngineResult& run, const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / fmt::format("{}.{}.csv", result.scene.name, run.observation.engine);
    std::ofstream file(path, std::ios::binary);
    const RunTable table(result, run);
    write(file, table.header());
    for (std::size_t tick = 0; tick < run.observation.states.size(); ++tick) write(file, table.row(tick));
    file.close();
    if (!file) throw std::runtime_error("csv: cannot write " + path.string());
}

}  // namespace

void writeCsv(const std::vector<SceneResult>& results, const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    for (const SceneResult& result : results)
        for (const EngineResult& run : result.engines)
            if (!run.observation.states.empty()) writeRun(result, run, folder);
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
