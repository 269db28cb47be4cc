// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joint.h>

#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

JointReaction JointView::reaction() const {
    const JointRecord& record = world_->joints[index_];
    const double time = record.solvedStep;
    if (time == 0) return {};
    return std::visit(
        [time]<class Joint>(const Joint& joint) -> JointReaction {
            if constexpr (std::is_same_v<Joint, std::monostate>)
                return {};
            else
                return {Vec2(joint.reaction().template cast<double>()) / time,
                        static_cast<double>(joint.angularReaction()) / time};
        },
        record.joint);
}

}  // namespace plumb
