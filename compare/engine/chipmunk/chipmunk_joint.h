// SPDX-License-Identifier: MIT
// How is a scene's joint made in Chipmunk? Only for sources that are compiled against Chipmunk's headers.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <compare/engine/chipmunk/chipmunk_body.h>
#include <compare/scene/joint_geometry.h>

namespace plumb::compare {

/// What already exists when a joint is made.
struct ChipmunkBuilt {
    cpSpace& space;
    const Scene& scene;
    std::span<const std::unique_ptr<ChipmunkBody>> bodies;
    const std::vector<JointGeometry>& joints;  ///< the scene's
};

/// Each of Chipmunk's joints does one thing, so a scene's joint is made of several of them.
struct ChipmunkJoint {
    std::vector<OwnedChipmunk<cpConstraint>> parts{};
    bool there = false;  ///< false if it has not appeared yet, was taken out with its body, or has broken
};

/// Puts the joint's parts into the space. Parts that cannot move any body are left out. Throws Unsupported, which names
/// the joint, if Chipmunk has no such joint.
ChipmunkJoint addChipmunkJoint(const ChipmunkBuilt& built, const JointGeometry& joint, const std::string& name);

void removeChipmunkJoint(cpSpace& space, ChipmunkJoint& joint);

/// Does a part of the joint hold this body?
bool holdsInChipmunk(const ChipmunkJoint& joint, const cpBody* body);

/// The impulse that all parts together gave to body B in the last step.
struct ChipmunkImpulse {
    Vec2 linear{0, 0};   ///< [N s]
    double angular = 0;  ///< [N m s]
};
ChipmunkImpulse chipmunkImpulseOf(const ChipmunkJoint& joint);

}  // namespace plumb::compare
