// SPDX-License-Identifier: MIT
#include <games/frame/action.h>
#include <games/frame/input.h>

#include "catch.h"

using namespace plumb::games;
using plumb::test::containsText;

namespace {

bool has(const std::vector<Key>& keys, Key key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace

TEST_CASE("a game's actions keep their bits, and the menus' seven actions follow them", "[games]") {
    const ActionList actions = withMenuActions({{"jump", {Key::Space}}, {"dig", {Key::X}}});
    CHECK(actions.size() == 9);
    CHECK(actions.button("jump") == 1);
    CHECK(actions.button("dig") == 2);
    CHECK(actions.button("confirm") == 4);
    // Space jumps, and it also confirms in a menu: one key has two actions.
    CHECK(has(actions[actions.indexOf("confirm")].keys, Key::Space));
}

TEST_CASE("an action of a game and of the menus is one action, with the menus' keys that the game does not use",
          "[games]") {
    const ActionList actions = withMenuActions({{"up", {Key::W}}, {"jump", {Key::Up}}, {"left", {Key::A}}});
    CHECK(actions.size() == 8);
    CHECK(actions[0].keys == std::vector<Key>{Key::W});  // Up jumps here
    CHECK(actions[2].keys == std::vector<Key>{Key::A, Key::Left});
}

TEST_CASE("a game may have 25 actions, not 26: with the menus' seven there are bits for 32", "[games]") {
    std::vector<Action> many;
    for (int i = 0; i < 25; ++i) many.push_back({"a" + std::to_string(i)});
    CHECK(withMenuActions(many).size() == 32);
    many.push_back({"one-more"});
    CHECK_THROWS_WITH(withMenuActions(many), containsText("33 actions") && containsText("at most 32"));
}

TEST_CASE("names of actions that a record could not tell apart are refused", "[games]") {
    CHECK_THROWS_WITH(ActionList({{"go left"}}), containsText("Action.name: \"go left\""));
    CHECK_THROWS_WITH(ActionList({{""}}), containsText("Action.name"));
    CHECK_THROWS_WITH(ActionList({{"-"}}), containsText("Action.name"));
    CHECK_THROWS_WITH(ActionList({{"a+b"}}), containsText("Action.name"));
    CHECK_THROWS_WITH(ActionList({{"dig"}, {"jump"}, {"dig"}}), containsText("\"dig\" is used twice"));
    CHECK_THROWS_WITH(ActionList({{"dig"}}).indexOf("fly"), containsText("\"fly\""));
}

TEST_CASE(
    "a button up, down, down, up in four ticks is pressed in the second, held in the third, released in the fourth",
    "[games]") {
    const ActionList actions({{"jump"}, {"dig"}});
    const Buttons dig = 2;
    const Input up(actions, 0, 0), press(actions, dig, 0), hold(actions, dig, dig), release(actions, 0, dig);
    const auto states = [](const Input& input) {
        return std::vector<bool>{input.pressed("dig"), input.held("dig"), input.released("dig")};
    };
    CHECK(states(up) == std::vector<bool>{false, false, false});
    CHECK(states(press) == std::vector<bool>{true, true, false});
    CHECK(states(hold) == std::vector<bool>{false, true, false});
    CHECK(states(release) == std::vector<bool>{false, false, true});
    CHECK_FALSE(hold.held("jump"));
    CHECK(press.pressed(1));
    CHECK(press.axis("jump", "dig") == 1);
    CHECK(press.axis("dig", "jump") == -1);
    CHECK(Input(actions, 3, 0).axis("dig", "jump") == 0);
}

TEST_CASE("an unknown action is refused, by name and by index", "[games]") {
    const ActionList actions({{"jump"}});
    const Input input(actions, 1, 0);
    CHECK_THROWS_WITH(input.held("jmup"), containsText("\"jmup\""));
    CHECK_THROWS_WITH(input.pressed(1), containsText("1 is not an index"));
    CHECK_THROWS_WITH(input.released(-1), containsText("-1 is not an index"));
}
