// SPDX-License-Identifier: MIT
// How is a scene's joint made in Box2D 2.4? Only for sources that are compiled against Box2D 2.4's headers.
#pragma once
#include <box2d/box2d.h>

#include <span>
#include <string>

#include <compare/scene/joint_geometry.h>

namespace plumb::compare {

/// What already exists when a joint is made.
struct Built24 {
    b2World& world;
    const Scene& scene;
    std::span<b2Body* const> bodies;
    std::span<b2Joint* const> joints;  ///< the joints made before it
};

/// Throws Unsupported, which names the joint, if Box2D 2.4 has no such joint.
b2Joint* addJoint24(const Built24& built, const JointGeometry& joint, const std::string& name);

}  // namespace plumb::compare
