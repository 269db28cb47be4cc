// SPDX-License-Identifier: MIT
#include <plumb/dynamics/jointed/joint_solver.h>

#include <plumb/dynamics/bodies/solver_velocity.h>

namespace plumb {

SolvedBodies::SolvedBodies(BodyStore& bodies, JointSolver& joints, BodyIndex a, BodyIndex b)
    : bodies_(bodies),
      joints_(joints),
      a_(a),
      b_(b),
      islandA_(bodies.canMove(a) ? joints.islandOf(a) : nullptr),
      islandB_(bodies.canMove(b) ? joints.islandOf(b) : nullptr) {}

OfBoth SolvedBodies::velocity() const {
    return {velocityOf(bodies_, a_), velocityOf(bodies_, b_)};
}

template <class Act, class Alone>
OfBoth SolvedBodies::forEach(const OfBoth& impulse, Act&& act, Alone&& alone) {
    BodyPush both[2] = {{a_, impulse.a, {}}, {b_, impulse.b, {}}};
    if (islandA_ != nullptr && islandA_ == islandB_) {
        act(*islandA_, std::span(both));
    } else {
        islandA_ != nullptr ? act(*islandA_, std::span(both, 1)) : alone(both[0]);
        islandB_ != nullptr ? act(*islandB_, std::span(both + 1, 1)) : alone(both[1]);
    }
    return {both[0].change, both[1].change};
}

OfBoth SolvedBodies::responseTo(const OfBoth& impulse) {
    return forEach(
        impulse, [this](JointIsland& island, std::span<BodyPush> some) { joints_.respond(island, some); },
        [this](BodyPush& one) { one.change = velocityChangeBy(bodies_, one.body, one.impulse); });
}

void SolvedBodies::push(const OfBoth& impulse) {
    forEach(
        impulse, [this](JointIsland& island, std::span<BodyPush> some) { joints_.push(island, some); },
        [this](BodyPush& one) { addVelocity(bodies_, one.body, velocityChangeBy(bodies_, one.body, one.impulse)); });
}

}  // namespace plumb
