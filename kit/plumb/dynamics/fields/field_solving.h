// SPDX-License-Identifier: MIT
// How do the fields act on the bodies that the solver moves?
#pragma once
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// Applies the fields in each half of a sub-step, after the bodies' kick and before the joints, at the positions and
/// velocities that the bodies have at that moment.
class FieldSolving {
public:
    /// h: the sub-step [s]; observer: may be null.
    FieldSolving(FieldStore& fields, BodyStore& bodies, const Space& space, double h, StepObserver* observer)
        : fields_(fields), bodies_(bodies), space_(space), h_(h), observer_(observer) {}

    /// Changes the velocities of those solved bodies on which fields act. The list may be filled up with noBody.
    void kick(const std::vector<BodyIndex>& solved);
    /// To be called after the bodies have moved by a sub-step.
    void moved() { known_ = false; }

private:
    void findPulls(const std::vector<BodyIndex>& solved);
    bool isInfluenced(BodyIndex body) const;

    FieldStore& fields_;
    BodyStore& bodies_;
    const Space& space_;
    double h_;
    StepObserver* observer_;
    int subSteps_ = 0;
    bool known_ = false;
    std::vector<FieldPull> pulls_;
};

}  // namespace plumb
