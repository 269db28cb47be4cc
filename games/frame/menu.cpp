// SPDX-License-Identifier: MIT
#include <games/frame/menu.h>

#include <cmath>

namespace plumb::games {

Menu::Event Menu::update(const Input& input) {
    const int step = int{input.pressed("down")} - int{input.pressed("up")};
    if (step != 0 && size() > 1) {
        chosen_ = (chosen_ + step + size()) % size();
        return Event::Moved;
    }
    if (input.pressed("confirm")) return Event::Confirmed;
    if (size() == 0 || entry(chosen_).value.empty()) return Event::None;
    if (input.pressed("left")) return Event::Left;
    return input.pressed("right") ? Event::Right : Event::None;
}

void Menu::draw(Canvas& canvas, const Vec2& top, const Theme& theme) const {
    for (int i = 0; i < size(); ++i) {
        const MenuEntry& entry = entries_[static_cast<std::size_t>(i)];
        const Vec2 at = top + Vec2(0, i * lineHeight);
        const bool chosen = i == chosen_;
        if (chosen) canvas.box(at, {halfWidth, lineHeight / 2 - 1}, theme.accent, lineHeight / 2 - 1);
        TextStyle style{.size = 15,
                        .color = chosen ? theme.background : theme.text,
                        .align = Align::Center,
                        .baseline = Baseline::Middle,
                        .weight = Weight::Bold,
                        .fitWidth = 190};
        canvas.text(at, entry.value.empty() ? entry.label : entry.label + ":  ‹ " + entry.value + " ›", style);
    }
}

int Menu::entryAt(const Vec2& point, const Vec2& top) const {
    const double line = std::round((point.y() - top.y()) / lineHeight);
    const bool inside = std::abs(point.x() - top.x()) <= halfWidth && line >= 0 && line < size();
    return inside ? static_cast<int>(line) : -1;
}

}  // namespace plumb::games
