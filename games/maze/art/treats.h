// SPDX-License-Identifier: MIT
// How are crumbs, cheese and treats drawn?
#pragma once
#include <games/frame/canvas.h>

namespace plumb::games::maze {

void drawCrumb(Canvas& canvas, const Vec2& at);
/// pulse 0 to 1: how much it glows.
void drawCheese(Canvas& canvas, const Vec2& at, double pulse);
/// Kind 0 to 7, as in the kit's ArcadeFruit: a blueberry, a hazelnut, a mushroom, a pear, a pot of honey, a cake, a
/// fish bone that the cats left, a golden bell. About 1.5 high round (0, 0).
void drawFruit(Canvas& canvas, int kind);

}  // namespace plumb::games::maze
