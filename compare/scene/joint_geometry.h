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

inline constexpr std::size_t noBody = static_cast<std::size_t>(-1);

/// A scene's joint with indices instead of names, and with its anchors and its axis in the bodies' frames.
struct JointGeometry {
    JointDef def;
    std::size_t bodyA = noBody,
                bodyB = noBody;          ///< indices of the scene's bodies; a gear has none, a target bodyB only
    std::size_t jointA = 0, jointB = 0;  ///< of a gear: indices of the scene's joints
    Vec2 localAnchorA{0, 0};             ///< in bodyA's frame; for a target, the point to go to [m]
    Vec2 localAnchorB{0, 0};             ///< in bodyB's frame [m]
    Vec2 localAxis{1, 0};                ///< of a slide or a wheel: a unit vector in bodyA's frame [-]
    std::optional<double> length = {};   ///< of a rod or spring; for a pulley, lengthA + ratio lengthB; else empty [m]
    bool collideConnected = false;
};

/// The geometries in the scene's order. Throws std::invalid_argument for a joint whose body or joint does not exist.
std::vector<JointGeometry> jointGeometries(const Scene& scene);

/// The indices of the bodies that a joint holds; for a gear, the bodies of the two joints that it couples.
std::vector<std::size_t> bodiesOf(const std::vector<JointGeometry>& joints, std::size_t joint);

/// The spring of a target: its own, or 5 Hz for the body's mass with a damping ratio of 0.7.
Spring springOf(const TargetJointDef& def, const BodyDef& body);

/// The load at which a joint breaks. A filter never breaks.
Breaking breakingOf(const JointDef& def);

/// Index of the body with this name. Throws std::invalid_argument if there is none.
std::size_t bodyIndex(const Scene& scene, const std::string& name);

/// Index of the joint with this name. Throws std::invalid_argument if there is none.
std::size_t jointIndex(const Scene& scene, const std::string& name);

/// The pose of a body at the start.
Transform startPose(const BodyDef& def);

}  // namespace plumb::compare
