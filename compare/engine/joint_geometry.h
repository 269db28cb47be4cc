// SPDX-License-Identifier: MIT
// Where do a scene's joints hold its bodies?
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <compare/scene/scene.h>
#include <plumb/math/transform.h>

namespace plumb::compare {

/// A scene's joint with its names looked up and its anchors taken into the bodies' frames.
struct JointGeometry {
    std::size_t bodyA, bodyB;         ///< indices of the scene's bodies
    Vec2 localAnchorA, localAnchorB;  ///< in the bodies' frames [m]
    std::optional<double> length;     ///< of a rod; a hinge has none [m]
    double motorSpeed;                ///< of a hinge's motor, of B against A [rad/s]
    double maxMotorTorque;            ///< 0: no motor; infinite for as much as it takes [N m]
    bool collideConnected;
};

/// In the scene's order. Throws std::invalid_argument for a joint to a body that is not there.
std::vector<JointGeometry> jointGeometries(const Scene& scene);

/// Index of the body with this name. Throws std::invalid_argument when there is none.
std::size_t bodyIndex(const Scene& scene, const std::string& name);

/// Index of the joint with this name. Throws std::invalid_argument when there is none.
std::size_t jointIndex(const Scene& scene, const std::string& name);

/// Where a body stands at the start.
Transform startPose(const BodyDef& def);

}  // namespace plumb::compare
