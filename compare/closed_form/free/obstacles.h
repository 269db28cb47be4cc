// SPDX-License-Identifier: MIT
// What flat faces and round corners does a scene hold out to what flies in it?
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// What two surfaces need to know of each other.
struct Surface {
    std::size_t body = 0;           ///< index in the scene
    std::size_t shape = 0;          ///< of the body's
    const ShapeDef* def = nullptr;  ///< in the scene
};

/// A flat face of a static or kinematic body, as it is at t = 0.
struct Face {
    Surface surface;
    Vec2 normal{0, 1};    ///< outward [-]
    double offset = 0;    ///< of its line from the origin along the normal, its radius counted in [m]
    double low = 0;       ///< from where along tangentOf(normal) [m]
    double high = 0;      ///< to where [m]
    Vec2 velocity{0, 0};  ///< of a kinematic body [m/s]
    bool turns = false;   ///< it does not stay as it is: a mover moves its body, or it turns
};

/// A corner, rounded or not, or a disc, of a static or kinematic body, as it is at t = 0.
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

/// Along a face, clockwise round its body: to +x on a top.
Vec2 tangentOf(const Vec2& normal);

/// May the two touch, by their filters? Sensors touch nothing.
bool mayTouch(const ShapeDef& a, const ShapeDef& b);
/// Any two of their shapes, both enabled.
bool mayTouch(const BodyDef& a, const BodyDef& b);

/// Of all bodies that are not dynamic and may touch the body. Faces of one shape that lie in a line are one. Throws
/// Unsupported on tiles that do not fill their cells.
Obstacles obstaclesOf(const Scene& scene, const BodyDef& body);

}  // namespace plumb::compare
