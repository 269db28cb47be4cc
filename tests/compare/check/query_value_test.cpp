// SPDX-License-Identifier: MIT
#include <compare/check/answer.h>

#include <cmath>

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
