// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/field_flight.h>

#include <plumb/dynamics/detail/field_kick.h>
#include <plumb/dynamics/detail/free_motion.h>

namespace plumb {

namespace {

/// Flies all that is awake, and keeps what the fields do to each in flights.
class Flights {
public:
    Flights(WorldState& world, double h)
        : world_(world), h_(h), now_(world.bodies.motion), pulls_(world.bodies.awake.size()) {}

    void subStep() {
        if (!looked_) look();
        kick();
        for (const BodyIndex body : world_.bodies.awake) {
            BodyMotion& motion = now_[body];
            motion.center += motion.velocity * h_;
            motion.angle += motion.angularVelocity * h_;
            motion.rotation = Rot::fromAngle(motion.angle);
        }
        look();
        kick();
    }

    const BodyMotion& at(BodyIndex body) const { return now_[body]; }

private:
    void look() {
        looked_ = true;
        for (std::size_t i = 0; i < pulls_.size(); ++i)
            if (world_.bodies.canMove(world_.bodies.awake[i])) pulls_[i] = pullOn(world_, world_.bodies.awake[i], now_);
    }

    void kick() {
        for (std::size_t i = 0; i < pulls_.size(); ++i) {
            const BodyIndex body = world_.bodies.awake[i];
            const BodyRecord& record = world_.bodies.record[body];
            if (!world_.bodies.canMove(body)) continue;
            BodyMotion& motion = now_[body];
            const Acceleration base = accelerationOf(record, world_.def.gravity);
            const Push before{motion.velocity, motion.angularVelocity};
            const FieldKick kick = kickOf(record, base, pulls_[i], before, 0.5 * h_);
            Push after = before;
            after += sumOf(kick);
            motion.velocity = after.velocity;
            motion.angularVelocity = after.spin;
            FieldFlight& flight = world_.fields.flights[body];
            const double share = 0.5 / world_.def.solver.subSteps;
            flight.rate += kick.rate * share;
            flight.turningRate += kick.turningRate * share;
            const Push mean{0.5 * (before.velocity + after.velocity), 0.5 * (before.spin + after.spin)};
            flight.account.add(record, kick, mean, base.linear * (0.5 * h_));
        }
    }

    WorldState& world_;
    double h_;
    std::vector<BodyMotion> now_;
    std::vector<FieldPull> pulls_;  ///< of what is awake, in its order
    bool looked_ = false;
};

/// The steady acceleration, beyond the one that is there, that leads to the same place; and what then is missing.
void keep(FieldFlight& flight, const BodyMotion& from, const BodyMotion& to, const Acceleration& base, double dt) {
    const BodyMotion without = fly(from, {base, flight.rate, flight.turningRate}, dt);
    const Decay linear = decay(flight.rate, dt), angular = decay(flight.turningRate, dt);
    flight.mean.linear = (to.center - without.center) / linear.reach;
    flight.mean.angular = (to.angle - without.angle) / angular.reach;
    flight.rest.velocity = to.velocity - without.velocity - flight.mean.linear * linear.gain;
    flight.rest.spin = to.angularVelocity - without.angularVelocity - flight.mean.angular * angular.gain;
}

}  // namespace

void foretellFlights(WorldState& world, double dt) {
    world.fields.flights.clear();
    if (world.fields.empty()) return;
    wakeWhatIsDrawn(world);
    world.fields.flights.resize(world.bodies.record.size());
    Flights flights(world, dt / world.def.solver.subSteps);
    for (int i = 0; i < world.def.solver.subSteps; ++i) flights.subStep();
    for (const BodyIndex body : world.bodies.awake) {
        if (!world.bodies.canMove(body)) continue;
        const Acceleration base = accelerationOf(world.bodies.record[body], world.def.gravity);
        keep(world.fields.flights[body], world.bodies.motion[body], flights.at(body), base, dt);
    }
}

void finishFlight(WorldState& world, BodyIndex body) {
    if (world.fields.flights.empty() || !world.bodies.canMove(body)) return;
    const FieldFlight& flight = world.fields.flights[body];
    BodyMotion motion = world.bodies.motion[body];
    motion.velocity += flight.rest.velocity;
    motion.angularVelocity += flight.rest.spin;
    moveTo(world, body, motion);
    if (world.audit) world.audit->noteFieldFlight(flight.account);
}

}  // namespace plumb
