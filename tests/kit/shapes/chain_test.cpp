// SPDX-License-Identifier: MIT
#include <plumb/shapes/chain.h>

#include <limits>
#include <stdexcept>

#include "catch.h"

using namespace plumb;

namespace {

void checkChain(const Shape& shape) {
    validate(shape, "S");
}

}  // namespace

TEST_CASE("an open chain of 4 points has 3 segments, each with the points before and after it", "[shapes][chain]") {
    const std::vector<Shape> pieces = piecesOf(Chain{{{0, 0}, {1, 0}, {2, 1}, {3, 1}}});
    REQUIRE(pieces.size() == 3);
    const auto& first = std::get<Segment>(pieces[0]);
    CHECK(first.start == Vec2(0, 0));
    CHECK(first.end == Vec2(1, 0));
    CHECK_FALSE(first.before.has_value());
    CHECK(first.after == Vec2(2, 1));
    const auto& middle = std::get<Segment>(pieces[1]);
    CHECK(middle.before == Vec2(0, 0));
    CHECK(middle.after == Vec2(3, 1));
    const auto& last = std::get<Segment>(pieces[2]);
    CHECK(last.before == Vec2(1, 0));
    CHECK_FALSE(last.after.has_value());
    for (const Shape& piece : pieces) CHECK_NOTHROW(checkChain(piece));
}

TEST_CASE("a closed chain of 3 points has 3 segments, and goes on at every joint", "[shapes][chain]") {
    const std::vector<Shape> pieces = piecesOf(Chain{{{0, 0}, {2, 0}, {0, 1}}, true});
    REQUIRE(pieces.size() == 3);
    const auto& last = std::get<Segment>(pieces[2]);
    CHECK(last.start == Vec2(0, 1));
    CHECK(last.end == Vec2(0, 0));
    CHECK(last.before == Vec2(2, 0));
    CHECK(last.after == Vec2(2, 0));
    CHECK(std::get<Segment>(pieces[0]).before == Vec2(0, 1));
}

TEST_CASE("what is no chain is its own one piece", "[shapes][chain]") {
    CHECK(std::get<Circle>(piecesOf(Circle{3}).at(0)).radius == 3);
    const std::vector<Shape> lone = piecesOf(Chain{{{0, 0}, {1, 0}}});
    REQUIRE(lone.size() == 1);
    CHECK_FALSE(std::get<Segment>(lone[0]).after.has_value());
}

TEST_CASE("chains that repeat a point, fold straight back, or have too few are refused", "[shapes][chain][errors]") {
    CHECK_NOTHROW(checkChain(Chain{{{0, 0}, {1, 0}}}));
    CHECK_NOTHROW(checkChain(Chain{{{0, 0}, {1, 0}, {0, 1e-3}}}));
    CHECK_THROWS_AS(checkChain(Chain{}), std::invalid_argument);
    CHECK_THROWS_WITH(checkChain(Chain{{{0, 0}}}), "S.points: 1 points are fewer than 2");
    CHECK_THROWS_WITH(checkChain(Chain{{{0, 0}, {1, 0}}, true}),
                      "S.points: 2 points are fewer than 3 of a closed chain");
    CHECK_THROWS_WITH(checkChain(Chain{{{0, 0}, {1, 0}, {1, 0}}}), "S.points[2]: (1, 0) repeats the point before it");
    CHECK_THROWS_WITH(checkChain(Chain{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}, true}),
                      "S.points[0]: (0, 0) repeats the point before it");
    CHECK_NOTHROW(checkChain(Chain{{{0, 0}, {1, 0}, {1, 1}, {0, 0}}}));
    CHECK_THROWS_WITH(checkChain(Chain{{{0, 0}, {2, 0}, {1, 0}}}),
                      "S.points[1]: (2, 0) folds the line straight back on itself");
    CHECK_THROWS_WITH(checkChain(Chain{{{0, 0}, {1, 0}, {2, 0}}, true}),
                      "S.points[2]: (2, 0) folds the line straight back on itself");
    CHECK_THROWS_WITH(checkChain(Chain{{{0, 0}, {std::numeric_limits<double>::infinity(), 0}}}),
                      "S.points[1]: (inf, 0) is not finite");
    CHECK_THROWS_WITH(checkChain(Chain{{{0, 0}, {1e300, 0}, {0, 1e290}}}),
                      "S.points[1]: (1e+300, 0) folds the line straight back on itself");
}

TEST_CASE("a segment's neighbours are held to the same as a chain's points", "[shapes][chain][errors]") {
    Segment segment{{0, 0}, {1, 0}};
    segment.before = Vec2(-1, 0);
    segment.after = Vec2(1, 1);
    CHECK_NOTHROW(checkChain(segment));
    segment.after = Vec2(1, 0);
    CHECK_THROWS_WITH(checkChain(segment), "S.after: (1, 0) is the end of the segment, not a point beyond");
    segment.after = Vec2(0.5, 0);
    CHECK_THROWS_WITH(checkChain(segment), "S.after: (0.5, 0) folds the line straight back on itself");
    segment.after.reset();
    segment.before = Vec2(0, std::numeric_limits<double>::quiet_NaN());
    CHECK_THROWS_WITH(checkChain(segment), "S.before: (0, nan) is not finite");
}
