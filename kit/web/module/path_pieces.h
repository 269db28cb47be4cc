// SPDX-License-Identifier: MIT
// How does a path come from JavaScript? As the calls that made it.
#pragma once
#include <variant>
#include <vector>

#include <plumb/math/member.h>
#include <plumb/movers/path_shape.h>

namespace plumb {

// These stand in the kit's namespace for their names in JavaScript.

struct LineTo {
    Vec2 end{0, 0};  ///< [m]
};
struct ArcAround {
    Vec2 center{0, 0};  ///< [m]
    double angle = 0;   ///< counter-clockwise [rad]
};
struct CurveTo {
    Vec2 first{0, 0}, second{0, 0};  ///< the control points [m]
    Vec2 end{0, 0};                  ///< [m]
};
struct SplineThrough {
    std::vector<Vec2> points = {};  ///< after the start [m]
    bool closed = false;            ///< does it return to the start?
};
struct CloseLine {};

using PathPiece = std::variant<LineTo, ArcAround, CurveTo, SplineThrough, CloseLine>;

template <>
inline constexpr DefinitionName definitionName<LineTo>{"LineTo", "lineTo"};
template <>
inline constexpr DefinitionName definitionName<ArcAround>{"ArcAround", "arcAround"};
template <>
inline constexpr DefinitionName definitionName<CurveTo>{"CurveTo", "curveTo"};
template <>
inline constexpr DefinitionName definitionName<SplineThrough>{"SplineThrough", "splineThrough"};
template <>
inline constexpr DefinitionName definitionName<CloseLine>{"CloseLine", "close"};

/// A path as JavaScript gives it: where it starts, and its pieces, each from where the one before ended. A spline is
/// the only piece.
struct PathPieces {
    Vec2 start{0, 0};  ///< [m]
    std::vector<PathPiece> pieces = {};
};

namespace web {

/// Throws std::invalid_argument as MotionPath does.
MotionPath pathOf(const PathPieces& pieces);

}  // namespace web
}  // namespace plumb
