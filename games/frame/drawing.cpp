// SPDX-License-Identifier: MIT
#include <games/frame/drawing.h>

#include <algorithm>

namespace plumb::games {

Paint Paint::linear(const Vec2& from, const Color& first, const Vec2& to, const Color& last) {
    Paint paint(first);
    paint.gradient = Gradient{from, to, first, last};
    return paint;
}

Paint Paint::radial(const Vec2& center, const Color& inner, double radius, const Color& outer) {
    Paint paint(inner);
    paint.gradient = Gradient{center, center, inner, outer, radius};
    return paint;
}

std::vector<const Mark*> Drawing::inOrder() const {
    std::vector<const Mark*> order;
    order.reserve(marks.size());
    for (const Mark& mark : marks) order.push_back(&mark);
    std::stable_sort(order.begin(), order.end(), [](const Mark* a, const Mark* b) { return a->layer < b->layer; });
    return order;
}

}  // namespace plumb::games
