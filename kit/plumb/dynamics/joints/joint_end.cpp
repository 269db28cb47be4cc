// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_end.h>

#include <cmath>

namespace plumb {

namespace {

/// Turning is predicted up to this angle only: at larger angles, in a joint that is coming apart, the prediction would
/// add to the error that it should correct [rad].
constexpr double farthestTurn = 0.5;

End endOf(const Anchor& anchor, const BodyMotion& motion) {
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

}  // namespace

End endAtRest(const Anchor& anchor, const BodyStore& bodies) {
    return endOf(anchor, bodies.motion[anchor.body]);
}

End endNow(const Anchor& anchor, const BodyStore& bodies) {
    BodyMotion motion = bodies.motion[anchor.body];
    const SolverDisplacement& moved = bodies.displacement[anchor.body];
    const SolverVelocity& velocity = bodies.velocity[anchor.body];
    const double inverseGyration = static_cast<double>(bodies.turn[anchor.body].inverseGyration);
    const Rot start = motion.rotation;
    const double sin = static_cast<double>(moved.sin) * inverseGyration,
                 less = static_cast<double>(moved.cosMinus1) * inverseGyration;
    motion.center += Vec2(static_cast<double>(moved.x), static_cast<double>(moved.y));
    motion.angle += static_cast<double>(bodies.turn[anchor.body].angle);
    motion.rotation.cos = start.cos + (start.cos * less - start.sin * sin);
    motion.rotation.sin = start.sin + (start.sin * less + start.cos * sin);
    motion.velocity = {static_cast<double>(velocity.x), static_cast<double>(velocity.y)};
    motion.angularVelocity = static_cast<double>(velocity.w) * inverseGyration;
    return endOf(anchor, motion);
}

double spinAhead(const End& now, double h) {
    return std::fabs(now.spin) * h <= farthestTurn ? now.spin : std::copysign(farthestTurn / h, now.spin);
}

End endAfter(const End& now, double h) {
    End end = now;
    const double turn = spinAhead(now, h) * h;
    const Rot turned{1 - turn * turn / 2 * (1 - turn * turn / 12),
                     turn * (1 - turn * turn / 6 * (1 - turn * turn / 20))};
    end.arm = turned * now.arm;
    end.rotation = turned * now.rotation;
    end.point += now.velocity * h + (end.arm - now.arm);
    end.angle += turn;
    return end;
}

}  // namespace plumb
