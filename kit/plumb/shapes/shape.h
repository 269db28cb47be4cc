// SPDX-License-Identifier: MIT
// Which shapes can a body have?
#pragma once
#include <concepts>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <plumb/math/overload.h>
#include <plumb/math/vec2.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

struct ShapeDef;  // an outline with a material, in space/shape_def.h: who writes the outline alone is told

struct Circle {
    double radius = 0.5;  ///< > 0 [m]
    Vec2 center{0, 0};    ///< in the body's frame [m]
    friend bool operator==(const Circle&, const Circle&) = default;
    template <std::same_as<ShapeDef> Def>
    operator Def() const {
        static_assert(detail::never<Def>, "a Circle is a shape's outline: write plumb::circle(radius)");
    }
};

/// All points within radius of a line segment (a stadium).
struct Capsule {
    Vec2 start{-0.5, 0};  ///< in the body's frame [m]
    Vec2 end{0.5, 0};     ///< not equal to start [m]
    double radius = 0.5;  ///< > 0 [m]
    friend bool operator==(const Capsule&, const Capsule&) = default;
    template <std::same_as<ShapeDef> Def>
    operator Def() const {
        static_assert(detail::never<Def>, "a Capsule is a shape's outline: write plumb::capsule(start, end, radius)");
    }
};

/// A convex polygon, counter-clockwise, 3 to maxPolygonVertices corners, no three of them collinear: every edge longer
/// than 1e-6 of the polygon's size, the sine of every turn above 1e-6. With a radius it is rounded: its outline is
/// offset outwards by the radius.
struct Polygon {
    std::vector<Vec2> vertices = {};  ///< in the body's frame [m]
    double radius = 0;                ///< >= 0 [m]
    friend bool operator==(const Polygon&, const Polygon&) = default;
    template <std::same_as<ShapeDef> Def>
    operator Def() const {
        static_assert(detail::never<Def>, "a Polygon is a shape's outline: write plumb::polygon(vertices)");
    }
};

/// A line from start to end, solid from both sides. It has no area, so no mass. With neighbours (ghost vertices) before
/// its start or after its end, bodies slide over the common vertex without catching: contacts are those of the whole
/// line's outline. The neighbouring segments have to exist as shapes of their own; a Chain creates them.
struct Segment {
    Vec2 start{0, 0};                           ///< in the body's frame [m]
    Vec2 end{1, 0};                             ///< not equal to start [m]
    std::optional<Vec2> before = std::nullopt;  ///< the start of the segment before this one [m]
    std::optional<Vec2> after = std::nullopt;   ///< the end of the segment after this one [m]
    friend bool operator==(const Segment&, const Segment&) = default;
    template <std::same_as<ShapeDef> Def>
    operator Def() const {
        static_assert(detail::never<Def>, "a Segment is a shape's outline: write plumb::segment(start, end)");
    }
};

/// A polyline, solid from both sides, without catching at its vertices. It has no area, so no mass.
struct Chain {
    std::vector<Vec2> points = {};  ///< 2 or more, 3 or more if closed; no two in succession equal [m]
    bool closed = false;            ///< the last point is connected to the first
    friend bool operator==(const Chain&, const Chain&) = default;
    template <std::same_as<ShapeDef> Def>
    operator Def() const {
        static_assert(detail::never<Def>, "a Chain is a shape's outline: write plumb::chain(points)");
    }
};

inline constexpr int maxPolygonVertices = 64;

/// A TileMap is one shape, for bodies that are not dynamic: it has no mass.
using Shape = std::variant<Circle, Capsule, Polygon, Segment, Chain, TileMap>;

/// An axis-aligned rectangle around center; halfSize is half its width and half its height. Throws
/// std::invalid_argument unless both are positive, and all numbers finite.
Polygon boxPolygon(const Vec2& halfSize, const Vec2& center = {0, 0});

/// Throws std::invalid_argument unless the shape is valid for a body; field is its name in the message.
void validate(const Shape& shape, const std::string& field);
template <detail::AlternativeOf<Shape> Alternative>
void validate(const Alternative& shape, const std::string& field) {
    validate(Shape(shape), field);
}

}  // namespace plumb
