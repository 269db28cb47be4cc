// SPDX-License-Identifier: MIT
#include <compare/metric/metrics.h>

#include <cmath>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

constexpr double metricRounding = 1e-12;  // of numbers below 100

using Path = std::function<BodyState(double)>;

Observation run(const Scene& scene, const std::string& engine, const Path& path) {
    return observe(scene, scripted(engine, {[path](double t) { return std::vector<BodyState>{path(t)}; }}));
}

/// The disc thrown up at 3 m/s under 10 m/s^2, as it should fly.
BodyState thrown(double t) {
    return {{0, 3 * t - 5 * t * t}, 0, {0, 3 - 10 * t}, 0};
}

Metrics metricsOf(const Scene& scene, const Path& path) {
    return measure(scene, run(scene, "box2d-3", path), nullptr, nullptr).metrics;
}

}  // namespace

TEST_CASE("a body that drifts off its closed form by 0.5 m/s is off by 0.5 m at the end of 1 s", "[compare][metric]") {
    const Scene scene = oneDisc();
    const Observation truth = run(scene, "closed-form", thrown);
    const Observation seen = run(scene, "box2d-3", [](double t) {
        BodyState state = thrown(t);
        state.position.x() = t < 0.85 ? 0.75 * t : 0.5 * t;
        return state;
    });
    const Measured measured = measure(scene, seen, &truth, nullptr);
    CHECK_THAT(*measured.metrics.at("error_max"), WithinAbs(0.6, metricRounding));  // 0.75 m/s for 0.8 s
    CHECK_THAT(*measured.metrics.at("error_end"), WithinAbs(0.5, metricRounding));
    REQUIRE(measured.series.error.size() == 11);
    CHECK_THAT(measured.series.error[4], WithinAbs(0.3, metricRounding));
    CHECK_FALSE(measured.metrics.at("divergence_max"));
}

TEST_CASE("beyond the time the closed form holds there is no error", "[compare][metric]") {
    const Scene scene = oneDisc();
    const Observation truth = run(scene, "closed-form", [](double t) { return t > 0.45 ? at(nan, nan) : thrown(t); });
    const Observation seen = run(scene, "plumb", [](double t) { return at(t, thrown(t).position.y()); });
    const Measured measured = measure(scene, seen, &truth, nullptr);
    CHECK_THAT(*measured.metrics.at("error_max"), WithinAbs(0.4, metricRounding));
    CHECK_THAT(*measured.metrics.at("error_end"), WithinAbs(0.4, metricRounding));
    CHECK(std::isnan(measured.series.error[5]));
}

TEST_CASE("a body that is not a number has an error without bound in every metric", "[compare][metric]") {
    const Scene scene = oneDisc();
    const Observation truth = run(scene, "closed-form", thrown);
    const Observation seen = run(scene, "box2d-3", [](double t) { return t > 0.55 ? at(0, nan) : thrown(t); });
    const Metrics metrics = measure(scene, seen, &truth, &truth).metrics;
    for (const char* name :
         {"error_max", "error_end", "divergence_max", "energy_drift", "momentum_drift", "angular_momentum_drift"}) {
        INFO(name);
        CHECK(metrics.at(name) == infinity);
    }
    CHECK_FALSE(metrics.at("settle_time"));
}

TEST_CASE("divergence passes 1 cm after 0.2 s and reaches 6 cm", "[compare][metric]") {
    const Scene scene = oneDisc();
    const Observation reference = run(scene, "plumb", thrown);
    const Observation seen = run(scene, "box2d-3", [](double t) { return at(0.06 * t, thrown(t).position.y()); });
    const Metrics metrics = measure(scene, seen, nullptr, &reference).metrics;
    CHECK_THAT(*metrics.at("divergence_max"), WithinAbs(0.06, metricRounding));
    CHECK_THAT(*metrics.at("divergence_time"), WithinAbs(0.2, metricRounding));  // 0.6 cm, then 1.2 cm
    CHECK_FALSE(measure(scene, reference, nullptr, &reference).metrics.at("divergence_time"));
    CHECK_THAT(*divergenceUntil(scene, seen, reference, 0.4), WithinAbs(0.024, metricRounding));
    CHECK_THAT(*divergenceUntil(scene, seen, reference, 99), WithinAbs(0.06, metricRounding));
}

