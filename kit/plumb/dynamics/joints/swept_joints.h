// SPDX-License-Identifier: MIT
// How are the joints of a swept island solved, one after the other, as many as possible side by side?
#pragma once
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/joints/joint_store.h>
#include <plumb/dynamics/joints/lanes/island_layout.h>
#include <plumb/dynamics/joints/lanes/swept_lanes.h>

namespace plumb {

/// Batches of joints of one shape, coloured so that no joints of a batch share a body that can be pushed.
class SweptJoints {
public:
    /// Takes over joints with their impulses. laid: their forms.
    void take(const std::vector<JointIndex>& joints, const std::vector<LaidJoint>& laid, const JointStore& store,
              const BodyStore& bodies);
    /// Writes the impulses back to the joints' records; to be called before this object is destroyed.
    void release(JointStore& store) const;

    /// At the start of a step.
    void prepare(const SweptKernel& kernel, const JointStore& store, const BodyStore& bodies);
    void solve(const SweptKernel& kernel, BodyStore& bodies, SweptPass pass, StepObserver* observer);
    /// Adds the impulses of the step to the joints' loads.
    void addLoads(JointStore& store) const;

    std::size_t bytes() const {
        return bytesOf(batches_) + bytesOf(fields_) + bytesOf(slots_) + bytesOf(jointOf_) + bytesOf(generationOf_) +
               bytesOf(angles_) + bytesOf(springs_);
    }

private:
    /// What a field is at the start of a step: an origin, less angles of bodies; or a stiffness, times the joint's
    /// share.
    struct Angle {
        std::size_t field = 0, lane = 0;
        double origin = 0;
        std::array<AnchorPair, maxLinks> link;
        std::array<double, maxLinks> ratio{};  ///< 0: not an angle
    };
    struct Stiffness {
        std::size_t field = 0, lane = 0;
        JointIndex joint = none;
        double stiffness = 0;
    };
    void add(JointIndex joint, const JointForm& form, const JointRecord& record, double ratio, std::size_t lane);
    void addRow(JointIndex joint, const JointForm& form, std::size_t r, std::size_t lane);
    void tell(const SweptBatch& batch, const JointIndex* joints, const float* told, StepObserver& observer) const;

    std::vector<SweptBatch> batches_;
    std::vector<SweptFloats> fields_;
    std::vector<SweptSlots> slots_;
    std::vector<JointIndex> jointOf_;          ///< batch * batchLanes + lane; none for an empty lane
    std::vector<std::uint32_t> generationOf_;  ///< of those joints
    std::vector<Angle> angles_;
    std::vector<Stiffness> springs_;
};

}  // namespace plumb
