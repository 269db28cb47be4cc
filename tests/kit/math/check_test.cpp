// SPDX-License-Identifier: MIT
#include <plumb/math/check.h>

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <plumb/math/random.h>

#include "catch.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

TEST_CASE("numbers in messages are as short as a person would write them", "[math][errors]") {
    CHECK(toText(-1.0) == "-1");
    CHECK(toText(0.1) == "0.1");
    CHECK(toText(100.0) == "100");
    CHECK(toText(1.0 / 3) == "0.3333333333333333");
    CHECK(toText(1e300) == "1e+300");
    CHECK(toText(infinity) == "inf");
    CHECK(toText(-infinity) == "-inf");
    CHECK(toText(-test::nan) == "nan");
    CHECK(toText(Vec2(0.5, -2)) == "(0.5, -2)");
}

TEST_CASE("100,000 numbers of any size read back as they were", "[math][errors]") {
    Random random(3);
    bool same = true;
    for (int i = 0; i < 100'000; ++i) {
        const double value = std::ldexp(random.uniform(-1, 1), random.integer(-1080, 1024));
        same = same && std::strtod(toText(value).c_str(), nullptr) == value;
    }
    CHECK(same);
}

TEST_CASE("a refusal names field, value and what is wrong", "[math][errors]") {
    CHECK_THROWS_AS(requireFinite(test::nan, "BodyDef.angle"), std::invalid_argument);
    CHECK_THROWS_WITH(requireFinite(test::nan, "BodyDef.angle"), "BodyDef.angle: nan is not finite");
    CHECK_THROWS_WITH(requireFinite(Vec2(test::nan, 0), "BodyDef", ".position"),
                      "BodyDef.position: (nan, 0) is not finite");
    CHECK_THROWS_WITH(requireFinite(Vec2(0, -infinity), "at"), "at: (0, -inf) is not finite");
    CHECK_THROWS_WITH(requirePositive(-1, "Circle.radius"), "Circle.radius: -1 is not positive");
    CHECK_THROWS_WITH(requirePositive(0, "r"), "r: 0 is not positive");
    CHECK_THROWS_WITH(requirePositive(infinity, "r"), "r: inf is not finite");
    CHECK_THROWS_WITH(requirePositive(Vec2(1, 0), "box", ".halfSize"), "box.halfSize: (1, 0) is not positive");
    CHECK_THROWS_WITH(requireNotNegative(-0.5, "d"), "d: -0.5 is negative");
    CHECK_THROWS_WITH(requireWithin(1.5, 0, 1, "e"), "e: 1.5 is not within 0 to 1");
    CHECK_THROWS_WITH(requireWithin(test::nan, 0, 1, "e"), "e: nan is not finite");
}

TEST_CASE("what is as asked for is taken in, the bounds included", "[math][errors]") {
    CHECK_NOTHROW(requireFinite(1.7e308, "x"));
    CHECK_NOTHROW(requireFinite(Vec2(-1.7e308, 5e-324), "x"));
    CHECK_NOTHROW(requirePositive(5e-324, "x"));
    CHECK_NOTHROW(requireNotNegative(0, "x"));
    CHECK_NOTHROW(requireNotNegative(-0.0, "x"));
    CHECK_NOTHROW(requireWithin(0, 0, 1, "x"));
    CHECK_NOTHROW(requireWithin(1, 0, 1, "x"));
}
