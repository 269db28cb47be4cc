// SPDX-License-Identifier: MIT
#include <compare/scene/named.h>

#include <vector>

#include "catch.h"

namespace plumb::compare {
TEST_CASE("a misspelled name is told the one that differs in the fewest letters", "[compare][scene]") {
    const std::vector<std::string> known{"position", "friction", "restitution"};
    CHECK(nearest("postion", known) == "position");   // a letter left out
    CHECK(nearest("frictoin", known) == "friction");  // two swapped
    CHECK(nearest("restitutoin", known) == "restitution");
    CHECK(nearest("position", known) == "position");
}

TEST_CASE("of names equally near the first is told, and none where none is known", "[compare][scene]") {
    CHECK(nearest("x", std::vector<std::string>{"a", "b"}) == "a");
    CHECK(nearest("", std::vector<std::string>{"abc", "ab"}) == "ab");
    CHECK(nearest("x", {}).empty());
}

TEST_CASE("of known names twelve are listed, and dots for more", "[compare][scene]") {
    CHECK(listText(std::vector<std::string>{"a", "b"}) == "a, b");
    CHECK(listText(std::vector<std::string>(12, "a")).find("...") == std::string::npos);
    CHECK(listText(std::vector<std::string>(13, "a")).ends_with("a, a, ..."));
}

}  // namespace plumb::compare
