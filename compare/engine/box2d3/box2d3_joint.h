// SPDX-License-Identifier: MIT
// How is a scene's joint made in Box2D 3? Only for sources that are compiled against Box2D 3's headers.
#pragma once
#include <box2d/box2d.h>

#include <span>
#include <string>

#include <compare/scene/joint_geometry.h>

namespace plumb::compare {

/// What already exists when a joint is made.
struct Built3 {
    b2WorldId world;
    const Scene& scene;
    std::span<const b2BodyId> bodies;
    double subStep;  ///< [s]
};

/// The joint's user data is its index. Box2D 3 expects springs as frequencies of an effective mass; this mass is
/// computed for the bodies' places at the start. Throws Unsupported, which names the joint, if Box2D 3 has no such
/// joint.
b2JointId addJoint3(const Built3& built, const JointGeometry& joint, std::size_t index);

/// The index of the joint with this user data.
std::size_t jointOf3(const void* userData);

}  // namespace plumb::compare