TEST_CASE("a disc in free flight keeps its energy, momentum drifts by all that gravity gives", "[compare][metric]") {
    const Metrics metrics = metricsOf(oneDisc(), thrown);
    CHECK_THAT(*metrics.at("energy_drift"), WithinAbs(0, metricRounding));
    // from 6 N s to -14 N s, relative to the largest, 14
    CHECK_THAT(*metrics.at("momentum_drift"), WithinAbs(20 / 14.0, metricRounding));
}

TEST_CASE("energy drift does not depend on where height counts from", "[compare][metric]") {
    Scene scene = oneDisc();
    const Path lossy = [](double t) {
        BodyState state = thrown(t);
        state.velocity *= 0.9;
        return state;
    };
    const double drift = *metricsOf(scene, lossy).at("energy_drift");
    scene.bodies[0].def.position = {0, 1000};
    const Path lossyUpThere = [&](double t) {
        BodyState state = lossy(t);
        state.position.y() += 1000;
        return state;
    };
    // 1000 m up a position is rounded to 1e-13 m, an energy of 20 J/m to 2e-12 J
    CHECK_THAT(*metricsOf(scene, lossyUpThere).at("energy_drift"), WithinAbs(drift, 1e-11));
    // by hand: E - E0 = 0.81 (v^2 - v0^2) - (v^2 - v0^2), at the end 0.19 (9 - 49) J; the largest kinetic energy is
    // 0.81 * 49 J, the potential ranges over 20 (0.45 + 2) J
    CHECK_THAT(drift, WithinAbs(0.19 * 40 / 49, metricRounding));
}

TEST_CASE("bodies that never move have drifts of 0 and settle at 0 s", "[compare][metric]") {
    const Metrics metrics = metricsOf(oneDisc(), [](double) { return at(0, 0); });
    CHECK(*metrics.at("energy_drift") == 0);
    CHECK(*metrics.at("momentum_drift") == 0);
    CHECK(*metrics.at("angular_momentum_drift") == 0);
    CHECK(*metrics.at("settle_time") == 0);
}

TEST_CASE("a disc settles when it last became slower than 0.05 m/s, its rim included", "[compare][metric]") {
    const auto settling = [](double speed, double spin) {
        return metricsOf(oneDisc(), [=](double t) {
            const bool early = t < 0.55;
            return BodyState{{0, 0}, 0, {early ? speed : 0.04, 0}, early ? spin : 0.01};
        });
    };
    CHECK_THAT(*settling(1, 0).at("settle_time"), WithinAbs(0.6, metricRounding));
    CHECK_THAT(*settling(0, 0.2).at("settle_time"), WithinAbs(0.6, metricRounding));  // 0.1 m/s at the rim
    CHECK_THAT(*settling(0, 0.05).at("settle_time"), WithinAbs(0, metricRounding));   // 0.025 m/s at the rim
    CHECK_FALSE(metricsOf(oneDisc(), [](double t) { return BodyState{{0, 0}, 0, {t, 0}, 0}; }).at("settle_time"));
}

TEST_CASE("a lone disc has no penetration and no joint error", "[compare][metric]") {
    const Metrics metrics = metricsOf(oneDisc(), thrown);
    CHECK_FALSE(metrics.at("penetration_max"));
    CHECK_FALSE(metrics.at("joint_error_max"));
}

