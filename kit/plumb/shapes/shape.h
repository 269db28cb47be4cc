// SPDX-License-Identifier: MIT
// Which outlines can a body have?
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <plumb/math/vec2.h>
#include <plumb/shapes/tile_map.h>

namespace plumb {

struct Circle {
    double radius = 0.5;  ///< > 0 [m]
    Vec2 center{0, 0};    ///< in the body's frame [m]
    friend bool operator==(const Circle&, const Circle&) = default;
};

/// All that is within radius of a line: a stadium.
struct Capsule {
    Vec2 start{-0.5, 0};  ///< in the body's frame [m]
    Vec2 end{0.5, 0};     ///< not equal to start [m]
    double radius = 0.5;  ///< > 0 [m]
    friend bool operator==(const Capsule&, const Capsule&) = default;
};

/// A convex polygon, counter-clockwise, 3 to maxPolygonVertices corners, no three of them in line: every edge longer
/// than 1e-6 of the whole, every turn's sine above 1e-6. With a radius it is rounded: its outline lies that far
/// outside of the corners and edges.
struct Polygon {
    std::vector<Vec2> vertices = {};  ///< in the body's frame [m]
    double radius = 0;                ///< >= 0 [m]
    friend bool operator==(const Polygon&, const Polygon&) = default;
};

/// A line from start to end, solid from both sides. Has no area, so no mass. Where the line goes on, before its start
/// or after its end, nothing catches on the joint: a body that slides across feels what the whole line's outline
/// allows. Whoever says where it goes on provides the segment that lies there, as a Chain does by itself.
struct Segment {
    Vec2 start{0, 0};                           ///< in the body's frame [m]
    Vec2 end{1, 0};                             ///< not equal to start [m]
    std::optional<Vec2> before = std::nullopt;  ///< the point the line comes from before start [m]
    std::optional<Vec2> after = std::nullopt;   ///< the point the line goes on to after end [m]
    friend bool operator==(const Segment&, const Segment&) = default;
};

/// A line through points, smooth to slide along and solid from both sides. Has no area, so no mass.
struct Chain {
    std::vector<Vec2> points = {};  ///< 2 or more, 3 or more if closed; no two in succession equal [m]
    bool closed = false;            ///< goes on from the last point to the first
    friend bool operator==(const Chain&, const Chain&) = default;
};

inline constexpr int maxPolygonVertices = 64;

/// A TileMap is one shape, for what does not move freely: it has no mass.
using Shape = std::variant<Circle, Capsule, Polygon, Segment, Chain, TileMap>;

/// An upright rectangle around center; halfSize is half its width and half its height. Throws std::invalid_argument
/// unless both are positive, and all is finite.
Polygon boxPolygon(const Vec2& halfSize, const Vec2& center = {0, 0});

/// Throws std::invalid_argument unless the shape is one a body can have; field names it in the message.
void validate(const Shape& shape, const std::string& field);

}  // namespace plumb
