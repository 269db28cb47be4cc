// SPDX-License-Identifier: MIT
// What can be chosen, and what is chosen now?
#pragma once
#include <map>
#include <string>
#include <vector>

#include <games/frame/canvas.h>
#include <games/frame/game.h>

namespace plumb::games {

struct MenuEntry {
    std::string label;
    std::string value{};  ///< what left and right change; empty: nothing
};

/// A list of entries. Up and down move through it; after the last entry comes the first.
class Menu {
public:
    explicit Menu(std::vector<MenuEntry> entries = {}) : entries_(std::move(entries)) {}

    enum class Event { None, Moved, Left, Right, Confirmed };
    Event update(const Input& input);

    int chosen() const { return chosen_; }
    int size() const { return static_cast<int>(entries_.size()); }
    MenuEntry& entry(int index) { return entries_[static_cast<std::size_t>(index)]; }

    /// top: the middle of the first line, in units of the screen. The other lines follow below.
    void draw(Canvas& canvas, const Vec2& top, const Theme& theme) const;
    /// The entry that draw() puts at a point; -1: none.
    int entryAt(const Vec2& point, const Vec2& top) const;
    static constexpr double lineHeight = 26;  ///< [units of the screen]
    static constexpr double halfWidth = 110;  ///< of an entry [units of the screen]

private:
    std::vector<MenuEntry> entries_;
    int chosen_ = 0;
};

/// The values of all options: the given ones, and the defaults of GameInfo for the others. Throws std::invalid_argument
/// on an unknown option, or on a value that is not one of the option's choices.
std::map<std::string, std::string> optionsOf(const GameInfo& info, const std::map<std::string, std::string>& given);

/// The options in the title, in their order: those with choices, except the ones that only the command line has.
std::vector<Option> optionsToChoose(const GameInfo& info);

/// The choice this number of steps after now; the first choice follows the last.
const std::string& choiceBehind(const Option& option, const std::string& now, int steps);

}  // namespace plumb::games