TEST_CASE("a scene without a dynamic body has no drift", "[compare][metric]") {
    Scene scene = oneDisc();
    scene.bodies[0].def.type = BodyType::Static;
    const Metrics metrics = metricsOf(scene, [](double) { return at(0, 0); });
    CHECK_FALSE(metrics.at("energy_drift"));
    CHECK_FALSE(metrics.at("settle_time"));
}

TEST_CASE("two discs that swap 1 m/s keep momentum and energy, one that stops loses half of each",
          "[compare][metric]") {
    Scene scene = oneDisc();
    scene.gravity = {0, 0};
    scene.bodies[0].def.velocity = {1, 0};
    scene.bodies.push_back(scene.bodies[0]);
    scene.bodies[1].name = "other";
    scene.bodies[1].def.position = {1.5, 0};
    scene.bodies[1].def.velocity = {-1, 0};
    const auto collision = [&](double speedAfter) {
        const Script script{[speedAfter](double t) {
            const double side = t < 0.25 ? 1 - t : 0.75 + speedAfter * (t - 0.25);
            const double speed = t < 0.25 ? 1 : -1;
            BodyState a{{-side, 0}, 0, {speed, 0}, 0};
            BodyState b{{side, 0}, 0, {t < 0.25 ? -1 : speedAfter, 0}, 0};
            return std::vector<BodyState>{a, b};
        }};
        return measure(scene, observe(scene, scripted("plumb", script)), nullptr, nullptr).metrics;
    };
    CHECK_THAT(*collision(1).at("momentum_drift"), WithinAbs(0, metricRounding));
    CHECK_THAT(*collision(1).at("energy_drift"), WithinAbs(0, metricRounding));
    CHECK_THAT(*collision(1).at("angular_momentum_drift"), WithinAbs(0, metricRounding));
    CHECK_THAT(*collision(0).at("momentum_drift"), WithinAbs(0.5, metricRounding));  // 2 of 4 N s
    CHECK_THAT(*collision(0).at("energy_drift"), WithinAbs(0.5, metricRounding));    // 1 of 2 J
}

TEST_CASE("the closed form's own run has an error of 0, an energy, and no wall time", "[compare][metric]") {
    const Scene scene = oneDisc();
    const Observation truth = run(scene, "closed-form", [](double t) { return t > 0.75 ? at(nan, nan) : thrown(t); });
    const Measured measured = measure(scene, truth, &truth, nullptr);
    CHECK(*measured.metrics.at("error_max") == 0);
    CHECK_THAT(*measured.metrics.at("energy_drift"), WithinAbs(0, metricRounding));
    CHECK_FALSE(measured.metrics.at("ms_per_step"));
    CHECK_FALSE(measured.metrics.at("settle_time"));
}

TEST_CASE("a scene that an engine cannot build has all metrics, and none with a value", "[compare][metric]") {
    Scene scene = oneDisc();
    Probe probe;
    probe.name = "turn";
    probe.quantity = AngleProbe{"disc"};
    scene.probes = {probe};
    const Metrics metrics = measure(scene, observe(scene, unsupporting("box2d-3")), nullptr, nullptr).metrics;
    CHECK(metrics.size() == 12);
    CHECK(metrics.contains("probe.turn"));
    for (const auto& [name, value] : metrics) CHECK_FALSE(value);
}

TEST_CASE("lengths are in m, times in s, drifts have no unit, a probe has its own", "[compare][metric]") {
    Scene scene = oneDisc();
    Probe probe;
    probe.name = "normal";
    probe.quantity = NormalForceProbe{"disc", "disc"};
    probe.unit = "N";
    scene.probes = {probe};
    CHECK(metricUnit(scene, "error_max") == "m");
    CHECK(metricUnit(scene, "settle_time") == "s");
    CHECK(metricUnit(scene, "ms_per_step") == "ms");
    CHECK(metricUnit(scene, "energy_drift").empty());
    CHECK(metricUnit(scene, "probe.normal") == "N");
}

}  // namespace plumb::compare
