// SPDX-License-Identifier: MIT
// What can be done in a game, and with which keys and gamepad buttons?
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
/// Directions are those of the cross and of the left stick; South is where most pads have A or a cross.
enum class Pad {
    Left, Right, Up, Down, South, East, West, North,
    LeftShoulder, RightShoulder, LeftTrigger, RightTrigger, Start, Back,
};
// clang-format on

std::string_view nameOf(Key key);  ///< as a player is told it: "Space", an arrow
std::string_view nameOf(Pad pad);  ///< "South"

struct Action {
    std::string name;         ///< letters, digits, - and _
    std::vector<Key> keys{};  ///< each of them does it
    std::vector<Pad> pads{};
    std::string
        about{};  ///< for the title's list of keys, "jump"; the same for several: told as one; empty: not listed
};

/// Which actions are done in a tick: bit i is action i of the list.
using Buttons = std::uint32_t;

inline constexpr int maxActions = 32;

/// A list of actions that are found by name. Its order is that of the bits.
class ActionList {
public:
    ActionList() = default;
    /// Throws std::invalid_argument when there are more than maxActions, or a name is bad or there twice.
    explicit ActionList(std::vector<Action> actions);

    int size() const { return static_cast<int>(actions_.size()); }
    const Action& operator[](int index) const { return actions_[static_cast<std::size_t>(index)]; }
    const std::vector<Action>& all() const { return actions_; }
    bool contains(std::string_view name) const;
    /// Throws std::invalid_argument when there is none of that name.
    int indexOf(std::string_view name) const;
    /// The bit of one action; throws as indexOf does.
    Buttons button(std::string_view name) const { return Buttons{1} << indexOf(name); }

private:
    std::vector<Action> actions_;
};

/// The game's actions, first and in their order, and those of the menus behind them: confirm, back, pause, left, right,
/// up, down. Where a game has one of that name, it is one and the same, and gets those of the menu's keys that the game
/// does not use for another.
ActionList withMenuActions(const std::vector<Action>& game);

}  // namespace plumb::games
