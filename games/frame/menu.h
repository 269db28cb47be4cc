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

}  // namespace plumb::games
