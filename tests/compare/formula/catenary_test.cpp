// SPDX-License-Identifier: MIT
#include <compare/formula/catenary.h>

#include <cmath>

#include "catch.h"

namespace plumb::compare {

TEST_CASE("a chain of 20 links spans its hooks, each link as long as it is, and hangs alike on both sides",
          "[compare][formula]") {
    const HungChain chain{.left = {-2, 3}, .span = 4, .links = 20, .linkLength = 0.25};
    const std::vector<Vec2> hinges = hingesOf(chain);
    REQUIRE(hinges.size() == 21);
    CHECK((hinges.back() - Vec2(2, 3)).norm() < 1e-14);
    for (std::size_t i = 0; i < 20; ++i) {
        CHECK(std::abs((hinges[i + 1] - hinges[i]).norm() - 0.25) < 1e-15);
        CHECK(std::abs(hinges[i].x() + hinges[20 - i].x()) < 1e-14);
        CHECK(std::abs(hinges[i].y() - hinges[20 - i].y()) < 1e-14);
    }
}

TEST_CASE("every link of a hung chain is in balance", "[compare][formula][law]") {
    const HungChain chain{.span = 3, .links = 7, .linkLength = 0.6};
    const std::vector<Vec2> hinges = hingesOf(chain);
    // A link of weight 1 is pulled at its right end by (H, V + 1) and at its left by (-H, -V), and weighs in its
    // middle.
    const Vec2 first = hinges[1] - hinges[0];
    const double pull = (0.5 - 3.5) * first.x() / first.y();
    for (std::size_t i = 0; i < 7; ++i) {
        const Vec2 along = hinges[i + 1] - hinges[i];
        const double left = static_cast<double>(i) - 3.5, right = left + 1;
        const double torque = along.x() * right - along.y() * pull - along.x() / 2;  // about its left end
        CHECK(std::abs(torque) < 1e-12);
        CHECK(std::abs((right - left) - 1) < 1e-15);
    }
}

TEST_CASE("a chain of many links hangs as a catenary", "[compare][formula][law]") {
    // y = a cosh(x / a) with a = 1 over x = -1 .. 1 is 2 sinh 1 long and sags by cosh 1 - 1.
    const int links = 2000;
    const HungChain chain{.left = {-1, 0}, .span = 2, .links = links, .linkLength = 2 * std::sinh(1.0) / links};
    const std::vector<Vec2> hinges = hingesOf(chain);
    const double lowest = hinges[links / 2].y();
    CHECK(std::abs(lowest + std::cosh(1.0) - 1) < 1e-6);  // chords of 1/1000 are short by their square
    for (const Vec2& hinge : hinges) CHECK(std::abs(hinge.y() - lowest - (std::cosh(hinge.x()) - 1)) < 1e-6);
}

}  // namespace plumb::compare
