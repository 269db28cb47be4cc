// SPDX-License-Identifier: MIT
#include <plumb/dynamics/fields/field_flight.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/fields/field_effects.h>
#include <plumb/dynamics/fields/field_scope.h>

namespace plumb {

namespace {

/// Moves one body by velocity Verlet: half a kick, drift, half a kick, in each sub-step. Its position is kept as a
/// shift from the start, so that rounding of large coordinates has no effect. It refers to its flight and account,
/// which must not move in memory until conclude().
class VerletFlight {
public:
    VerletFlight(const BodyStore& bodies, PredictedFlight& flight, FieldAccount& account, const BodyMotion& from,
                 BodyMotion& at, int steps)
        : body_(bodies.record[flight.body]),
          base_(accelerationOf(body_, bodies.gravity)),
          flight_(&flight),
          account_(&account),
          from_(&from),
          at_(&at),
          share_(0.5 / steps) {
        flight.law = {base_, 0, 0};
        flight.rest = {};
        account = {};
        *at_ = from;
    }

    void kick(const FieldPull& pull, double half) {
        const VelocityChange before{at_->velocity, at_->angularVelocity};
        const FieldKick kick = kickOf(body_, base_, pull, before, half);
        VelocityChange after = before;
        after += sumOf(kick);
        at_->velocity = after.velocity;
        at_->angularVelocity = after.spin;
        // The mean over all kicks of the step: share_ is 1 over their number.
        flight_->law.linearDamping += kick.rate * share_;
        flight_->law.angularDamping += kick.turningRate * share_;
        const VelocityChange mean{0.5 * (before.velocity + after.velocity), 0.5 * (before.spin + after.spin)};
        account_->add(body_, kick, mean, base_.linear * half);
    }

    void drift(double h) {
        shift_ += at_->velocity * h;
        turn_ += at_->angularVelocity * h;
        at_->center = from_->center + shift_;
        at_->angle = from_->angle + turn_;
        at_->rotation = Rot::fromAngle(at_->angle);
    }

    /// Finds the steady acceleration that, with the mean drag rate, leads to the same position: x = v0 gain + a reach
    /// (free_motion.h), solved for a. And the velocity (flight.rest) that is then missing.
    void conclude(double time) {
        FlightLaw& law = flight_->law;
        const Decay linear = decay(law.linearDamping, time), angular = decay(law.angularDamping, time);
        law.acceleration.linear = (shift_ - from_->velocity * linear.gain) / linear.reach;
        law.acceleration.angular = (turn_ - from_->angularVelocity * angular.gain) / angular.reach;
        flight_->rest.velocity = at_->velocity - from_->velocity * linear.keep - law.acceleration.linear * linear.gain;
        flight_->rest.spin =
            at_->angularVelocity - from_->angularVelocity * angular.keep - law.acceleration.angular * angular.gain;
    }

private:
    const BodyRecord& body_;
    Acceleration base_;
    PredictedFlight* flight_;
    FieldAccount* account_;
    const BodyMotion* from_;
    BodyMotion* at_;
    double share_;
    Vec2 shift_{0, 0};
    double turn_ = 0;
};

/// Sets fields.now for all awake bodies on which no varying field acts, at a time after the step's start [s]: those
/// that attract, and move by closed forms.
void moveOthers(FieldStore& fields, const BodyStore& bodies, double time) {
    for (const BodyIndex body : bodies.awake) {
        const std::uint32_t flight = bodies.step[body].flight;
        if (flight != none && !bodies.flights[flight].steady) continue;
        fields.now[body] = moveFreely(bodies.motion[body], flightLawOf(bodies, body), time);
    }
}

/// Moves all bodies on which varying fields act through the step, together: in mutual gravity, each sub-step needs the
/// places of all. Pulls are computed once a sub-step, as the kick at its end and the one at the next one's start are at
/// the same places.
class Flights {
public:
    Flights(FieldStore& fields, BodyStore& bodies, const Space& space, double dt)
        : fields_(fields), bodies_(bodies), space_(space), steps_(bodies.subSteps), h_(dt / steps_) {
        around_ = dependsOnOtherBodies(fields);
        if (around_) fields.now = bodies.motion;
        for (std::size_t i = 0; i < bodies.flights.size(); ++i) {
            PredictedFlight& flight = bodies.flights[i];
            if (!flight.steady)
                verlet_.emplace_back(bodies, flight, fields.accounts[i].account, bodies.motion[flight.body],
                                     fields.now[flight.body], steps_);
        }
        if (fields.pulls.size() < verlet_.size()) fields.pulls.resize(verlet_.size());
    }

    void run(double dt) {
        if (verlet_.empty()) return;
        findPulls();
        for (int step = 1; step <= steps_; ++step) {
            kick();
            for (VerletFlight& verlet : verlet_) verlet.drift(h_);
            if (around_) moveOthers(fields_, bodies_, step * h_);
            findPulls();
            kick();
        }
        for (VerletFlight& verlet : verlet_) verlet.conclude(dt);
    }

private:
    void findPulls() {
        std::size_t i = 0;
        for (const PredictedFlight& flight : bodies_.flights)
            if (!flight.steady) pullOn({fields_, bodies_, space_}, flight.body, fields_.now, fields_.pulls[i++]);
    }
    void kick() {
        for (std::size_t i = 0; i < verlet_.size(); ++i) verlet_[i].kick(fields_.pulls[i], 0.5 * h_);
    }

