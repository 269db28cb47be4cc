// SPDX-License-Identifier: MIT
// How do the fields act on the bodies that the solver moves? And who else does what fields do in a step?
#pragma once
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/fields/field_effects.h>
#include <plumb/dynamics/fields/field_flight.h>
#include <plumb/dynamics/fields/field_scope.h>

namespace plumb {

/// The field solver of a world that has fields.
class FieldSolving final : public FieldSolver {
public:
    std::unique_ptr<FieldSolver> copy() const override { return std::make_unique<FieldSolving>(); }

    StepList<BodyIndex> gatherAttracted(FieldStore& fields, FieldIndex field, const BodyStore& bodies,
                                        const Space& space) override {
        return plumb::gatherAttracted(fields, field, bodies, space);
    }
    void predictFlights(FieldStore& fields, BodyStore& bodies, const Space& space, double dt) override {
        plumb::predictFlights(fields, bodies, space, dt);
    }
    FieldFlight flightFrom(FieldStore& fields, const BodyStore& bodies, const Space& space,
                           const PredictedFlight& before, const BodyMotion& from, double start, double time) override {
        return plumb::flightFrom(fields, bodies, space, before, from, start, time);
    }
    StepList<BodyIndex> influencedBy(const FieldStores& view, const FieldRecord& field) const override {
        return bodiesInfluencedBy(view, field);
    }
    double energy(const FieldStores& view) const override { return fieldEnergyOf(view); }
    double energyOf(const FieldStores& view, BodyIndex body, const BodyMotion& there) const override {
        return fieldEnergyOf(view, body, there);
    }

    void begin(FieldStore& fields, BodyStore& bodies, const Space& space, double h, StepObserver* observer) override;
    void kick(std::span<const BodyIndex> solved) override;
    void moved() override { known_ = false; }

private:
    void findPulls(std::span<const BodyIndex> solved);
    bool isInfluenced(BodyIndex body) const;

    // Of the present step:
    FieldStore* fields_ = nullptr;
    BodyStore* bodies_ = nullptr;
    const Space* space_ = nullptr;
    double h_ = 0;
    StepObserver* observer_ = nullptr;
    int subSteps_ = 0;
    bool known_ = false;
    std::vector<FieldPull> pulls_;
};

}  // namespace plumb
