// SPDX-License-Identifier: MIT
// Which actions does a game have, and which keys and gamepad buttons trigger them?
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::games {

// clang-format off
enum class Key {
    Left, Right, Up, Down, Space, Enter, Escape, Tab, Backspace, Shift, Control, Minus, Plus, Comma, Period,
    A, B, C, D, E, F, G, H, I, J, K, L, M, N, O, P, Q, R, S, T, U, V, W, X, Y, Z,
    Digit0, Digit1, Digit2, Digit3, Digit4, Digit5, Digit6, Digit7, Digit8, Digit9,
};
/// Directions mean the directional pad and the left stick. South is the lowest face button: A or a cross on most pads.
enum class Pad {
    Left, Right, Up, Down, South, East, West, North,
    LeftShoulder, RightShoulder, LeftTrigger, RightTrigger, Start, Back,
};
// clang-format on

std::string_view nameOf(Key key);  ///< as players see it: "Space", an arrow
std::string_view nameOf(Pad pad);  ///< "South"

struct Action {
    std::string name;         ///< letters, digits, - and _
    std::vector<Key> keys{};  ///< each of them triggers the action
    std::vector<Pad> pads{};
    /// For the title's list of keys: "jump". Actions with the same text share one entry. Empty: not listed.
    std::string about{};
};

/// The actions whose buttons are down in a tick: bit i is action i of the list.
using Buttons = std::uint32_t;

inline constexpr int maxActions = 32;

/// A list of actions, found by name. Action i has bit i.
class ActionList {
public:
    ActionList() = default;
    /// Throws std::invalid_argument when there are more than maxActions, or when a name is invalid or used twice.
    explicit ActionList(std::vector<Action> actions);

    int size() const { return static_cast<int>(actions_.size()); }
    const Action& operator[](int index) const { return actions_[static_cast<std::size_t>(index)]; }
    const std::vector<Action>& all() const { return actions_; }
    bool contains(std::string_view name) const;
    /// Throws std::invalid_argument when no action has that name.
    int indexOf(std::string_view name) const;
    /// The bit of one action; throws like indexOf.
    Buttons button(std::string_view name) const { return Buttons{1} << indexOf(name); }

private:
    std::vector<Action> actions_;
};

/// The game's actions in their order, then the menus' actions: confirm, back, pause, left, right, up, down. If the game
/// has an action of the same name, there is only one: the game's action also gets those keys and buttons of the menus
/// that no action of the game uses.
ActionList withMenuActions(const std::vector<Action>& game);

}  // namespace plumb::games
