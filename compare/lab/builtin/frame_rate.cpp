// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <set>
#include <utility>

#include <compare/closed_form/oracle.h>
#include <compare/engine/plumb_world.h>
#include <compare/engine/textbook/frames.h>
#include <compare/formula/flights.h>
#include <compare/lab/builtin/labs.h>
#include <compare/lab/builtin/parts.h>
#include <compare/metric/length_text.h>
#include <compare/scene/builtin/parts.h>
#include <plumb/math/random.h>
#include <plumb/record/state_hash.h>

namespace plumb::compare {
namespace {

constexpr double duration = 3;       // [s]
constexpr int wantedTicks = 150;     // of 0.02 s: the lecture's interval
constexpr double ballRadius = 0.25;  // [m]
constexpr int shownRates[] = {24, 60, 144};
constexpr int allRates[] = {20, 24, 25, 30, 40, 50, 60, 72, 75, 90, 100, 120, 144, 165, 200, 240};

/// A display: how long each of its frames takes, three seconds in all.
struct Display {
    std::string name;
    double rate = 0;  ///< [1/s]; 0 if the frames are not equally long
    std::vector<double> frames{};
};

Display evenDisplay(int rate) {
    const int frames = static_cast<int>(duration) * rate;
    return {fmt::format("{} Hz", rate), static_cast<double>(rate),
            std::vector<double>(static_cast<std::size_t>(frames), 1.0 / rate)};
}

/// A random rate for each frame, from 15 to 144 frames a second.
Display irregularDisplay() {
    Display display{.name = "irregular"};
    Random random(24);
    for (double left = duration; left > 0; left -= display.frames.back())
        display.frames.push_back(std::min(left, random.uniform(1.0 / 144, 1.0 / 15)));
    return display;
}

std::vector<Display> shownDisplays() {
    std::vector<Display> displays;
    for (const int rate : shownRates) displays.push_back(evenDisplay(rate));
    displays.push_back(irregularDisplay());
    return displays;
}

Scene bouncingBall() {
    const DroppedBall ball{.rest = {0, ballRadius}, .height = 2, .restitution = 0.9, .until = duration};
    return {.name = "bouncing_ball",
            .question = "Where is a ball, dropped from 2 m with e = 0.9, after 3 s?",
            .duration = duration,
            .bodies = {floorBody(),
                       {"ball",
                        {.position = ball.rest + Vec2(0, ball.height),
                         .shapes = {circle(ballRadius, {.restitution = ball.restitution})}}}},
            .closedForm = ClosedForm{.formula = "flight n leaves at e^n sqrt(2 g h) and lasts 2 e^n sqrt(2 h / g)",
                                     .source = "textbook: Newton's law of impact",
                                     .bodies = {PiecewiseMotion{"ball", bouncingFlights(ball)}}}};
}

/// What is needed to make a point bounce like the scene's ball.
struct Body {
    Vec2 start{0, 0};        ///< [m]
    double floor = 0;        ///< height of its centre when it lies on the floor [m]
    double restitution = 0;  ///< [-]
};

Body ballOf(const Scene& scene) {
    const BodyDef& ball = scene.bodies.back().def;
    return {ball.position, ballRadius, ball.shapes.front().material.restitution};
}

double trueEnd(const Scene& scene) {
    return closedFormStates(scene, duration).back().position.y();
}

struct Shown {
    std::vector<Point> heights;  ///< at each frame [s, m]
    double end = 0;              ///< height in the last state, not the drawn one [m]
    std::int64_t ticks = 0;
    std::uint64_t hash = 0;
};

/// What is shown at each frame of the display.
std::vector<Point> heightsIn(FramedLoop& loop, const Display& display) {
    std::vector<Point> heights{{0, loop.shown().back().position.y()}};
    for (const double frame : display.frames) {
        loop.frame(frame);
        heights.push_back({heights.back().x + frame, loop.shown().back().position.y()});
    }
    return heights;
}

/// The game's loop: the clock says how many ticks are due. The drawn height lies between the last two ticks.
Shown byFixedClock(const Scene& scene, const Display& display, const ClockSettings& settings) {
    PlumbWorld made = plumbWorld(scene);
    const auto ball = [&] { return made.world.body(made.bodies.back()); };
    const auto states = [&] { return std::vector<BodyState>{{.position = ball().position()}}; };
    FramedLoop loop({[&](double dt) { made.world.step(dt); }, states}, settings);
    Shown shown{.heights = heightsIn(loop, display)};
    shown.end = ball().position().y();
    shown.ticks = loop.ticks();
    shown.hash = stateHash(made.world);
    return shown;
}

/// The lecture warns of this: each step is as long as its frame.
Shown byVariableStep(const Scene& scene, const Display& display, const Engine& engine) {
    const std::unique_ptr<Simulation> simulation = engine.build(scene);
    FramedLoop loop({[&](double dt) { simulation->step(dt); }, [&] { return simulation->states(); }});
    Shown shown{.heights = heightsIn(loop, display)};
    shown.end = shown.heights.back().y;
    return shown;
}

/// The ball of a beginner's game without an engine: one step of the method, then a bounce by Newton's law.
Shown byTextbook(const Scene& scene, const Display& display, const Method& method) {
    const Body body = ballOf(scene);
    MotionProblem fall;
    fall.acceleration = [&scene](const Vec2&) { return scene.gravity; };
    Motion ball{body.start, {0, 0}};
    Shown shown{.heights = {{0, ball.position.y()}}};
    double time = 0;
    for (const double frame : display.frames) {
        ball = method.step(fall, ball, frame);
        const double below = body.floor - ball.position.y();
        if (below > 0 && ball.velocity.y() < 0) {
            ball.position.y() = body.floor + below;
            ball.velocity.y() *= -body.restitution;
        }
        time += frame;
        shown.heights.push_back({time, ball.position.y()});
    }
    shown.end = ball.position.y();
    return shown;
}

/// The final heights over the frame rates, and how far they are apart. The irregular display has no rate.
struct Ends {
    std::vector<Point> overRate;
    std::set<double> heights;
    double spread() const { return *heights.rbegin() - *heights.begin(); }
    void add(const Display& display, const Shown& shown) {
        if (display.rate > 0) overRate.push_back({display.rate, shown.end});
        heights.insert(shown.end);
    }
};

std::vector<Display> allDisplays() {
    std::vector<Display> displays;
    for (const int rate : allRates) displays.push_back(evenDisplay(rate));
    displays.push_back(irregularDisplay());
    return displays;
}

Graph heightGraph(const std::string& title) {
    return {.title = title, .x = {"time", "s"}, .y = {"height of the centre", "m"}};
}

void runClock(const Scene& scene, const ClockSettings& clock, LabRun& run, Graph& endGraph) {
    Graph graph = heightGraph("Fixed clock: what is shown, one tick behind");
    for (const Display& display : shownDisplays())
        graph.curves.push_back({display.name, byFixedClock(scene, display, clock).heights});
    run.graphs.push_back(graph);

    const std::vector<Display> displays = allDisplays();
    const std::uint64_t hash = byFixedClock(scene, displays.front(), clock).hash;
    Ends ends;
    int others = 0;
    std::int64_t ticksOff = 0;
    for (const Display& display : displays) {
        const Shown shown = byFixedClock(scene, display, clock);
        ends.add(display, shown);
        others += shown.hash != hash;
        ticksOff = std::max<std::int64_t>(ticksOff, std::abs(shown.ticks - wantedTicks));
    }
    endGraph.curves.push_back({"fixed clock", ends.overRate});
    const double error = std::fabs(*ends.heights.begin() - trueEnd(scene));
    run.values = {{"clock.states_that_differ", others},
                  {"clock.ticks_off", static_cast<double>(ticksOff)},
                  {"clock.spread", ends.spread()},
                  {"clock.error", error}};
    run.seen.push_back(fmt::format(
        "With the fixed clock, {} of {} displays, the irregular one among them, end with the same state hash after {} "
        "ticks: the ball is at {:.6f} m, {} from the closed form.",
        static_cast<int>(displays.size()) - others, displays.size(), wantedTicks, *ends.heights.begin(),
        lengthText(error)));
}

/// An engine or method whose steps are as long as the frames.
struct Stepper {
    std::string label;  ///< for people to read
    std::string curve;  ///< its name in the graph of the final heights
    std::string value;  ///< the name of its spread's value
    std::function<Shown(const Display&)> shown;
};

Stepper engineStepper(const Scene& scene, const Engine& engine) {
    return {engine.label, engine.name, "variable.spread." + engine.name,
            [&](const Display& display) { return byVariableStep(scene, display, engine); }};
}

Stepper textbookStepper(const Scene& scene, const Method& method) {
    return {"the textbook", "textbook (" + method.name + ")", "textbook.spread",
            [&](const Display& display) { return byTextbook(scene, display, method); }};
}

void runStepper(const Stepper& stepper, LabRun& run, Graph& endGraph) {
    Graph graph = heightGraph(fmt::format("{}, a step as long as the frame", stepper.label));
    graph.title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(graph.title.front())));
    for (const Display& display : shownDisplays())
        graph.curves.push_back({display.name, stepper.shown(display).heights});
    run.graphs.push_back(graph);

