// SPDX-License-Identifier: MIT
// How does a scene's joint look in Chipmunk? Only for sources that are compiled against Chipmunk's headers.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <compare/engine/chipmunk/chipmunk_body.h>
#include <compare/engine/joint_geometry.h>

namespace plumb::compare {

/// What there is when a joint is made.
struct ChipmunkBuilt {
    cpSpace& space;
    const Scene& scene;
    std::span<const std::unique_ptr<ChipmunkBody>> bodies;
    const std::vector<JointGeometry>& joints;  ///< the scene's
};

/// Chipmunk's joints do one thing each: a scene's joint is some of them together.
struct ChipmunkJoint {
    std::vector<OwnedChipmunk<cpConstraint>> parts{};
    bool there = false;  ///< false: not come yet, gone with its body, or broken
};

/// Puts its parts into the space; those that nothing could move by are left out. Throws Unsupported, naming the joint,
/// when Chipmunk has no such thing.
ChipmunkJoint addChipmunkJoint(const ChipmunkBuilt& built, const JointGeometry& joint, const std::string& name);

void removeChipmunkJoint(cpSpace& space, ChipmunkJoint& joint);

/// Does a part of the joint hold this body?
bool holdsInChipmunk(const ChipmunkJoint& joint, const cpBody* body);

/// What the parts together gave body B in the last step.
struct ChipmunkImpulse {
    Vec2 linear{0, 0};   ///< [N s]
    double angular = 0;  ///< [N m s]
};
ChipmunkImpulse chipmunkImpulseOf(const ChipmunkJoint& joint);

}  // namespace plumb::compare
