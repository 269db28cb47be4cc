// SPDX-License-Identifier: MIT
// Can every text of a drawing be read?
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include <games/shell/cairo/painter.h>

namespace plumb::test {

/// One sentence for each text that reaches out of the window.
inline std::vector<std::string> textsCutOff(const games::Drawing& drawing, const games::Painter& painter) {
    std::vector<std::string> faults;
    const Aabb window{{0, 0}, {double(drawing.size.width), double(drawing.size.height)}};
    for (const games::Mark& mark : drawing.marks) {
        const auto* text = std::get_if<games::TextMark>(&mark.shape);
        if (text == nullptr) continue;
        const Aabb box = painter.boxOf(mark);
        if (!contains(window, box)) faults.push_back("\"" + text->text + "\" reaches out of the window");
    }
    return faults;
}

/// One sentence for each two texts that overlap, in this layer and all higher ones. A text may overlap its own shadow.
inline std::vector<std::string> textsOverlapping(const games::Drawing& drawing, const games::Painter& painter,
                                                 int layer) {
    std::vector<std::string> faults;
    std::vector<std::pair<std::string, Aabb>> seen;
    for (const games::Mark& mark : drawing.marks) {
        const auto* text = std::get_if<games::TextMark>(&mark.shape);
        if (text == nullptr || mark.layer < layer) continue;
        const Aabb box = painter.boxOf(mark);
        for (const auto& [other, otherBox] : seen)
            if (other != text->text && overlap(box, otherBox))
                faults.push_back("\"" + text->text + "\" lies over \"" + other + "\"");
        seen.emplace_back(text->text, box);
    }
    return faults;
}

/// The height of a text's font, made smaller where its width is limited [pixels].
inline double fontPixels(const games::Mark& mark, const games::TextMark& text, const games::Painter& painter) {
    const double scale = mark.toPixels.yAxis.norm(), size = text.style.size * scale;
    if (text.style.fitWidth <= 0) return size;
    games::Mark free = mark;
    std::get<games::TextMark>(free.shape).style.fitWidth = 0;
    const Aabb box = painter.boxOf(free);
    return size * std::min(1.0, text.style.fitWidth * scale / (box.upper.x() - box.lower.x()));
}

/// One sentence for each text that is smaller than this, in this layer and all higher ones.
inline std::vector<std::string> textsBelow(const games::Drawing& drawing, const games::Painter& painter, int layer,
                                           double pixels) {
    std::vector<std::string> faults;
    for (const games::Mark& mark : drawing.marks) {
        const auto* text = std::get_if<games::TextMark>(&mark.shape);
        if (text == nullptr || mark.layer < layer) continue;
        const double size = fontPixels(mark, *text, painter);
        if (size < pixels) faults.push_back("\"" + text->text + "\" has " + std::to_string(size) + " pixels");
    }
    return faults;
}

}  // namespace plumb::test
