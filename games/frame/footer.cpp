// SPDX-License-Identifier: MIT
#include <games/frame/footer.h>

#include <cmath>

#include <games/frame/canvas.h>

namespace plumb::games {

void drawFooter(Canvas& canvas, const std::vector<FooterLine>& lines, const Theme& theme) {
    if (lines.empty()) return;
    constexpr double lineHeight = 14, margin = 2, side = 8, gap = 6;  // in units of the screen
    canvas.layer(footerLayer);
    canvas.screen();
    const Aabb window = canvas.visible();
    const double height = lineHeight * static_cast<double>(lines.size()) + 2 * margin, pixel = canvas.unitsPerPixel();
    const int rows = static_cast<int>(std::ceil(height / pixel));
    const double top = window.upper.y() - rows * pixel;
    canvas.rect({window.lower.x(), top}, {window.upper.x() - window.lower.x(), rows * pixel}, theme.background);
    double y = top + margin + lineHeight / 2;
    for (const FooterLine& line : lines) {
        const double width = (screenWidth - 2 * side) / static_cast<double>(line.size());
        for (std::size_t i = 0; i < line.size(); ++i)
            canvas.text({side + width * static_cast<double>(i), y}, line[i],
                        {.size = 10, .color = theme.text, .baseline = Baseline::Middle, .fitWidth = width - gap});
        y += lineHeight;
    }
    canvas.layer(0);
    canvas.keepFree(rows);
}

}  // namespace plumb::games
