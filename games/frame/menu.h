// SPDX-License-Identifier: MIT
// What can be chosen, and what is chosen now?
#pragma once
#include <string>
#include <vector>

#include <games/frame/canvas.h>
#include <games/frame/game.h>

namespace plumb::games {

struct MenuEntry {
    std::string label;
    std::string value{};  ///< what left and right change; empty: nothing
};

/// A list that up and down go through, round and round.
class Menu {
public:
    explicit Menu(std::vector<MenuEntry> entries = {}) : entries_(std::move(entries)) {}

    enum class Event { None, Moved, Left, Right, Confirmed };
    Event update(const Input& input);

    int chosen() const { return chosen_; }
    int size() const { return static_cast<int>(entries_.size()); }
    MenuEntry& entry(int index) { return entries_[static_cast<std::size_t>(index)]; }

    /// The middle of its first line at a place of the screen, the lines below.
    void draw(Canvas& canvas, const Vec2& top, const Theme& theme) const;
    /// The entry that draw() puts at a point, -1: none.
    int entryAt(const Vec2& point, const Vec2& top) const;
    static constexpr double lineHeight = 26;  ///< of the screen's units
    static constexpr double halfWidth = 110;  ///< of an entry, likewise

private:
    std::vector<MenuEntry> entries_;
    int chosen_ = 0;
};

}  // namespace plumb::games
