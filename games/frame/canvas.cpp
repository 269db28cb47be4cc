// SPDX-License-Identifier: MIT
#include <games/frame/canvas.h>

#include <algorithm>
#include <utility>

#include <plumb/math/check.h>
#include <plumb/math/rot.h>

namespace plumb::games {
namespace {

Affine affineOf(const Place& place) {
    const Rot turn = Rot::fromAngle(place.angle);
    return {turn * Vec2(place.scale.x(), 0), turn * Vec2(0, place.scale.y()), place.position};
}

Aabb around(const Affine& toPixels, const Vec2& corner, const Vec2& size) {
    const Vec2 first = toPixels * corner;
    Aabb box{first, first};
    for (const Vec2& other : {Vec2(size.x(), 0), Vec2(0, size.y()), size}) {
        const Vec2 p = toPixels * Vec2(corner + other);
        box = {box.lower.cwiseMin(p), box.upper.cwiseMax(p)};
    }
    return box;
}

Aabb common(const Aabb& a, const Aabb& b) {
    const Vec2 lower = a.lower.cwiseMax(b.lower);
    return {lower, a.upper.cwiseMin(b.upper).cwiseMax(lower)};
}

}  // namespace

Canvas::Canvas(PixelSize size, double between) : between_(between) {
    if (size.width < 1 || size.height < 1)
        refuse("PixelSize",
               std::to_string(size.width) + " x " + std::to_string(size.height) + " is not at least 1 x 1");
    drawing_.size = picture_ = size;
    screen();
}

void Canvas::keepFree(int rows) {
    picture_.height = std::max(1, drawing_.size.height - rows);
    screen();
}

void Canvas::look(const Camera& camera) {
    const Affine view = toPixels(camera, picture_);
    state_ = {view, view};
    camera_ = camera;
}

void Canvas::screen() {
    const Affine view = screenToPixels(picture_);
    state_ = {view, view};
}

Aabb Canvas::visible() const {
    return visibleIn(state_.view, picture_);
}

double Canvas::unitsPerPixel() const {
    return 1 / state_.view.xAxis.x();
}

Canvas::Scope Canvas::place(const Place& place) {
    const State before = state_;
    state_.toPixels = state_.toPixels * affineOf(place);
    state_.opacity *= place.opacity;
    return Scope(*this, before);
}

Canvas::Scope Canvas::clip(const Vec2& corner, const Vec2& size) {
    const State before = state_;
    Aabb box = around(state_.toPixels, corner, size);
    if (state_.clip >= 0) {
        const Clip& outer = drawing_.clips[static_cast<std::size_t>(state_.clip)];
        box = common(box, {outer.corner, outer.corner + outer.size});
    }
    state_.clip = static_cast<int>(drawing_.clips.size());
    drawing_.clips.push_back({box.lower, box.upper - box.lower});
    return Scope(*this, before);
}

void Canvas::add(decltype(Mark::shape) shape, const Brush& brush) {
    drawing_.marks.push_back({std::move(shape), brush, state_.toPixels, state_.opacity, layer_, state_.clip});
}

void Canvas::clear(const Paint& paint) {
    const Aabb all = visibleIn(state_.view, size());
    drawing_.marks.push_back({RectMark{all.lower, all.upper - all.lower}, paint, state_.view, 1, layer_, -1});
}

void Canvas::rect(const Vec2& corner, const Vec2& size, const Brush& brush, double radius) {
    add(RectMark{corner, size, radius}, brush);
}

void Canvas::box(const Vec2& center, const Vec2& halfSize, const Brush& brush, double radius) {
    rect(center - halfSize, 2 * halfSize, brush, radius);
}

void Canvas::circle(const Vec2& center, double radius, const Brush& brush) {
    ellipse(center, {radius, radius}, brush);
}

void Canvas::ellipse(const Vec2& center, const Vec2& radii, const Brush& brush) {
    add(EllipseMark{center, radii}, brush);
}

void Canvas::pie(const Vec2& center, double radius, double from, double to, const Brush& brush) {
    if (from != to) add(EllipseMark{center, {radius, radius}, from, to, true}, brush);
}

void Canvas::arc(const Vec2& center, double radius, double from, double to, const Brush& brush) {
    if (from != to) add(EllipseMark{center, {radius, radius}, from, to, false}, brush);
}

void Canvas::polygon(std::vector<Vec2> corners, const Brush& brush) {
    if (!corners.empty()) add(PathMark{std::move(corners), true}, brush);
}

void Canvas::polyline(std::vector<Vec2> points, const Paint& paint, double width) {
    if (!points.empty()) add(PathMark{std::move(points), false}, stroke(paint, width));
}

void Canvas::line(const Vec2& from, const Vec2& to, const Paint& paint, double width) {
    add(PathMark{{from, to}, false}, stroke(paint, width));
}

void Canvas::capsule(const Vec2& start, const Vec2& end, double radius, const Paint& paint) {
    line(start, end, paint, 2 * radius);
}

void Canvas::text(const Vec2& at, std::string text, const TextStyle& style) {
    if (!text.empty()) add(TextMark{at, std::move(text), style}, style.color);
}

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
