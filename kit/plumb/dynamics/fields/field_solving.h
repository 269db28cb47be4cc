// SPDX-License-Identifier: MIT
// What do the fields do to what the solver has?
#pragma once
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// In each half of a sub-step, after the bodies' kick and before the joints: where the bodies are by then, at the
/// velocities that they have by then.
class FieldSolving {
public:
    /// h: the sub-step [s]; observer: if there is one.
    FieldSolving(FieldStore& fields, BodyStore& bodies, const Space& space, double h, StepObserver* observer)
        : fields_(fields), bodies_(bodies), space_(space), h_(h), observer_(observer) {}

    /// Of the solved bodies, those that feel fields; noBody fills the list up.
    void kick(const std::vector<BodyIndex>& solved);
    /// The bodies have been moved on by a sub-step.
    void moved() { known_ = false; }

private:
    void findPulls(const std::vector<BodyIndex>& solved);
    bool feels(BodyIndex body) const;

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
