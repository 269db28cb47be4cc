// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_end.h>

namespace plumb {

End endAtRest(const Anchor& anchor, const BodyStore& bodies) {
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

}  // namespace plumb
