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

/// A scene's joint with its names looked up, and its anchors and axis taken into the bodies' frames.
struct JointGeometry {
    JointDef def;
    std::size_t bodyA = noBody,
                bodyB = noBody;          ///< indices of the scene's bodies; a gear has none, a target bodyB only
    std::size_t jointA = 0, jointB = 0;  ///< of a gear: indices of the scene's joints
    Vec2 localAnchorA{0, 0};             ///< in bodyA's frame; a target's is where it is to go [m]
    Vec2 localAnchorB{0, 0};             ///< in bodyB's frame [m]
    Vec2 localAxis{1, 0};                ///< of a slide or a wheel, in bodyA's frame, a unit vector [-]
    std::optional<double> length = {};   ///< of a rod or spring; of a pulley, lengthA + ratio lengthB; none else [m]
    bool collideConnected = false;
};

/// In the scene's order. Throws std::invalid_argument for a joint to a body or joint that is not there.
std::vector<JointGeometry> jointGeometries(const Scene& scene);

/// The places of the bodies that a joint holds; of a gear, those of the two joints that it couples.
std::vector<std::size_t> bodiesOf(const std::vector<JointGeometry>& joints, std::size_t joint);

/// The spring of a target: its own, or 5 Hz of the body's mass at a damping ratio of 0.7.
Spring springOf(const TargetJointDef& def, const BodyDef& body);

/// What a joint bears before it breaks; nothing breaks a filter.
Breaking breakingOf(const JointDef& def);

/// Index of the body with this name. Throws std::invalid_argument when there is none.
std::size_t bodyIndex(const Scene& scene, const std::string& name);

/// Index of the joint with this name. Throws std::invalid_argument when there is none.
std::size_t jointIndex(const Scene& scene, const std::string& name);

/// Where a body stands at the start.
Transform startPose(const BodyDef& def);

}  // namespace plumb::compare