    Ends ends;
    for (const Display& display : allDisplays()) ends.add(display, stepper.shown(display));
    endGraph.curves.push_back({stepper.curve, ends.overRate});
    run.values[stepper.value] = ends.spread();
    run.seen.push_back(fmt::format(
        "With a step as long as the frame, {}'s ball ends between {:.4f} m and {:.4f} m: {} apart, in {} different "
        "places on {} displays.",
        stepper.label, *ends.heights.begin(), *ends.heights.rbegin(), lengthText(ends.spread()), ends.heights.size(),
        std::size(allRates) + 1));
}

LabRun runFrameRate(const ClockSettings& clock, const Method& textbook, const std::vector<Engine>& engines) {
    const Scene scene = bouncingBall();
    LabRun run;
    Graph endGraph{.title = "Where the ball is after 3 s",
                   .x = {"frames a second", "1/s", true},
                   .y = {"height of the centre", "m"}};
    runClock(scene, clock, run, endGraph);
    runStepper(textbookStepper(scene, textbook), run, endGraph);
    for (const Engine& engine : engines) runStepper(engineStepper(scene, engine), run, endGraph);
    const double end = trueEnd(scene);
    endGraph.curves.push_back({.name = "closed form",
                               .points = {{allRates[0], end}, {allRates[std::size(allRates) - 1], end}},
                               .theory = true});
    run.graphs.push_back(endGraph);
    return run;
}

}  // namespace

