// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include <compare/engine/textbook/frame_loop.h>
#include <compare/lab/builtin/labs.h>
#include <compare/lab/builtin/parts.h>

namespace plumb::compare {
namespace {

constexpr double bulletStep = 1.0 / 60;                 // [s]
constexpr double bulletRadius = 0.025;                  // of the bullet [m]
constexpr double thickness = 0.05;                      // of the window [m]
constexpr double reach = thickness / 2 + bulletRadius;  // they overlap while the bullet's centre is this near [m]
constexpr double safeSpeed =
    2 * reach / bulletStep;   // at this speed, a step is as long as the stretch where they overlap [m/s]
constexpr double before = 1;  // from the first bullet's start to the window [m]
constexpr int starts = 100;   // spread over the distance of one frame

std::vector<double> bulletSpeeds() {
    return geometricSteps(1, 1000, 49);
}

/// Where bullet number i starts. All starts together are spread over the distance of one frame [m].
double startOf(int i, double speed) {
    return -before - speed * bulletStep * i / starts;
}

/// Each bullet has a window of its own; the windows are one above the other.
Scene shootingRange(double speed, BodyType window, int first = 0, int count = starts) {
    Scene scene{.name = "shooting_range",
                .question = "Which bullets go through their windows?",
                .gravity = {0, 0},
                .dt = bulletStep,
                .sleeping = false};
    for (int i = first; i < first + count; ++i) {
        const std::string number = std::to_string(i);
        scene.bodies.push_back(
            {"window_" + number, {.type = window, .position = {0, 2.0 * i}, .shapes = {box({thickness / 2, 0.5})}}});
        scene.bodies.push_back(
            {"bullet_" + number,
             {.position = {startOf(i, speed), 2.0 * i}, .velocity = {speed, 0}, .shapes = {circle(bulletRadius)}}});
    }
    return scene;
}

FrameTest seenBy(CollisionTest test) {
    return [test](const Scene& scene, int frames) {
        FrameLoop loop(scene, Integration::SemiImplicitEuler, test);
        for (int frame = 0; frame < frames; ++frame) {
            loop.advance(scene.dt);
            if (loop.firstImpact()) return true;
        }
        return false;
    };
}

/// Until the bullet is behind the window.
int framesFor(double start, double speed) {
    return static_cast<int>(std::ceil((reach - start) / (speed * bulletStep)));
}

double missedShare(const FrameTest& test, double speed) {
    int missed = 0;
    for (int i = 0; i < starts; ++i)
        missed += !test(shootingRange(speed, BodyType::Static, i, 1), framesFor(startOf(i, speed), speed));
    return 100.0 * missed / starts;
}

/// The starts are spread evenly over the distance of one frame. This is the share of starts for which no frame ends in
/// the window [%].
double expectedShare(double speed) {
    return 100 * std::max(0.0, 1 - safeSpeed / speed);
}

/// A bullet that is behind its window at the end went through it, even if the window has moved.
double missedShare(const Engine& engine, double speed, BodyType window) {
    const std::unique_ptr<Simulation> simulation = engine.build(shootingRange(speed, window));
    const double slowest = std::min(speed, 100.0);  // in some engines, nothing moves by more than 2 m a step
    const int steps = static_cast<int>((before + reach + speed * bulletStep) / (slowest * bulletStep)) + 10;
    for (int i = 0; i < steps; ++i) simulation->step(bulletStep);
    const std::vector<BodyState> states = simulation->states();
    int missed = 0;
    for (std::size_t i = 0; i < states.size(); i += 2) missed += states[i + 1].position.x() > states[i].position.x();
    return 100.0 * missed / starts;
}

Curve curveOf(const std::string& name, const std::function<double(double speed)>& share) {
    Curve curve{.name = name};
    double sum = 0;
    for (const double speed : bulletSpeeds()) {
        curve.points.push_back({speed, share(speed)});
        sum += curve.points.back().y;
    }
    const auto all = static_cast<double>(curve.points.size());
    curve.note = fmt::format("{:.0f} of {:.0f}", sum * starts / 100, all * starts);
    return curve;
}

/// How many bullets went through, at all speeds together.
double missedIn(const Curve& curve) {
    double sum = 0;
    for (const Point& point : curve.points) sum += point.y * starts / 100;
    return std::round(sum);
}

/// The lowest speed at which a bullet went through; 0 if none did.
double firstMiss(const Curve& curve) {
    for (const Point& point : curve.points)
        if (point.y > 0) return point.x;
    return 0;
}

Graph shareGraph(const std::string& title) {
    return {.title = title, .x = {"speed of the bullet", "m/s", true}, .y = {"share that goes through", "%"}};
}

void runTests(const FrameTests& tests, LabRun& run) {
    Graph graph = shareGraph("The lecture's tests, frame by frame");
    const auto curve = [&](const std::string& name, const FrameTest& test) {
        graph.curves.push_back(curveOf(name, [&](double speed) { return missedShare(test, speed); }));
        return graph.curves.back();
    };
    const Curve atEnds = curve("overlap at frame ends", tests.overlapAtEnd);
    const Curve bisected = curve("overlap, time by bisection", tests.bisection);
    const Curve swept = curve("swept test", tests.swept);
    Curve expected = curveOf("1 - (window + bullet) / (v dt)", expectedShare);
    expected.theory = true;
    expected.note = "";
    graph.curves.push_back(expected);
    run.graphs.push_back(graph);

    double off = 0, differing = 0, tooEarly = 0;
    for (std::size_t i = 0; i < atEnds.points.size(); ++i) {
        const auto [speed, share] = atEnds.points[i];
        off = std::max(off, std::fabs(share - expected.points[i].y));
        differing += std::fabs(share - bisected.points[i].y) * starts / 100;
        if (speed <= safeSpeed) tooEarly += share * starts / 100;
    }
    run.values["overlap.off_expected"] = off;
    run.values["overlap.missed_below_safe_speed"] = tooEarly;
    run.values["overlap.missed_fastest"] = atEnds.points.back().y;
    run.values["bisection.differs_from_overlap"] = std::round(differing);
    run.values["swept.missed"] = missedIn(swept);
    run.seen.push_back(
        fmt::format("Up to (window + bullet) / dt = {:.3g} m/s every bullet is seen at the end of some frame; at "
                    "{:.3g} m/s the first goes through, and at {:.4g} m/s {:.0f} % do. Bisection misses the same "
                    "ones: it looks for the time of an overlap that was seen. The swept test misses {:.0f} of {}.",
                    safeSpeed, firstMiss(atEnds), atEnds.points.back().x, atEnds.points.back().y, missedIn(swept),
                    starts * bulletSpeeds().size()));
}

/// Says which curves have no bullet that goes through, and how many go through in the others. labels: of the curves.
std::string sentence(const Graph& graph, const std::vector<std::string>& labels) {
    std::vector<std::string> none, some;
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Curve& curve = graph.curves[i];
        const double missed = missedIn(curve);
        const std::string& label = labels[i];
        if (missed == 0)
            none.push_back(label);
        else
            some.push_back(fmt::format("{:.0f} in {}, from {:.3g} m/s on", missed, label, firstMiss(curve)));
    }
    std::string text = fmt::format("{}, {} bullets:", graph.title, starts * bulletSpeeds().size());
    if (!none.empty()) text += fmt::format(" none goes through in {};", fmt::join(none, ", "));
    if (!some.empty()) text += fmt::format(" through go {};", fmt::join(some, "; "));
    text.back() = '.';
    return text;
}

void runEngines(const std::vector<Engine>& engines, BodyType window, LabRun& run) {
    const bool fixed = window == BodyType::Static;
    Graph graph = shareGraph(fixed ? "Engines, window fixed" : "Engines, window free to move");
    std::vector<std::string> labels;
    const auto add = [&](const Engine& engine) {
        labels.push_back(engine.label);
        graph.curves.push_back(curveOf(engine.name, [&](double speed) { return missedShare(engine, speed, window); }));
    };
    for (const Engine& engine : engines) {
        add(engine);
        run.values[engine.name + (fixed ? ".missed.fixed" : ".missed.loose")] = missedIn(graph.curves.back());
        if (engine.withBullets) add(engine.withBullets());
    }
    run.graphs.push_back(graph);
    run.seen.push_back(sentence(graph, labels));
}

LabRun runBulletAndWindow(const FrameTests& tests, const std::vector<Engine>& engines) {
    LabRun run;
    runTests(tests, run);
    if (engines.empty()) return run;
    runEngines(engines, BodyType::Static, run);
    runEngines(engines, BodyType::Dynamic, run);
    return run;
}

}  // namespace

