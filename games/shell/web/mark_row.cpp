// SPDX-License-Identifier: MIT
#include <games/shell/web/mark_row.h>

namespace plumb::games {
namespace {

enum ShapeKind { Rect, Ellipse, Path, Text };

class Writer {
public:
    explicit Writer(MarkRow& row) : row_(row) {}

    void put(const Mark& mark, const Drawing& drawing) {
        put(mark.toPixels.xAxis), put(mark.toPixels.yAxis), put(mark.toPixels.origin);
        put(mark.opacity, mark.brush.width, mark.clip);
        if (mark.clip >= 0) {
            const Clip& clip = drawing.clips[static_cast<std::size_t>(mark.clip)];
            put(clip.corner), put(clip.size);
        }
        put(mark.brush.paint);
        std::visit([this](const auto& shape) { put(shape); }, mark.shape);
    }

private:
    template <class... Numbers>
    requires(std::is_arithmetic_v<Numbers>&&...) void put(Numbers... numbers) {
        (row_.numbers.push_back(static_cast<double>(numbers)), ...);
    }
    void put(const Vec2& v) { put(v.x(), v.y()); }
    void put(const Color& c) { put(c.red, c.green, c.blue, c.alpha); }
    void put(const Paint& paint) {
        put(paint.gradient.has_value());
        if (!paint.gradient) return put(paint.color);
        const Gradient& g = *paint.gradient;
        put(g.from), put(g.to), put(g.radius), put(g.first), put(g.last);
    }
    void put(const RectMark& rect) { put(Rect), put(rect.corner), put(rect.size), put(rect.radius); }
    void put(const EllipseMark& ellipse) {
        put(Ellipse), put(ellipse.center), put(ellipse.radii), put(ellipse.from, ellipse.to, ellipse.pie);
    }
    void put(const PathMark& path) {
        put(Path), put(path.closed, path.points.size());
        for (const Vec2& point : path.points) put(point);
    }
    void put(const TextMark& text) {
        const TextStyle& style = text.style;
        put(Text), put(text.at), put(row_.text.size(), text.text.size()), put(style.size, style.fitWidth);
        put(static_cast<int>(style.align), static_cast<int>(style.baseline), static_cast<int>(style.weight));
        row_.text += text.text;
    }
    void put(ShapeKind kind) { put(static_cast<int>(kind)); }

    MarkRow& row_;
};

}  // namespace

void writeMarks(const Drawing& drawing, MarkRow& row) {
    row.numbers.clear();
    row.text.clear();
    Writer writer(row);
    for (const Mark* mark : drawing.inOrder()) writer.put(*mark, drawing);
}

}  // namespace plumb::games
