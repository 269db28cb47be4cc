// SPDX-License-Identifier: MIT
// Which outlines can a body have?
#pragma once
#include <span>
#include <string>
#include <variant>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb {

struct Circle {
    double radius = 0.5;  ///< > 0 [m]
    Vec2 center{0, 0};    ///< in the body's frame [m]
};

/// A convex polygon, counter-clockwise, 3 to maxPolygonVertices corners, no three of them in line: every edge longer
/// than 1e-6 of the whole, every turn's sine above 1e-6.
struct Polygon {
    std::vector<Vec2> vertices = {};  ///< in the body's frame [m]
};

/// A line from start to end, solid from both sides. Has no area, so no mass.
struct Segment {
    Vec2 start{0, 0};  ///< in the body's frame [m]
    Vec2 end{1, 0};    ///< not equal to start [m]
};

inline constexpr int maxPolygonVertices = 8;

using Shape = std::variant<Circle, Polygon, Segment>;

/// An upright rectangle around center; halfSize is half its width and half its height. Throws std::invalid_argument
/// unless both are positive.
Polygon boxPolygon(const Vec2& halfSize, const Vec2& center = {0, 0});

/// Throws std::invalid_argument unless the shape is one a body can have; field names it in the message.
void validate(const Shape& shape, const std::string& field);

}  // namespace plumb
