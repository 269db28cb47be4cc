// SPDX-License-Identifier: MIT
#include <compare/check/verdict.h>

#include <cmath>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

constexpr double rounding = 1e-12;

/// The disc at rest in weightlessness, with the given checks.
Scene resting(std::vector<Check> checks) {
    Scene scene = oneDisc();
    scene.gravity = {0, 0};
    scene.bodies[0].def.velocity = {0, 0};
    scene.checks = std::move(checks);
    return scene;
}

ExactCheck exact(double limit) {
    return {limit, "so it was derived"};
}

/// Plumb and the Box2Ds stand so far off the closed form, which stands at the origin.
std::vector<Engine> standingAt(double plumb, double box2d24, double box2d3) {
    return {standing("plumb", plumb), standing("box2d-2.4", box2d24), standing("box2d-3", box2d3),
            standing("closed-form", 0)};
}

SceneResult run(const Scene& scene, const std::vector<Engine>& engines, const std::vector<std::string>& asked = {}) {
    return runScene(scene, {asked, {}, {}}, engines);
}

/// An engine whose error is factor dt^order.
Engine converging(const std::string& name, double factor, double order) {
    return namedEngine(name, [=](const Scene& scene) {
        const double error = factor * std::pow(scene.dt, order);
        const Script script{[error](double t) { return std::vector<BodyState>{at(t > 0 ? error : 0, 0)}; }};
        return std::make_unique<ScriptedSimulation>(script, scene.probes.size());
    });
}

std::vector<Engine> withTruth(Engine engine) {
    return {std::move(engine), standing("closed-form", 0)};
}

}  // namespace

TEST_CASE("exact holds 2 mm off a limit of 2.5 mm, and fails off one of 1.5 mm", "[compare][check]") {
    const std::vector<Engine> engines = withTruth(standing("plumb", 2e-3));
    const SceneResult held = run(resting({exact(2.5e-3)}), engines);
    REQUIRE(held.outcomes.size() == 1);
    CHECK(held.outcomes[0].check == "exact");
    CHECK(held.outcomes[0].engine == "plumb");
    CHECK(held.outcomes[0].metric == "error_max");
    CHECK_THAT(*held.outcomes[0].value, WithinAbs(2e-3, rounding));
    CHECK(held.outcomes[0].limit == 2.5e-3);
    CHECK(held.outcomes[0].reason == "so it was derived");
    CHECK(held.outcomes[0].pass);
    CHECK(held.verdict == Verdict::Holds);

    const SceneResult failed = run(resting({exact(1.5e-3)}), engines);
    CHECK_FALSE(failed.outcomes[0].pass);
    CHECK(failed.verdict == Verdict::Fails);
}

TEST_CASE("Plumb may be as far off as the better Box2D, or 1 mm", "[compare][check]") {
    const Scene scene = resting({exact(1)});
    const SceneResult better = run(scene, standingAt(0.02, 0.05, 0.03));
    REQUIRE(better.outcomes.size() == 2);
    CHECK_THAT(better.outcomes[1].limit, WithinAbs(0.03, rounding));
    CHECK(better.verdict == Verdict::Holds);

    const SceneResult between = run(scene, standingAt(0.04, 0.05, 0.03));
    CHECK(between.outcomes[0].pass);
    CHECK_FALSE(between.outcomes[1].pass);
    CHECK(between.verdict == Verdict::Fails);

    const SceneResult invisible = run(scene, standingAt(0.9e-3, 1e-5, 1e-6));
    CHECK(invisible.outcomes[1].limit == 1e-3);
    CHECK(invisible.verdict == Verdict::Holds);
}

TEST_CASE("a Box2D that loses its body sets no standard", "[compare][check]") {
    const std::vector<Engine> engines{standing("plumb", 0.5), standing("box2d-3", nan), standing("closed-form", 0)};
    const SceneResult result = run(resting({exact(1)}), engines);
    CHECK(result.outcomes.size() == 1);
}

TEST_CASE("a Plumb that loses its body fails every check", "[compare][check]") {
    const std::vector<Engine> engines{standing("plumb", nan), standing("box2d-3", 0), standing("closed-form", 0)};
    const std::vector<Check> checks{exact(1e9), AgreeCheck{1e9, 1, ""},
                                    InvariantCheck{"energy_drift", 1e9, {"plumb"}, ""}, OrderCheck{0.1, {"plumb"}, ""}};
    const SceneResult result = run(resting(checks), engines);
    REQUIRE(result.outcomes.size() == 5);
    for (const Outcome& outcome : result.outcomes) {
        INFO(outcome.check);
        CHECK_FALSE(outcome.pass);
    }
}