FrameTests lectureTests() {
    return {seenBy(CollisionTest::AtEnd), seenBy(CollisionTest::Bisection), seenBy(CollisionTest::Swept)};
}

Lab bulletAndWindow(const FrameTests& tests) {
    return {
        .name = "bullet_and_window",
        .question = "From which speed on does a bullet go through a thin window without being seen?",
        .varied = "the bullet's speed, from 1 to 1,000 m/s, and where in a frame's way it starts",
        .checks = {{.name = "overlap.missed_below_safe_speed",
                    .reason = "a step is not longer than the stretch where the two overlap: a frame ends there"},
                   {.name = "overlap.off_expected",
                    .limit = 100.0 / starts,
                    .unit = "%",
                    .reason = "the share of starts whose frames all end outside is 1 - (window + bullet) / (v dt), "
                              "to one of the hundred starts"},
                   {.name = "overlap.missed_fastest",
                    .bound = Bound::AtLeast,
                    .limit = 98,
                    .unit = "%",
                    .reason =
                        "at 1,000 m/s a frame's way is 16.7 m, and the stretch 0.1 m: 99.4 % go through, to one of "
                        "the hundred starts"},
                   {.name = "bisection.differs_from_overlap",
                    .reason =
                        "bisection halves a frame only if an overlap was seen at its end: it sees no other overlap"},
                   {.name = "swept.missed", .reason = "the whole way of the frame is looked at"},
                   {.name = subjectName() + ".missed.fixed",
                    .reason = "nothing goes through a fixed body, at any speed",
                    .engine = subjectName()}},
        .run = [tests](const std::vector<Engine>& engines) { return runBulletAndWindow(tests, engines); }};
}

}  // namespace plumb::compare
