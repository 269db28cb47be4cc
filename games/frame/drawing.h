// SPDX-License-Identifier: MIT
// What does a picture consist of? It is a list of marks, in pixels, that any shell can paint.
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <games/frame/color.h>
#include <plumb/math/vec2.h>

namespace plumb::games {

struct PixelSize {
    int width = 1280, height = 720;
    friend bool operator==(const PixelSize&, const PixelSize&) = default;
};

/// An affine map: the point (x, y) goes to origin + x xAxis + y yAxis.
struct Affine {
    Vec2 xAxis{1, 0}, yAxis{0, 1};
    Vec2 origin{0, 0};

    Vec2 operator*(const Vec2& p) const { return origin + p.x() * xAxis + p.y() * yAxis; }
    Affine operator*(const Affine& inner) const {
        const auto turned = [this](const Vec2& v) -> Vec2 { return v.x() * xAxis + v.y() * yAxis; };
        return {turned(inner.xAxis), turned(inner.yAxis), *this * inner.origin};
    }
    friend bool operator==(const Affine&, const Affine&) = default;
};

/// A linear change from one colour to another, in the coordinates of the mark. Beyond each end, the colour of that end
/// goes on.
struct Gradient {
    Vec2 from{0, 0}, to{0, 1};  ///< in a radial gradient, from is the centre
    Color first, last;
    double radius = 0;  ///< > 0: a radial gradient, from the centre to this radius
    friend bool operator==(const Gradient&, const Gradient&) = default;
};

struct Paint {
    Color color;
    std::optional<Gradient> gradient = std::nullopt;  ///< instead of the colour

    Paint(const Color& plain = {}) : color(plain) {}
    static Paint linear(const Vec2& from, const Color& first, const Vec2& to, const Color& last);
    static Paint radial(const Vec2& center, const Color& inner, double radius, const Color& outer);

    friend bool operator==(const Paint&, const Paint&) = default;
};

/// How a mark is drawn: filled, or, with a width, along its outline with round ends and corners.
struct Brush {
    Paint paint;
    double width = 0;  ///< of the line, in the units of the mark; 0: filled

    Brush(const Color& color) : paint(color) {}
    Brush(const Paint& fill) : paint(fill) {}
    Brush(const Paint& line, double lineWidth) : paint(line), width(lineWidth) {}

    friend bool operator==(const Brush&, const Brush&) = default;
};
inline Brush stroke(const Paint& paint, double width) {
    return {paint, width};
}

enum class Align { Left, Center, Right };
enum class Baseline { Base, Top, Middle };  ///< of capital letters
enum class Weight { Regular, Bold, Heavy };

struct TextStyle {
    double size = 16;  ///< of the font, about 1.4 times the height of a capital letter, in the units of the mark
    Color color = {1, 1, 1, 1};
    Align align = Align::Left;
    Baseline baseline = Baseline::Base;
    Weight weight = Weight::Regular;
    double fitWidth = 0;  ///< > 0: the text is made smaller until it is no wider than this
    friend bool operator==(const TextStyle&, const TextStyle&) = default;
};

struct RectMark {
    Vec2 corner{0, 0}, size{1, 1};  ///< corner: the one with the smallest x and y
    double radius = 0;              ///< of the rounded corners
    friend bool operator==(const RectMark&, const RectMark&) = default;
};
/// An ellipse, or a part of it; angles from +x towards +y [rad].
struct EllipseMark {
    Vec2 center{0, 0}, radii{1, 1};
    double from = 0, to = 0;  ///< equal: the whole ellipse
    bool pie = false;         ///< true: a part is closed through the centre
    friend bool operator==(const EllipseMark&, const EllipseMark&) = default;
};
struct PathMark {
    std::vector<Vec2> points;
    bool closed = false;
    friend bool operator==(const PathMark&, const PathMark&) = default;
};
struct TextMark {
    Vec2 at{0, 0};
    std::string text;  ///< UTF-8, one line
    TextStyle style;   ///< drawn upright and not mirrored, whether y points up or down
    friend bool operator==(const TextMark&, const TextMark&) = default;
};

struct Mark {
    std::variant<RectMark, EllipseMark, PathMark, TextMark> shape;
    Brush brush;         ///< of a text: the colour of its style
    Affine toPixels;     ///< from the mark's coordinates; y down, (0, 0) at the window's upper left
    double opacity = 1;  ///< multiplied by alpha
    int layer = 0;
    int clip = -1;  ///< index of the clip that limits it; -1: none
    friend bool operator==(const Mark&, const Mark&) = default;
};

/// An axis-aligned rectangle in pixels; nothing is painted outside it.
struct Clip {
    Vec2 corner{0, 0}, size{0, 0};
    friend bool operator==(const Clip&, const Clip&) = default;
};

struct Drawing {
    PixelSize size;
    std::vector<Mark> marks;  ///< in the order they were made
    std::vector<Clip> clips;

    /// The marks in the order of painting: by layer, and within a layer in the order they were made.
    std::vector<const Mark*> inOrder() const;
};

}  // namespace plumb::games