TEST_CASE("Plumb and each Box2D agree to 5 cm or do not, engine by engine", "[compare][check]") {
    const SceneResult result = run(resting({AgreeCheck{0.05, 1, "modelled alike"}}), standingAt(0, 0.04, 0.06));
    REQUIRE(result.outcomes.size() == 2);
    CHECK(result.outcomes[0].engine == "box2d-2.4");
    CHECK(result.outcomes[0].metric == "divergence_max");
    CHECK(result.outcomes[0].pass);
    CHECK(result.outcomes[1].engine == "box2d-3");
    CHECK_THAT(*result.outcomes[1].value, WithinAbs(0.06, rounding));
    CHECK_FALSE(result.outcomes[1].pass);
}

TEST_CASE("engines that part at 1 m/s agree to 0.35 m until 0.3 s, and no longer until 0.4 s", "[compare][check]") {
    const Engine parting = scripted("box2d-3", {[](double t) { return std::vector<BodyState>{at(t, 0)}; }});
    const std::vector<Engine> engines{standing("plumb", 0), parting};
    CHECK(run(resting({AgreeCheck{0.35, 0.3, ""}}), engines).verdict == Verdict::Holds);
    CHECK(run(resting({AgreeCheck{0.35, 0.4, ""}}), engines).verdict == Verdict::Fails);
}

TEST_CASE("an invariant binds the engines it names, on both sides of its limit", "[compare][check]") {
    const InvariantCheck check{"settle_time", 0.55, {"plumb", "box2d-3"}, ""};
    const auto settling = [](const std::string& name, double when) {
        return scripted(name, {[when](double t) {
                            return std::vector<BodyState>{{{0, 0}, 0, {t < when ? 1.0 : 0.0, 0}, 0}};
                        }});
    };
    const std::vector<Engine> engines{settling("plumb", 0.45), settling("box2d-2.4", 9), settling("box2d-3", 0.65)};
    const SceneResult result = run(resting({check}), engines);
    REQUIRE(result.outcomes.size() == 2);
    CHECK(result.outcomes[0].engine == "plumb");
    CHECK(result.outcomes[0].pass);
    CHECK(result.outcomes[1].engine == "box2d-3");
    CHECK_FALSE(result.outcomes[1].pass);
}

TEST_CASE("an invariant whose metric has no value fails", "[compare][check]") {
    const Engine restless = scripted("plumb", {[](double) { return std::vector<BodyState>{{{0, 0}, 0, {1, 0}, 0}}; }});
    const SceneResult result = run(resting({InvariantCheck{"settle_time", 99, {"plumb"}, ""}}), {restless});
    REQUIRE(result.outcomes.size() == 1);
    CHECK_FALSE(result.outcomes[0].value);
    CHECK(result.verdict == Verdict::Fails);
}

TEST_CASE("an error of 0.3 dt^2 has order 2: at least 1.9, not at least 2.1", "[compare][check]") {
    const std::vector<Engine> engines = withTruth(converging("plumb", 0.3, 2));
    const SceneResult held = run(resting({OrderCheck{1.9, {"plumb"}, ""}}), engines);
    REQUIRE(held.outcomes.size() == 1);
    CHECK(held.outcomes[0].check == "order");
    CHECK(held.outcomes[0].metric == "order");
    CHECK_THAT(*held.outcomes[0].value, WithinAbs(2, 1e-9));  // the error is 2e-4 m, rounded to 1e-16 m
    CHECK(held.verdict == Verdict::Holds);
    CHECK(run(resting({OrderCheck{2.1, {"plumb"}, ""}}), engines).verdict == Verdict::Fails);
    CHECK(run(resting({OrderCheck{1.9, {"plumb"}, ""}}), withTruth(converging("plumb", 0.3, 1))).verdict ==
          Verdict::Fails);
}

TEST_CASE("an error that stays as it is has order 0, one that is only rounding has none, and holds",
          "[compare][check]") {
    const Scene scene = resting({OrderCheck{1, {"plumb"}, ""}});
    const SceneResult stuck = run(scene, withTruth(standing("plumb", 1e-6)));
    CHECK_THAT(*stuck.outcomes[0].value, WithinAbs(0, rounding));
    CHECK(stuck.verdict == Verdict::Fails);
    const SceneResult exactly = run(scene, withTruth(standing("plumb", 1e-13)));
    CHECK_FALSE(exactly.outcomes[0].value);
    CHECK(exactly.verdict == Verdict::Holds);
}

