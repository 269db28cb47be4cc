// SPDX-License-Identifier: MIT
#include <games/frame/action.h>

#include <algorithm>
#include <array>

#include <plumb/math/check.h>

namespace plumb::games {
namespace {

constexpr std::array keyNames = {
    "←", "→", "↑", "↓", "Space", "Enter", "Escape", "Tab", "Backspace", "Shift", "Ctrl", "-", "+", ",", ".", "A", "B",
    "C", "D", "E", "F", "G",     "H",     "I",      "J",   "K",         "L",     "M",    "N", "O", "P", "Q", "R", "S",
    "T", "U", "V", "W", "X",     "Y",     "Z",      "0",   "1",         "2",     "3",    "4", "5", "6", "7", "8", "9"};
static_assert(keyNames.size() == static_cast<std::size_t>(Key::Digit9) + 1);

constexpr std::array padNames = {"Left",  "Right", "Up", "Down", "South", "East",  "West",
                                 "North", "LB",    "RB", "LT",   "RT",    "Start", "Back"};
static_assert(padNames.size() == static_cast<std::size_t>(Pad::Back) + 1);

bool isNameLetter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
}

// In a record, a single - means no action.
bool isName(const std::string& name) {
    return !name.empty() && name != "-" && std::all_of(name.begin(), name.end(), isNameLetter);
}

const std::vector<Action>& menuActions() {
    static const std::vector<Action> actions = {
        {"confirm", {Key::Enter, Key::Space}, {Pad::South}},
        {"back", {Key::Escape, Key::Backspace}, {Pad::East, Pad::Back}},
        {"pause", {Key::Escape, Key::P}, {Pad::Start}},
        {"left", {Key::Left}, {Pad::Left}},
        {"right", {Key::Right}, {Pad::Right}},
        {"up", {Key::Up}, {Pad::Up}},
        {"down", {Key::Down}, {Pad::Down}},
    };
    return actions;
}

template <class Button>
bool has(const std::vector<Button>& buttons, Button wanted) {
    return std::find(buttons.begin(), buttons.end(), wanted) != buttons.end();
}

/// Adds those buttons of a menu action that no action of the game uses.
template <class Button>
void addFree(std::vector<Button>& to, const std::vector<Button>& from, const std::vector<Action>& game,
             std::vector<Button> Action::*which) {
    for (const Button button : from) {
        const auto uses = [&](const Action& action) { return has(action.*which, button); };
        if (!has(to, button) && std::none_of(game.begin(), game.end(), uses)) to.push_back(button);
    }
}

}  // namespace

std::string_view nameOf(Key key) {
    return keyNames[static_cast<std::size_t>(key)];
}

std::string_view nameOf(Pad pad) {
    return padNames[static_cast<std::size_t>(pad)];
}

ActionList::ActionList(std::vector<Action> actions) : actions_(std::move(actions)) {
    if (size() > maxActions)
        refuse("actions", std::to_string(size()) + " actions, including those of the menus; at most " +
                              std::to_string(maxActions) + " are allowed");
    for (auto action = actions_.begin(); action != actions_.end(); ++action) {
        if (!isName(action->name))
            refuse("Action.name", "\"" + action->name + "\" is not made of letters, digits, - and _");
        const auto same = [&](const Action& other) { return other.name == action->name; };
        if (std::any_of(actions_.begin(), action, same))
            refuse("Action.name", "\"" + action->name + "\" is used twice");
    }
}

bool ActionList::contains(std::string_view name) const {
    return std::any_of(actions_.begin(), actions_.end(), [&](const Action& action) { return action.name == name; });
}

int ActionList::indexOf(std::string_view name) const {
    for (int i = 0; i < size(); ++i)
        if ((*this)[i].name == name) return i;
    refuse("action", "there is no action \"" + std::string(name) + "\"");
}

ActionList withMenuActions(const std::vector<Action>& game) {
    std::vector<Action> all = game;
    for (const Action& menu : menuActions()) {
        const auto same = [&](const Action& action) { return action.name == menu.name; };
        const auto shared = std::find_if(all.begin(), all.end(), same);
        if (shared == all.end()) {
            all.push_back(menu);
            continue;
        }
        addFree(shared->keys, menu.keys, game, &Action::keys);
        addFree(shared->pads, menu.pads, game, &Action::pads);
    }
    return ActionList(std::move(all));
}

}  // namespace plumb::games
