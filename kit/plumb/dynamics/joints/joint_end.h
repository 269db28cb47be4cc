// SPDX-License-Identifier: MIT
// Where is a joint's end on a body?
#pragma once
#include <plumb/dynamics/bodies/body_store.h>

namespace plumb {

/// A point fixed to a body, or, on noBody, to the world.
struct Anchor {
    Vec2 local{0, 0};  ///< from the centre of mass, in the body's frame [m]
    BodyIndex body = noBody;
    Vec2 shift{0, 0};  ///< by periods of the world, to the image near the other end [m]
};

/// The anchor on a body at a point of the world, at the body's present position.
inline Anchor anchorAt(BodyIndex body, const Vec2& point, const BodyStore& bodies) {
    const BodyMotion& motion = bodies.motion[body];
    const Vec2 there = bodies.near(point, motion.center);
    return {motion.rotation.inverse() * Vec2(there - motion.center), body, point - there};
}

struct AnchorPair {
    Anchor a, b;
};

/// An anchor's position, and the motion of its body.
struct End {
    BodyIndex body = noBody;
    Vec2 point{0, 0};     ///< the anchor, in the world [m]
    Vec2 arm{0, 0};       ///< from the centre of mass to it [m]
    Rot rotation;         ///< of the body
    double angle = 0;     ///< of the body [rad]
    Vec2 velocity{0, 0};  ///< of the centre of mass [m/s]
    double spin = 0;      ///< [rad/s]
};

/// The end at the state after the last step.
inline End endAtRest(const Anchor& anchor, const BodyStore& bodies) {
    const BodyMotion& motion = bodies.motion[anchor.body];
    End end;
    end.body = anchor.body;
    end.rotation = motion.rotation;
    end.arm = motion.rotation * anchor.local;
    end.point = motion.center + end.arm + anchor.shift;
    end.angle = motion.angle;
    end.velocity = motion.velocity;
    end.spin = motion.angularVelocity;
    return end;
}

/// Both ends of a joint.
struct Ends {
    End a, b;
    Vec2 apart() const { return b.point - a.point; }
    double angle() const { return b.angle - a.angle; }
};
inline Ends endsAtRest(const AnchorPair& anchors, const BodyStore& bodies) {
    return {endAtRest(anchors.a, bodies), endAtRest(anchors.b, bodies)};
}

}  // namespace plumb
