// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/field_flight.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/field_kick.h>
#include <plumb/dynamics/detail/free_motion.h>

namespace plumb {

namespace {

/// In less than this no field could make a difference that a velocity holds, nor its law be told from rounding [s].
constexpr double shortestFelt = 1e-9;

/// A body on its way, by velocity Verlet: its place as a shift from its start, so that no rounding of it counts.
class VerletFlight {
public:
    VerletFlight(const WorldState& world, FieldFlight& flight, const BodyMotion& from, BodyMotion& at, int steps)
        : body_(world.bodies.record[flight.body]),
          base_(accelerationOf(body_, world.def.gravity)),
          flight_(&flight),
          from_(&from),
          at_(&at),
          share_(0.5 / steps) {
        flight.law = {base_, 0, 0};
        flight.rest = {};
        flight.account = {};
        *at_ = from;
    }

    void kick(const FieldPull& pull, double half) {
        const Push before{at_->velocity, at_->angularVelocity};
        const FieldKick kick = kickOf(body_, base_, pull, before, half);
        Push after = before;
        after += sumOf(kick);
        at_->velocity = after.velocity;
        at_->angularVelocity = after.spin;
        flight_->law.linearDamping += kick.rate * share_;
        flight_->law.angularDamping += kick.turningRate * share_;
        const Push mean{0.5 * (before.velocity + after.velocity), 0.5 * (before.spin + after.spin)};
        flight_->account.add(body_, kick, mean, base_.linear * half);
    }

    void drift(double h) {
        shift_ += at_->velocity * h;
        turn_ += at_->angularVelocity * h;
        at_->center = from_->center + shift_;
        at_->angle = from_->angle + turn_;
        at_->rotation = Rot::fromAngle(at_->angle);
    }

    /// The steady acceleration that, with the mean rate of drag, leads to the same place; and what then is missing.
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
    FieldFlight* flight_;
    const BodyMotion* from_;
    BodyMotion* at_;
    double share_;
    Vec2 shift_{0, 0};
    double turn_ = 0;
};

/// All that is awake and does not feel more than is steady, so long after the step's start.
void flyOthers(WorldState& world, double time) {
    for (const BodyIndex body : world.bodies.awake) {
        const std::uint32_t flight = world.bodies.record[body].flight;
        if (flight != none && !world.fields.flights[flight].steady) continue;
        world.fields.now[body] = fly(world.bodies.motion[body], flightLawOf(world, body), time);
    }
}

/// Flies all that feels fields through the step, together.
class Flights {
public:
    Flights(WorldState& world, double dt) : world_(world), steps_(world.def.solver.subSteps), h_(dt / steps_) {
        FieldStore& fields = world.fields;
        around_ = looksAround(world);
        if (around_) fields.now = world.bodies.motion;
        for (FieldFlight& flight : fields.flights)
            if (!flight.steady)
                verlet_.emplace_back(world, flight, world.bodies.motion[flight.body], fields.now[flight.body], steps_);
        if (fields.pulls.size() < verlet_.size()) fields.pulls.resize(verlet_.size());
    }

    void fly(double dt) {
        if (verlet_.empty()) return;
        look();
        for (int step = 1; step <= steps_; ++step) {
            kick();
            for (VerletFlight& verlet : verlet_) verlet.drift(h_);
            if (around_) flyOthers(world_, step * h_);
            look();
            kick();
        }
        for (VerletFlight& verlet : verlet_) verlet.conclude(dt);
    }

private:
    void look() {
        std::size_t i = 0;
        for (const FieldFlight& flight : world_.fields.flights)
            if (!flight.steady) pullOn(world_, flight.body, world_.fields.now, world_.fields.pulls[i++]);
    }
    void kick() {
        for (std::size_t i = 0; i < verlet_.size(); ++i) verlet_[i].kick(world_.fields.pulls[i], 0.5 * h_);
    }

