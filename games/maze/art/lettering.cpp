// SPDX-License-Identifier: MIT
#include <games/maze/art/lettering.h>

#include <games/maze/art/palette.h>

namespace plumb::games::maze {

void drawLettering(Canvas& canvas, const std::string& text, const Vec2& at, const Color& color, double size) {
    TextStyle style{.size = size,
                    .color = night.faded(color.alpha),
                    .align = Align::Center,
                    .baseline = Baseline::Middle,
                    .weight = Weight::Heavy};
    const double edge = 0.07 * size;
    for (const double x : {-edge, edge})
        for (const double y : {-edge, edge}) canvas.text(at + Vec2(x, y), text, style);
    style.color = color;
    canvas.text(at, text, style);
}

}  // namespace plumb::games::maze