Method textbookMethod() {
    const std::vector<Method> methods = knownMethods();
    return *std::ranges::find(methods, "semi_implicit_euler", &Method::tag);
}

Lab frameRate(const ClockSettings& clock, const Method& textbook) {
    return {
        .name = "frame_rate",
        .question = "A ball bounces for 3 s: does it end in the same place, whatever the display's frame rate?",
        .varied = "frames a second, from 20 to 240 and irregular, between 15 and 144",
        .checks = {{.name = "clock.states_that_differ",
                    .reason = "the world makes the same ticks at any frame rate: so the bits are the same"},
                   {.name = "clock.ticks_off", .reason = "3 s are 150 ticks of 0.02 s, in whole ticks"},
                   {.name = "clock.spread", .unit = "m", .reason = "the same bits mean the same place"},
                   {.name = "clock.error",
                    .limit = 1e-7,
                    .unit = "m",
                    .reason = "flights are their closed form, and each of three impacts is solved at its own time, to "
                              "1e-9 s at 6 m/s: 2e-8 m"},
                   {.name = "textbook.spread",
                    .bound = Bound::AtLeast,
                    .limit = 0.6,
                    .unit = "m",
                    .reason = "v += a h; x += v h flies through x + v n h - g h^2 n (n + 1) / 2: from landing to "
                              "landing, this comes to 0.5355 m at 20 frames a second and to 1.1551 m at 24"},
                   {.name = "variable.spread." + subjectName(),
                    .limit = 1e-7,
                    .unit = "m",
                    .reason = "as clock.error: neither depends on the step; only the last bits do",
                    .engine = subjectName()}},
        .run = [clock, textbook](const std::vector<Engine>& engines) { return runFrameRate(clock, textbook, engines); },
    };
}

}  // namespace plumb::compare
