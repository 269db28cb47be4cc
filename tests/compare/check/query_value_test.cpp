// SPDX-License-Identifier: MIT
#include <compare/check/answer.h>

#include <cmath>
#include <random>
#include <string>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

/// A disc that is thrown up at 3 m/s under 10 m/s^2.
struct Thrown {
    Scene scene = oneDisc();
    Observation run;

    Thrown() {
        run = observe(scene, scripted("plumb", {[](double t) {
                                          BodyState state = at(2 * t, 3 * t - 5 * t * t);
                                          state.velocity = {2, 3 - 10 * t};
                                          return std::vector<BodyState>{state};
                                      }}));
    }

    AnswerQuery query(const std::string& text) {
        scene.answer = "{" + text + "}";
        return *answerParts(scene).front().query;
    }
    std::optional<double> value(const std::string& text) { return valueOf(scene, run, query(text)); }
    std::string unit(const std::string& text) { return unitOf(scene, query(text)); }
};

}  // namespace

TEST_CASE("a disc thrown up at 3 m/s is 0.45 m high after 0.3 s, and back after 0.6 s at 1.2 m: all to 12 digits",
          "[compare][check]") {
    Thrown thrown;
    CHECK(std::abs(thrown.value("first maximum of y of disc").value() - 0.45) < 1e-12);
    CHECK(std::abs(thrown.value("time when y of disc first returns to 0").value() - 0.6) < 1e-12);
    CHECK(std::abs(thrown.value("x of disc when y first returns to start").value() - 1.2) < 1e-12);
    CHECK(std::abs(thrown.value("drop of y of disc").value() - 2) < 1e-12);
    CHECK(std::abs(thrown.value("duration").value() - 1) < 1e-12);
}

TEST_CASE("an impact between two steps is read at its own time and place, with the speed just before it",
          "[compare][check]") {
    std::mt19937 random(68);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    for (int i = 0; i < 2000; ++i) {
        Scene scene = oneDisc();
        scene.duration = 1;
        scene.dt = 1 / std::floor(between(10, 240));
        const double hit = between(2 * scene.dt, 1 - 2 * scene.dt), across = between(-9, 9);
        const double g = between(0, 20), kept = between(0.1, 1), down = between(11, 30);  // at the impact
        const auto flown = [&](double t) {
            const double s = t - hit;
            BodyState state = at(across * t, (s < 0 ? -down : kept * down) * s - 0.5 * g * s * s);
            state.velocity = {across, (s < 0 ? -down : kept * down) - g * s};
            return std::vector<BodyState>{state};
        };
        const Observation run = observe(scene, scripted("plumb", {flown}));
        const auto value = [&](const std::string& text) {
            return valueOf(scene, run, answerQuery(scene, text)).value();
        };
        CAPTURE(i, scene.dt, hit, g, kept, down);
        REQUIRE(std::abs(value("time when y of disc first is below 1e-9") - hit) < 1e-8);
        REQUIRE(std::abs(value("vy of disc when y first is below 1e-9") + down) < 1e-6);
        REQUIRE(std::abs(value("x of disc when first minimum of y") - across * hit) < 1e-8);
        REQUIRE(std::abs(value("time when first impact of disc") - hit) < 1e-8);
        REQUIRE_FALSE(valueOf(scene, run, answerQuery(scene, "x of disc when second impact")));
    }
}

TEST_CASE("a query has no value where what it names does not happen", "[compare][check]") {
    Thrown thrown;
    CHECK_FALSE(thrown.value("time when y of disc first is above 1"));
    CHECK_FALSE(thrown.value("x of disc when y first returns to 1"));
    CHECK_FALSE(thrown.value("period of y of disc"));
}

TEST_CASE("times are in s, and what a query reads has its own unit", "[compare][check]") {
    Thrown thrown;
    CHECK(thrown.unit("period of y of disc") == "s");
    CHECK(thrown.unit("time when y of disc first returns to 0") == "s");
    CHECK(thrown.unit("largest speed of disc") == "m/s");
    CHECK(thrown.unit("x of disc when y first returns to 0") == "m");
}

}  // namespace plumb::compare
