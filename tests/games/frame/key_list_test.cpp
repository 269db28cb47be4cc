// SPDX-License-Identifier: MIT
#include <games/frame/screens.h>

#include "catch.h"

using namespace plumb::games;
using Lines = std::vector<std::string>;

TEST_CASE("actions with the same text share one entry, with the first keys first", "[games]") {
    const std::vector<Action> actions{{"left", {Key::Left, Key::A}, {}, "walk"},
                                      {"jump", {Key::Space, Key::Z}, {}, "jump"},
                                      {"right", {Key::Right, Key::D}, {}, "walk"},
                                      {"secret", {Key::S}},
                                      {"pads", {}, {Pad::South}, "nothing on a keyboard"}};
    CHECK(keyLines(actions, 200) == Lines{"← → or A D  walk     ·     Space or Z  jump"});
}

TEST_CASE("keys that do not fit into a line go into the next line, an arrow counts as one letter", "[games]") {
    const std::vector<Action> actions{{"left", {Key::Left}, {}, "a"}, {"up", {Key::Up}, {}, "b"}};
    CHECK(keyLines(actions, 19) == Lines{"←  a     ·     ↑  b"});
    CHECK(keyLines(actions, 18) == Lines{"←  a", "↑  b"});
    CHECK(keyLines({}, 10).empty());
}