    FieldStore& fields_;
    BodyStore& bodies_;
    const Space& space_;
    int steps_;
    double h_;
    bool around_ = false;
    StepList<VerletFlight> verlet_;
};

/// Sets the law of a flight on which only steady fields act: their force is the same everywhere.
/// Uniform gravity and linear drag add to the constants of the closed form: no sub-steps, and no error.
void setSteadyLaw(FieldStore& fields, const BodyStore& bodies, const Space& space, PredictedFlight& flight,
                  FlightAccount& account) {
    const BodyRecord& record = bodies.record[flight.body];
    fields.now[flight.body] = bodies.motion[flight.body];
    if (fields.pulls.empty()) fields.pulls.resize(1);
    FieldPull& pull = fields.pulls.front();
    pullOn({fields, bodies, space}, flight.body, fields.now, pull);
    account.steadyPull = pull.acceleration.linear;
    flight.law = {accelerationOf(record, bodies.gravity), record.linearDamping + pull.linear, record.angularDamping};
    flight.law.acceleration.linear += pull.acceleration.linear + pull.flow;
}

/// O(awake bodies x fields). Which fields may act on a body is judged from its path without fields: where only steady
/// ones do, what they add to the path within the step is left out.
void gatherFlights(FieldStore& fields, BodyStore& bodies, const Space& space, double dt) {
    fields.now.resize(bodies.motion.size());
    for (const BodyIndex body : bodies.awake) {
        if (!bodies.canMove(body)) continue;
        const BodyMotion& from = bodies.motion[body];
        const Vec2 to = moveFreely(from, flightLawOf(bodies, body), dt).center;
        const FieldInfluence influence = influenceOn({fields, bodies, space}, body, from.center, to);
        if (influence == FieldInfluence::None) continue;
        PredictedFlight& flight = bodies.flights.emplace_back();
        FlightAccount& account = fields.accounts.emplace_back();
        flight.body = body;
        flight.steady = influence == FieldInfluence::Steady;
        if (flight.steady) setSteadyLaw(fields, bodies, space, flight, account);
    }
    for (std::size_t i = 0; i < bodies.flights.size(); ++i)
        bodies.step[bodies.flights[i].body].flight = static_cast<std::uint32_t>(i);
}

}  // namespace

void predictFlights(FieldStore& fields, BodyStore& bodies, const Space& space, double dt) {
    if (fields.empty() || dt < shortestFieldStep) return;
    gatherFlights(fields, bodies, space, dt);
    Flights(fields, bodies, space, dt).run(dt);
}

/// Called by the impacts, after each bounce of a body in varying fields, for the rest of the step, and for the time up
/// to a bounce.
FieldFlight flightFrom(FieldStore& fields, const BodyStore& bodies, const Space& space, const PredictedFlight& before,
                       const BodyMotion& from, double start, double time) {
    FieldFlight result{before, {}};
    PredictedFlight& flight = result.flight;
    if (flight.steady) return result;
    flight.rest = {};
    if (time < shortestFieldStep) {
        const BodyRecord& record = bodies.record[flight.body];
        flight.law = {accelerationOf(record, bodies.gravity), record.linearDamping, record.angularDamping};
        return result;
    }
    const double whole = bodies.lastStep / bodies.subSteps;
    // As short as the solver's sub-steps, but equal ones: the order of error stays the same after a bounce. 1e-6:
    // rounding makes no further step.
    const int steps = std::max(1, static_cast<int>(std::ceil(time / whole - 1e-6)));
    // The other bodies are taken at half of the time: the error is of the same order as Verlet's.
    if (dependsOnOtherBodies(fields)) {
        fields.now = bodies.motion;
        for (const BodyIndex other : bodies.awake)
            if (!bodies.isMovedBy(other, MovedBy::Impacts))
                fields.now[other] = moveFreely(fields.now[other], flightLawOf(bodies, other), start + 0.5 * time);
    }
    VerletFlight verlet(bodies, flight, result.account, from, fields.now[flight.body], steps);
    FieldPull& pull = fields.pulls.front();
    const FieldStores view{fields, bodies, space};
    pullOn(view, flight.body, fields.now, pull);
    for (int step = 0; step < steps; ++step) {
        verlet.kick(pull, 0.5 * time / steps);
        verlet.drift(time / steps);
        pullOn(view, flight.body, fields.now, pull);
        verlet.kick(pull, 0.5 * time / steps);
    }
    verlet.conclude(time);
    return result;
}

void clearFlights(FieldStore& fields, BodyStore& bodies) {
    for (const PredictedFlight& flight : bodies.flights) bodies.step[flight.body].flight = none;
    bodies.flights.clear();
    fields.accounts.clear();
}

}  // namespace plumb
