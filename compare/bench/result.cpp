// SPDX-License-Identifier: MIT
#include <compare/bench/result.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace plumb::compare {
namespace {

const EngineBench* find(const SceneBench& scene, std::string_view engine) {
    for (const EngineBench& bench : scene.engines)
        if (bench.engine == engine && bench.supported()) return &bench;
    return nullptr;
}

/// Names of engines or families in the order in which they are added, each one once.
class Names {
public:
    void add(const std::string& name) {
        if (std::ranges::find(list, name) == list.end()) list.push_back(name);
    }
    std::vector<std::string> list;
};

/// [ms]
std::vector<double> leastSteps(const EngineBench& bench) {
    std::vector<double> least = bench.runs.front().stepMs;
    for (const BenchRun& run : bench.runs)
        for (std::size_t i = 0; i < least.size(); ++i) least[i] = std::min(least[i], run.stepMs[i]);
    return least;
}

struct Point {
    double x, y;
};

/// The slope of the least-squares line. It needs at least two points with different x.
double slopeOf(const std::vector<Point>& points) {
    const auto count = static_cast<double>(points.size());
    Point mean{0, 0};
    for (const Point& point : points) mean = {mean.x + point.x / count, mean.y + point.y / count};
    double over = 0, under = 0;
    for (const Point& point : points) {
        over += (point.x - mean.x) * (point.y - mean.y);
        under += (point.x - mean.x) * (point.x - mean.x);
    }
    return over / under;
}

std::optional<Growth> growthOf(std::span<const SceneBench> results, const std::string& family,
                               const std::string& engine) {
    std::vector<Point> points;
    Growth growth{family, engine, 0, 0, 0};
    for (const SceneBench& scene : results) {
        const EngineBench* bench = scene.family == family ? find(scene, engine) : nullptr;
        if (!bench) continue;
        points.push_back({std::log(static_cast<double>(scene.bodies)), std::log(bench->leastMs())});
        growth.from = points.size() == 1 ? scene.bodies : std::min(growth.from, scene.bodies);
        growth.to = std::max(growth.to, scene.bodies);
    }
    if (growth.from == growth.to) return {};
    growth.exponent = slopeOf(points);
    return growth;
}

}  // namespace

Spread spreadOf(std::vector<double> values) {
    std::ranges::sort(values);
    const std::size_t middle = values.size() / 2;
    const double median = values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
    return {values.front(), median, values.back()};
}

StepTimes stepTimesOf(std::vector<double> milliseconds) {
    std::ranges::sort(milliseconds);
    const auto rank = [&](std::size_t percent) { return (milliseconds.size() * percent + 99) / 100 - 1; };
    return {milliseconds[rank(50)], milliseconds[rank(99)], milliseconds.back()};
}

StepTimes EngineBench::stepMs() const {
    return stepTimesOf(leastSteps(*this));
}

double EngineBench::leastMs() const {
    const std::vector<double> least = leastSteps(*this);
    return std::accumulate(least.begin(), least.end(), 0.0) / static_cast<double>(least.size());
}

Integrity EngineBench::integrity() const {
    for (const BenchRun& run : runs)
        if (run.integrity) return *run.integrity;
    return {};
}

Spread EngineBench::msPerStep() const {
    std::vector<double> values;
    for (const BenchRun& run : runs) values.push_back(run.msPerStep);
    return spreadOf(std::move(values));
}

long EngineBench::peakKb() const {
    return std::ranges::min(runs, {}, &BenchRun::peakKb).peakKb;
}

double EngineBench::busy() const {
    return std::ranges::min(runs, {}, &BenchRun::busy).busy;
}

std::vector<Phase> EngineBench::phases() const {
    std::vector<Phase> means = runs.front().phases;
    for (std::size_t i = 0; i < means.size(); ++i) {
        double sum = 0;
        for (const BenchRun& run : runs) sum += run.phases[i].seconds;
        means[i].seconds = sum / static_cast<double>(runs.size());
    }
    return means;
}

std::vector<Ratio> ratiosOf(std::span<const SceneBench> results) {
    std::vector<Ratio> ratios;
    for (const SceneBench& scene : results) {
        const EngineBench* plumb = find(scene, subjectName());
        if (!plumb) continue;
        for (const EngineBench& other : scene.engines) {
            if (&other == plumb || !other.supported()) continue;
            std::vector<double> pairwise;
            for (std::size_t i = 0; i < std::min(plumb->runs.size(), other.runs.size()); ++i)
                pairwise.push_back(other.runs[i].msPerStep / plumb->runs[i].msPerStep);
            ratios.push_back({scene.scene, other.engine, spreadOf(std::move(pairwise)),
                              other.leastMs() / plumb->leastMs(),
                              isBroken(plumb->integrity()) || isBroken(other.integrity())});
        }
    }
    return ratios;
}

std::vector<MeanRatio> meanRatiosOf(std::span<const SceneBench> results) {
    std::vector<MeanRatio> means;
    for (const char* group : {"six", "random"}) {
        std::vector<SceneBench> members;
        std::ranges::copy_if(results, std::back_inserter(members),
                             [&](const SceneBench& s) { return s.group == group; });
        const std::vector<Ratio> ratios = ratiosOf(members);
        Names rivals;
        for (const Ratio& ratio : ratios) rivals.add(ratio.against);
        for (const std::string& against : rivals.list) {
            double logs = 0;
            MeanRatio mean{.group = group, .against = against};
            for (const Ratio& ratio : ratios) {
                if (ratio.against != against) continue;
                if (ratio.broken) {
                    mean.leftOut.push_back(ratio.scene);
                    continue;
                }
                logs += std::log(ratio.least);
                ++mean.scenes;
            }
            mean.ratio = std::exp(logs / static_cast<double>(mean.scenes));
            means.push_back(std::move(mean));
        }
    }
    return means;
}

std::vector<Growth> growthsOf(std::span<const SceneBench> results) {
    Names families, engines;
    for (const SceneBench& scene : results) {
        if (!scene.family.empty()) families.add(scene.family);
        for (const EngineBench& bench : scene.engines) engines.add(bench.engine);
    }
    std::vector<Growth> growths;
    for (const std::string& family : families.list)
        for (const std::string& engine : engines.list)
            if (const std::optional<Growth> growth = growthOf(results, family, engine)) growths.push_back(*growth);
    return growths;
}

}  // namespace plumb::compare
