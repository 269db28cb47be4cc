// SPDX-License-Identifier: MIT
// What do the fields do to what the solver has?
#pragma once
#include <plumb/dynamics/detail/field_pull.h>

namespace plumb {

/// In each half of a sub-step, after the bodies' kick and before the joints: where the bodies are by then, at the
/// velocities that they have by then.
class FieldSolving {
public:
    FieldSolving(WorldState& world, double h) : world_(world), h_(h) {}

    /// solved: the bodies' slots; noBody is company. Of these, those that feel fields.
    void kick(const std::vector<BodyIndex>& solved);
    /// The bodies have been moved on by a sub-step.
    void moved() { looked_ = false; }

private:
    void look(const std::vector<BodyIndex>& solved);
    bool feels(BodyIndex body) const;

    WorldState& world_;
    double h_;
    int subSteps_ = 0;
    bool looked_ = false;
    std::vector<FieldPull> pulls_;
};

}  // namespace plumb