TEST_CASE("engines that were not asked for are neither run nor judged, and the closed form still measures",
          "[compare][check]") {
    const Scene scene = resting({exact(1), AgreeCheck{1, 1, ""}, InvariantCheck{"error_max", 1, {"box2d-3"}, ""}});
    const SceneResult plumbOnly = run(scene, standingAt(0, 0.1, 0.2), {"plumb"});
    REQUIRE(plumbOnly.engines.size() == 1);
    CHECK(plumbOnly.engines[0].measured.metrics.at("error_max") == 0.0);
    CHECK(plumbOnly.outcomes.size() == 1);  // exact's own limit

    const SceneResult box2dOnly = run(scene, standingAt(0, 0.1, 0.2), {"box2d-3"});
    REQUIRE(box2dOnly.outcomes.size() == 1);
    CHECK(box2dOnly.outcomes[0].check == "invariant");
    CHECK_FALSE(box2dOnly.engines[0].measured.metrics.at("divergence_max"));
}

TEST_CASE("a Box2D without a counterpart is not judged, a Plumb without one fails", "[compare][check]") {
    const Scene scene = resting({exact(1), AgreeCheck{1, 1, ""}, InvariantCheck{"error_max", 1, {"box2d-3"}, ""}});
    const std::vector<Engine> engines{standing("plumb", 0), unsupporting("box2d-3"), standing("closed-form", 0)};
    const SceneResult result = run(scene, engines);
    CHECK(result.outcomes.size() == 1);
    CHECK(result.verdict == Verdict::Holds);
    CHECK(result.engines[1].observation.unsupported == "it has no such thing");

    const SceneResult without = run(scene, {unsupporting("plumb"), standing("closed-form", 0)});
    CHECK(without.verdict == Verdict::Fails);
}

TEST_CASE("25 steps of 0.02 s run half a second", "[compare][check]") {
    const SceneResult result = runScene(resting({}), {{}, 25, 0.02}, {standing("plumb", 0)});
    CHECK(stepCount(result.scene) == 25);
    CHECK(result.scene.dt == 0.02);
    CHECK_THAT(result.scene.duration, WithinAbs(0.5, rounding));
    CHECK(result.engines[0].observation.states.size() == 26);
    CHECK(result.outcomes.empty());
}

TEST_CASE("a scene is not judged without checks, nor where none of them binds an engine that was run",
          "[compare][check]") {
    const std::vector<Engine> engines = standingAt(0, 0.1, 0.2);
    CHECK(run(resting({}), engines).verdict == Verdict::NotJudged);
    CHECK(run(resting({exact(1)}), engines, {"box2d-3"}).verdict == Verdict::NotJudged);
    CHECK(run(resting({exact(1)}), engines).verdict == Verdict::Holds);
}

TEST_CASE("of several scenes one that fails decides, then one that holds, of none nothing was judged",
          "[compare][check]") {
    const std::vector<Engine> engines = standingAt(0.1, 0.1, 0.2);
    const SceneResult unjudged = run(resting({}), engines);
    const SceneResult held = run(resting({exact(1)}), engines);
    const SceneResult failed = run(resting({exact(0.01)}), engines);
    const auto overall = [](const std::vector<SceneResult>& results) { return overallVerdict(results); };
    CHECK(overall({}) == Verdict::NotJudged);
    CHECK(overall({unjudged, unjudged}) == Verdict::NotJudged);
    CHECK(overall({unjudged, held}) == Verdict::Holds);
    CHECK(overall({failed, held, unjudged}) == Verdict::Fails);
}

TEST_CASE("a probe watched from later than a shortened run lasts does not hold", "[compare][check]") {
    Scene scene = resting({InvariantCheck{"probe.turn", 1, {"plumb"}, ""}});
    Probe probe;
    probe.name = "turn";
    probe.quantity = AngleProbe{"disc"};
    probe.from = 0.5;
    probe.unit = "rad";
    scene.probes = {probe};
    CHECK(runScene(scene, {}, {standing("plumb", 0)}).verdict == Verdict::Holds);
    CHECK(runScene(scene, {{}, 3, {}}, {standing("plumb", 0)}).verdict == Verdict::Fails);
}

TEST_CASE("options that cannot be are refused with the field, the value and what was wanted", "[compare][check]") {
    const Scene scene = resting({});
    const std::vector<Engine> engines{standing("plumb", 0)};
    CHECK_THROWS_WITH(runScene(scene, {{"bullet"}, {}, {}}, engines),
                      "RunOptions.engines: \"bullet\" is not an engine of this build");
    CHECK_THROWS_WITH(runScene(scene, {{}, 0, {}}, engines), "RunOptions.steps: 0 is not at least 1");
    CHECK_THROWS_AS(runScene(scene, {{}, {}, -0.1}, engines), std::invalid_argument);
    CHECK_THROWS_AS(runScene(scene, {{}, {}, nan}, engines), std::invalid_argument);
    CHECK_THROWS_AS(runScene(scene, {{}, {}, 10.0}, engines), std::invalid_argument);
}

}  // namespace plumb::compare
