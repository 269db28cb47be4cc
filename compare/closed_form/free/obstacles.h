// SPDX-License-Identifier: MIT
// Which flat faces and round corners can flying bodies of a scene hit?
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// What the laws of contact need to know about a surface.
struct Surface {
    std::size_t body = 0;           ///< index in the scene
    std::size_t shape = 0;          ///< index among the body's shapes
    const ShapeDef* def = nullptr;  ///< in the scene
};

/// A flat face of a static or kinematic body, as it is at t = 0.
struct Face {
    Surface surface;
    Vec2 normal{0, 1};    ///< outward [-]
    double offset = 0;    ///< distance of its line from the origin along the normal, with its radius [m]
    double low = 0;       ///< its start along tangentOf(normal) [m]
    double high = 0;      ///< its end along tangentOf(normal) [m]
    Vec2 velocity{0, 0};  ///< of a kinematic body [m/s]
    bool turns = false;   ///< its body turns, or a mover moves it
};

/// A corner, rounded or not, or a disc, on a static or kinematic body, as it is at t = 0.
struct Corner {
    Surface surface;
    Vec2 position{0, 0};  ///< [m]
    double radius = 0;    ///< [m]
    Vec2 velocity{0, 0};  ///< [m/s]
    bool turns = false;
};

struct Obstacles {
    std::vector<Face> faces;
    std::vector<Corner> corners;
};

/// The direction along a face, clockwise round its body: to +x on a top.
Vec2 tangentOf(const Vec2& normal);

/// Do the filters allow the two to touch? Sensors touch nothing.
bool mayTouch(const ShapeDef& a, const ShapeDef& b);
/// May any two of their shapes touch? Both bodies must be enabled.
bool mayTouch(const BodyDef& a, const BodyDef& b);

/// The faces and corners of all bodies that are not dynamic and may touch the body. Faces of one shape in one line are
/// joined. Throws Unsupported for tiles that do not fill their cells.
Obstacles obstaclesOf(const Scene& scene, const BodyDef& body);

}  // namespace plumb::compare