    WorldState& world_;
    int steps_;
    double h_;
    bool around_ = false;
    std::vector<VerletFlight> verlet_;
};

/// What acts on it is the same wherever it is.
void setSteadyLaw(WorldState& world, FieldFlight& flight) {
    const BodyRecord& record = world.bodies.record[flight.body];
    FieldStore& fields = world.fields;
    fields.now[flight.body] = world.bodies.motion[flight.body];
    if (fields.pulls.empty()) fields.pulls.resize(1);
    FieldPull& pull = fields.pulls.front();
    pullOn(world, flight.body, fields.now, pull);
    flight.steadyPull = pull.acceleration.linear;
    flight.law = {accelerationOf(record, world.def.gravity), record.linearDamping + pull.linear, record.angularDamping};
    flight.law.acceleration.linear += pull.acceleration.linear + pull.flow;
}

void gatherFlights(WorldState& world, double dt) {
    FieldStore& fields = world.fields;
    fields.now.resize(world.bodies.motion.size());
    for (const BodyIndex body : world.bodies.awake) {
        if (!world.bodies.canMove(body)) continue;
        const BodyMotion& from = world.bodies.motion[body];
        const Felt felt = feltBy(world, body, from.center, fly(from, flightLawOf(world, body), dt).center);
        if (felt == Felt::Nothing) continue;
        FieldFlight& flight = fields.flights.emplace_back();
        flight.body = body;
        flight.steady = felt == Felt::Steadily;
        if (flight.steady) setSteadyLaw(world, flight);
    }
    for (std::size_t i = 0; i < fields.flights.size(); ++i)
        world.bodies.record[fields.flights[i].body].flight = static_cast<std::uint32_t>(i);
}

}  // namespace

void foretellFlights(WorldState& world, double dt) {
    if (world.fields.empty() || dt < shortestFelt) return;
    gatherDrawn(world);
    gatherFlights(world, dt);
    Flights(world, dt).fly(dt);
}

FieldFlight flightFrom(WorldState& world, const FieldFlight& before, const BodyMotion& from, double start,
                       double time) {
    FieldFlight flight = before;
    if (flight.steady) return flight;
    flight.rest = {};
    flight.account = {};
    if (time < shortestFelt) {
        const BodyRecord& record = world.bodies.record[flight.body];
        flight.law = {accelerationOf(record, world.def.gravity), record.linearDamping, record.angularDamping};
        return flight;
    }
    FieldStore& fields = world.fields;
    const double whole = world.lastStep / world.def.solver.subSteps;
    const int steps = std::max(1, static_cast<int>(std::ceil(time / whole - 1e-6)));
    // The others half-way: the error is of the order of Verlet's.
    if (looksAround(world)) {
        fields.now = world.bodies.motion;
        for (const BodyIndex other : world.bodies.awake)
            if (!world.bodies.record[other].flown)
                fields.now[other] = fly(fields.now[other], flightLawOf(world, other), start + 0.5 * time);
    }
    VerletFlight verlet(world, flight, from, fields.now[flight.body], steps);
    FieldPull& pull = fields.pulls.front();
    pullOn(world, flight.body, fields.now, pull);
    for (int step = 0; step < steps; ++step) {
        verlet.kick(pull, 0.5 * time / steps);
        verlet.drift(time / steps);
        pullOn(world, flight.body, fields.now, pull);
        verlet.kick(pull, 0.5 * time / steps);
    }
    verlet.conclude(time);
    return flight;
}

void finishFlight(WorldState& world, BodyIndex body) {
    const std::uint32_t index = world.bodies.record[body].flight;
    if (index == none || world.fields.flights[index].steady) return;
    const FieldFlight& flight = world.fields.flights[index];
    BodyMotion motion = world.bodies.motion[body];
    motion.velocity += flight.rest.velocity;
    motion.angularVelocity += flight.rest.spin;
    moveTo(world, body, motion);
    if (world.audit) world.audit->noteFieldFlight(flight.account);
}

void forgetFlights(WorldState& world) {
    for (const FieldFlight& flight : world.fields.flights) world.bodies.record[flight.body].flight = none;
    world.fields.flights.clear();
}

}  // namespace plumb
