// SPDX-License-Identifier: MIT
// What does JavaScript call? Functions that take and return numbers; a text crosses as a range of bytes.
#include <fmt/format.h>

#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <compare/check/answer.h>
#include <compare/lesson/lesson.h>
#include <compare/metric/bounds.h>
#include <compare/scene/bench.h>
#include <compare/scene/builtin.h>
#include <compare/scene/json.h>
#include <compare/scene/named.h>
#include <compare/scene/schema/schema.h>
#include <compare/view/engine_cards.h>
#include <compare/view/result_view.h>
#include <compare/view/scene_view.h>
#include <compare/view/verdict_json.h>
#include <compare/web/live.h>
#include <web/runtime/export.h>

namespace plumb::compare {
namespace {

using nlohmann::json;

std::string given;            // what JavaScript wrote
std::string text;             // what it reads, or why a call was refused
std::vector<double> numbers;  // what it reads
std::unique_ptr<Live> live;
std::optional<SceneResult> result;

/// The number that act gives; -1 after an error, whose text then stands in text.
template <class Act>
double tried(Act act) {
    try {
        if constexpr (std::is_void_v<decltype(act())>) {
            act();
            return 0;
        } else {
            return static_cast<double>(act());
        }
    } catch (const std::bad_alloc&) {
        text = "there is not enough memory";
    } catch (const std::exception& fault) {
        text = fault.what();
    }
    return -1;
}

void say(const json& data) {
    text = data.dump(-1, ' ', false, json::error_handler_t::replace);
}

Live& open() {
    if (!live) throw std::logic_error("no scene is open");
    return *live;
}

Scene sceneNamed(const std::string& name) {
    if (std::optional<Scene> scene = findScene(name)) return *std::move(scene);
    const std::vector<BenchScene> found = findBenchScenes(name);
    if (found.size() == 1) return found.front().build();
    const std::vector<std::string> known = namesOf(builtinScenes());
    throw std::invalid_argument("there is no scene " + quoted(name) + ": the nearest is " + nearest(name, known));
}

/// What a page has to know of the open scene before it runs.
void sayScene() {
    const Scene& scene = open().scene();
    json data = sceneView(scene);
    data.update(
        {{"dt", scene.dt}, {"duration", scene.duration}, {"steps", stepCount(scene)}, {"changed", live->changed()}});
    say(data);
}

void openScene(Scene scene) {
    auto opened = std::make_unique<Live>(std::move(scene));
    live = std::move(opened);
    result.reset();
    sayScene();
}

json runData(const Observation& run) {
    json data{{"name", run.engine}, {"version", run.version}};
    if (!run.unsupported.empty())
        data["unsupported"] = run.unsupported;
    else
        data["bodies"] = movingBodies(live->scene(), run.role);
    return data;
}

enum class Rows { Poses, Velocities };

/// x, y, angle of each body of the run that moves, tick by tick; or the velocities.
void addRows(const Observation& run, Rows rows, std::size_t from, std::size_t until) {
    numbers.clear();
    const std::vector<std::size_t> bodies = movingBodies(live->scene(), run.role);
    for (std::size_t tick = from; tick < until && tick < run.states.size(); ++tick)
        for (const std::size_t body : bodies) {
            const BodyState& state = run.states[tick][body];
            const Vec2& v = rows == Rows::Poses ? state.position : state.velocity;
            numbers.insert(numbers.end(), {v.x(), v.y(), rows == Rows::Poses ? state.angle : state.angularVelocity});
        }
}

std::vector<double> seriesOf(const EngineResult& run, std::string_view name) {
    const Series& series = run.measured.series;
    if (name == "error") return series.error;
    if (name == "divergence") return series.divergence;
    if (name == "energy") return series.energy;
    for (std::size_t i = 0; i < energyCauses.size(); ++i) {
        if (name != energyCauses[i]) continue;
        std::vector<double> values;
        for (const std::vector<double>& row : run.observation.energyByCause) values.push_back(row[i]);
        return values;
    }
    for (std::size_t i = 0; i < energyKinds.size(); ++i)
        if (name == energyKinds[i]) return series.energies[i];
    throw std::invalid_argument("there is no series \"" + std::string(name) + "\"");
}

/// Of runs that go on, or that were measured.
const Observation& observationOf(std::size_t run) {
    return result ? result->engines.at(run).observation : open().seen(run);
}

json pairOf(const Vec2& v) {
    return {v.x(), v.y()};
}

json boundsData(const Scene& scene, const std::vector<BodyState>& states) {
    json data = json::array();
    for (const ShapeBounds& bounds : boundsOf(scene, states)) {
        json corners = json::array();
        for (const Vec2& corner : cornersOf(bounds.oriented)) corners.push_back(pairOf(corner));
        data.push_back({{"body", bounds.body},
                        {"circle", {bounds.circle.center.x(), bounds.circle.center.y(), bounds.circle.radius}},
                        {"upright", {pairOf(bounds.upright.lower), pairOf(bounds.upright.upper)}},
                        {"oriented", corners}});
    }
    return data;
}

json pairsData(const Scene& scene, const std::vector<BodyState>& states) {
    json data = json::array();
    for (const BoundsPair& pair : boundsPairs(scene, states)) {
        data.push_back({{"a", pair.a},
                        {"b", pair.b},
                        {"circles", pair.circles},
                        {"upright", pair.upright},
                        {"oriented", pair.oriented}});
        if (pair.shapes)
            data.back()["shapes"] = {{"depth", pair.shapes->depth},
                                     {"normal", pairOf(pair.shapes->normal)},
                                     {"at", pairOf(pair.shapes->pointA)}};
    }
    return data;
}

json testsData(const Scene& scene, const std::vector<BodyState>& states) {
    constexpr const char* names[] = {"brute force", "grid", "sweep and prune", "hierarchy"};  // as in broadPhases
    json data = json::array();
    for (const PairTests& each : pairTests(scene, states))
        data.push_back(
            {{"way", names[static_cast<std::size_t>(each.way)]}, {"tests", each.tests}, {"pairs", each.pairs}});
    return data;
}

const EngineResult& resultAt(std::size_t run) {
    if (!result) throw std::logic_error("nothing was measured");
    return result->engines.at(run);
}

}  // namespace

/// Room for a text of so many bytes.
PLUMB_EXPORT(room) char* room(std::uint32_t bytes) {
    return tried([bytes] { given.resize(bytes); }) < 0 ? nullptr : given.data();
}
PLUMB_EXPORT(textAt) const char* textAt() {
    return text.data();
}
PLUMB_EXPORT(textLength) std::uint32_t textLength() {
    return static_cast<std::uint32_t>(text.size());
}
PLUMB_EXPORT(numbersAt) const double* numbersAt() {
    return numbers.data();
}

/// Says engines and scenes: {"engines", "scenes": [{"name", "title", "group", "question", "bench"}]}.
PLUMB_EXPORT(list) double list() {
    return tried([] {
        json data{{"engines", engineCards()}, {"onDemand", cardsOnDemand()}, {"scenes", json::array()}};
        for (const Scene& scene : builtinScenes())
            data["scenes"].push_back({{"name", scene.name},
                                      {"title", titleOf(scene)},
                                      {"group", scene.group},
                                      {"question", scene.question},
                                      {"bench", false}});
        for (const BenchScene& scene : benchScenes())
            data["scenes"].push_back(
                {{"name", scene.name}, {"title", scene.name}, {"group", ""}, {"question", ""}, {"bench", true}});
        say(data);
    });
}

/// Opens the built-in scene of the given name, and says what is drawn of it.
PLUMB_EXPORT(open) double openNamed() {
    return tried([] { openScene(sceneNamed(given)); });
}
/// Opens the scene that the given JSON describes.
PLUMB_EXPORT(read) double readGiven() {
    return tried([] { openScene(fromJson(given, "scene")); });
}
/// Sets a field of the open scene: "dt=1/120".
PLUMB_EXPORT(set) double setField() {
    return tried([] {
        open().set(fieldSettingOf(given));
        sayScene();
    });
}
PLUMB_EXPORT(reset) double resetScene() {
    return tried([] {
        open().reset();
        sayScene();
    });
}
/// Says the open scene as JSON with all its fields, or as it is kept in a file.
PLUMB_EXPORT(exported) double exported(std::uint32_t everything) {
    return tried(
        [=] { text = everything != 0 ? toJson(open().scene(), Defaults::Written) : toJson(open().sceneToKeep()); });
}

/// Opens the scene of the lesson that the given JSON describes; says {"lesson", "scene"}.
PLUMB_EXPORT(lesson) double openLesson() {
    return tried([] {
        const Lesson lesson = lessonFromJson(given, "lesson");
        openScene(lesson.scene);
        say({{"lesson", json::parse(toJson(lesson))}, {"scene", json::parse(text)}});
    });
}
/// What a query reads of a run; not a number if there is nothing to read. A metric is there after measure. Says its
/// unit.
PLUMB_EXPORT(valueOf) double valueIn(std::uint32_t run) {
    double value = std::numeric_limits<double>::quiet_NaN();
    const double fault = tried([&] {
        const Scene& scene = open().scene();
        const AnswerQuery query = answerQuery(scene, given);
        if (query.kind == AnswerQuery::Kind::Metric) {
            const auto& metrics = resultAt(run).measured.metrics;
            if (const auto found = metrics.find(query.name); found != metrics.end())
                value = found->second.value_or(value);
        } else if (const Observation& seen = observationOf(run); !seen.states.empty()) {
            value = valueOf(scene, seen, query).value_or(value);
        }
        text = unitOf(scene, query);
    });
    numbers = {value};
    return fault;
}
/// Says what bounding volumes make of a run's bodies at a tick: {"bounds", "pairs"}.
PLUMB_EXPORT(boundsOf) double boundsAt(std::uint32_t run, std::uint32_t tick) {
    return tried([=] {
        const Scene& scene = open().scene();
        const std::vector<BodyState>& states = observationOf(run).states.at(tick);
        say({{"bounds", boundsData(scene, states)}, {"pairs", pairsData(scene, states)}});
    });
}
/// Says how many tests of pairs each broad phase makes at a tick: [{"way", "tests", "pairs"}].
PLUMB_EXPORT(testsOf) double testsAt(std::uint32_t run, std::uint32_t tick) {
    return tried([=] { say(testsData(open().scene(), observationOf(run).states.at(tick))); });
}
/// A track as CSV: shown beside the engines from the next start on.
PLUMB_EXPORT(bring) double bringTrack() {
    return tried([] { open().bring(given, "file"); });
}

/// Says the JSON Schema of scenes.
PLUMB_EXPORT(schema) double schemaOfScenes() {
    return tried([] { text = sceneSchema(); });
}

/// Begins to run the open scene in the engines that are given, with commas between; in all if none is given. Says
/// [{"name", "version", "bodies" or "unsupported"}].
PLUMB_EXPORT(start) double startRuns() {
    return tried([] {
        std::vector<std::string> names;
        for (std::size_t from = 0; from < given.size();) {
            const std::size_t comma = std::min(given.find(',', from), given.size());
            names.push_back(given.substr(from, comma - from));
            from = comma + 1;
        }
        result.reset();
        open().start(std::move(names));
        json data = json::array();
        for (std::size_t run = 0; run < live->runCount(); ++run) data.push_back(runData(live->seen(run)));
        say(data);
    });
}
/// Goes on to a tick or until the time is used up [ms]; gives the tick that was reached.
PLUMB_EXPORT(advance) double advance(double tick, double milliseconds) {
    return tried([=] {
        open().advance(static_cast<std::size_t>(tick), milliseconds);
        return live->tick();
    });
}
/// rows: 0 for x, y [m] and angle [rad], 1 for their velocities. Gives how many numbers there are.
PLUMB_EXPORT(rowsOf) double rowsOf(std::uint32_t run, std::uint32_t rows, std::uint32_t from, std::uint32_t until) {
    return tried([=] {
        addRows(open().seen(run), static_cast<Rows>(rows), from, until);
        return numbers.size();
    });
}
/// The scene's probes, tick by tick.
PLUMB_EXPORT(probesOf) double probesOf(std::uint32_t run, std::uint32_t from, std::uint32_t until) {
    return tried([=] {
        numbers.clear();
        const Observation& seen = open().seen(run);
        for (std::size_t tick = from; tick < until && tick < seen.probes.size(); ++tick)
            numbers.insert(numbers.end(), seen.probes[tick].begin(), seen.probes[tick].end());
        return numbers.size();
    });
}
/// Seven numbers for each force: cause (0 normal, 1 friction, 2 joint), body, other, x, y [m], force x, y [N].
PLUMB_EXPORT(pushesOf) double pushesOf(std::uint32_t run, std::uint32_t tick) {
    return tried([=] {
        numbers.clear();
        for (const Push& push : open().pushes(run, tick))
            numbers.insert(numbers.end(),
                           {static_cast<double>(push.cause), static_cast<double>(push.body),
                            static_cast<double>(push.other), push.at.x(), push.at.y(), push.force.x(), push.force.y()});
        return numbers.size();
    });
}
/// A hand pulls the grip of a body, in its frame, to a target, from this tick on. Gives the tick that is reached.
PLUMB_EXPORT(hold) double hold(std::uint32_t tick, std::uint32_t body, double gripX, double gripY, double x, double y) {
    return tried([=] {
        open().hold(tick, Hand{body, {gripX, gripY}, {x, y}});
        return live->tick();
    });
}
PLUMB_EXPORT(drop) double drop(std::uint32_t tick) {
    return tried([=] {
        open().hold(tick, {});
        return live->tick();
    });
}

/// Measures the runs, which are then over for this scene, and says what a page shows of them.
PLUMB_EXPORT(measure) double measureRuns(std::uint32_t inDetail) {
    return tried([=] {
        open().advance(live->lastTick(), std::numeric_limits<double>::infinity());
        result = live->resultOfRuns(inDetail != 0);
        say(resultView(*result));
    });
}
/// After measure: a value a tick of "error", "divergence", "energy" or a kind of energy.
PLUMB_EXPORT(series) double series(std::uint32_t run) {
    return tried([=] {
        numbers = seriesOf(resultAt(run), given);
        return numbers.size();
    });
}
/// After measure: what check --json writes.
PLUMB_EXPORT(verdict) double verdict() {
    return tried([] {
        if (!result) throw std::logic_error("nothing was measured");
        text = verdictJson({&*result, 1});
    });
}

}  // namespace plumb::compare
