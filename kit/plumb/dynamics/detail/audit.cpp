// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/audit.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/field_pull.h>
#include <plumb/dynamics/detail/quarantine.h>
#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

namespace {

double kineticOf(const BodyRecord& body, const Vec2& velocity, double spin) {
    return 0.5 * body.mass * velocity.squaredNorm() +
           (body.inverseInertia > 0 ? 0.5 * body.inertia * spin * spin : 0.0);
}

double gravitationalOf(const BodyRecord& body, const Vec2& center, const Vec2& gravity) {
    return -body.mass * body.gravityScale * gravity.dot(center);
}

/// The speed of a contact's point on one body along an axis, its arm's part times rho given.
double speedAlong(const SolverVelocity& v, double x, double y, double turn) {
    return x * static_cast<double>(v.x) + y * static_cast<double>(v.y) + turn * static_cast<double>(v.w);
}

Vec2 linearOf(const SolverVelocity& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

/// Faster than gravity makes in two steps what has lain still.
bool hits(const WorldState& world, const ManifoldLanes& manifolds, std::size_t lane) {
    return static_cast<double>(manifolds.approachSpeed[lane]) > 2 * world.def.gravity.norm() * world.lastStep + 1e-3;
}

/// Calls visit(batch, its manifolds, lane).
template <class Visit>
void forEachLane(const WorldState& world, Visit&& visit) {
    for (const Colour& colour : world.graph.colours)
        for (std::size_t slot = 0; slot < colour.contactOf.size(); ++slot)
            visit(colour.batches[slot / batchLanes], colour.manifolds[slot / batchLanes], slot % batchLanes);
}

}  // namespace

/// One contact: what it has given, and the velocities of its bodies.
struct Audit::Lane {
    const ContactBatch& batch;
    std::size_t lane;
    SolverVelocity a, b;
    double normal[2] = {0, 0}, tangent[2] = {0, 0}, roll = 0;

    /// Before it has given anything.
    static Lane before(const ContactBatch& from, std::size_t at, const std::vector<SolverVelocity>& velocities) {
        Lane lane(from, at, velocities);
        lane.normal[0] = lane.normal[1] = lane.tangent[0] = lane.tangent[1] = lane.roll = 0;
        return lane;
    }
    Lane(const ContactBatch& from, std::size_t at, const std::vector<SolverVelocity>& velocities)
        : batch(from), lane(at), a(velocities[from.bodyA[at]]), b(velocities[from.bodyB[at]]) {
        for (std::size_t p = 0; p < 2; ++p) {
            normal[p] = static_cast<double>(batch.points[p].normalImpulse[lane]);
            tangent[p] = static_cast<double>(batch.points[p].tangentImpulse[lane]);
        }
        roll = static_cast<double>(batch.rollImpulse[lane]);
    }
    double nx() const { return static_cast<double>(batch.normalX[lane]); }
    double ny() const { return static_cast<double>(batch.normalY[lane]); }
    // Along the normal, and along the tangent (-ny, nx), of a point on A and on B.
    double normalA(std::size_t p) const {
        return speedAlong(a, nx(), ny(), -static_cast<double>(batch.points[p].anchorTangentA[lane]));
    }
    double normalB(std::size_t p) const {
        return speedAlong(b, nx(), ny(), -static_cast<double>(batch.points[p].anchorTangentB[lane]));
    }
    double tangentA(std::size_t p) const {
        return speedAlong(a, -ny(), nx(), static_cast<double>(batch.points[p].anchorNormalA[lane]));
    }
    double tangentB(std::size_t p) const {
        return speedAlong(b, -ny(), nx(), static_cast<double>(batch.points[p].anchorNormalB[lane]));
    }
    double rollA() const { return static_cast<double>(batch.rollRhoA[lane] * a.w); }
    double rollB() const { return static_cast<double>(batch.rollRhoB[lane] * b.w); }
};

void Audit::note(Energy entry, double energy) {
    ledger_.energy.*entry += energy;
    notedEnergy_ += energy;
}

void Audit::note(Momentum entry, const Vec2& momentum) {
    ledger_.momentum.*entry += momentum;
    notedMomentum_ += momentum;
}

void Audit::book(const WorldState& world, Energy energy, Momentum momentum) {
    EnergyLedger& e = ledger_.energy;
    e.kinetic = e.gravitational = e.spring = 0;
    e.fields = fieldEnergyOf(world);
    Vec2 sum(0, 0);
    const auto sound = [&](BodyIndex body) { return isSound(world.bodies.motion[body]); };
    for (BodyIndex body = 1; body < world.bodies.record.size(); ++body) {
        const BodyRecord& record = world.bodies.record[body];
        if (!record.alive || record.type != BodyType::Dynamic) continue;
        const BodyMotion& motion = world.bodies.motion[body];
        if (!sound(body)) continue;  // it goes into quarantine before it can do anything
        e.kinetic += kineticOf(record, motion.velocity, motion.angularVelocity);
        e.gravitational += gravitationalOf(record, motion.center, world.def.gravity);
        sum += record.mass * motion.velocity;
    }
    if (world.jointSystem != nullptr) e.spring = world.jointSystem->springEnergy(world);
    e.*energy += (e.stored() - energy_) - notedEnergy_;
    ledger_.momentum.*momentum += (sum - momentum_) - notedMomentum_;
    ledger_.momentum.momentum = momentum_ = sum;
    energy_ = e.stored();
    notedEnergy_ = 0;
    notedMomentum_.setZero();
}

void Audit::noteFlight(const WorldState& world, BodyIndex body, const BodyMotion& from, const BodyMotion& to,
                       double time) {
    const BodyRecord& record = world.bodies.record[body];
    if (record.type != BodyType::Dynamic) return;
    const double work = record.force.dot(to.center - from.center) + record.torque * (to.angle - from.angle);
    const Vec2 pull = record.mass * record.gravityScale * world.def.gravity * time, push = record.force * time;
    note(&EnergyLedger::forces, work);
    note(&MomentumLedger::gravity, pull);
    note(&MomentumLedger::forces, push);
    const auto energyAt = [&](const BodyMotion& m) {
        return kineticOf(record, m.velocity, m.angularVelocity) + gravitationalOf(record, m.center, world.def.gravity) +
               fieldEnergyOf(world, body, m);
    };
    const FieldFlight* flight = record.flight == none ? nullptr : &world.fields.flights[record.flight];
    if (flight && !flight->steady) {  // what of it had which cause is told when its flight is over
        note(&EnergyLedger::solver, energyAt(to) - energyAt(from) - work);
        return;
    }
    const Vec2 fields = flight ? Vec2(record.mass * flight->steadyPull * time) : Vec2(0, 0);
    note(&MomentumLedger::fields, fields);
    const FlightLaw law = flightLawOf(world, body);
    if (law.linearDamping == 0 && law.angularDamping == 0) return;
    note(&EnergyLedger::damping, energyAt(to) - energyAt(from) - work);
    note(&MomentumLedger::damping, record.mass * (to.velocity - from.velocity) - pull - push - fields);
}

void Audit::noteAccount(const FieldAccount& account) {
    note(&EnergyLedger::forces, account.forced);
    note(&EnergyLedger::damping, account.damped);
    note(&EnergyLedger::friction, account.rubbed);
    note(&MomentumLedger::fields, account.fields);
    note(&MomentumLedger::damping, account.dampedMomentum);
    note(&MomentumLedger::ground, account.rubbedMomentum);
}

void Audit::noteFieldFlight(const FieldAccount& account) {
    noteAccount(account);
    note(&EnergyLedger::solver, -(account.forced + account.damped + account.rubbed));
}

void Audit::begin(const WorldState& world) {
    dampedEnergy_.assign(world.bodies.record.size(), 0.0);
    dampedMomentum_.assign(world.bodies.record.size(), Vec2(0, 0));
    fieldAccounts_.assign(world.fields.flights.empty() ? 0 : world.bodies.record.size(), {});
}

void Audit::beforeKick(const WorldState& world, const std::vector<BodyIndex>& solved) {
    const double half = 0.5 * world.lastStep / world.def.solver.subSteps;
    start_ = world.bodies.velocity;
    for (const BodyIndex body : solved) {
        const BodyRecord& record = world.bodies.record[body];
        if (record.flight != none) continue;  // theirs is told by noteFieldKick
        SolverVelocity& v = start_[body];
        const Kick& kick = world.bodies.kick[body];
        const double rho = static_cast<double>(world.bodies.turn[body].rho);
        const double before = kineticOf(record, linearOf(v), static_cast<double>(v.w) * rho);
        const Vec2 start = linearOf(v);
        v = {v.x * kick.keep.x, v.y * kick.keep.y, v.w * kick.keep.w, v.inverseMass};
        dampedEnergy_[body] += kineticOf(record, linearOf(v), static_cast<double>(v.w) * rho) - before;
        dampedMomentum_[body] += record.mass * (linearOf(v) - start);
        const Vec2 gain(static_cast<double>(kick.gain.x), static_cast<double>(kick.gain.y));
        const Vec2 pull = record.mass * record.gravityScale * world.def.gravity + record.force;
        if (record.linearDamping > 0) dampedMomentum_[body] += record.mass * gain - pull * half;
        v = {v.x + kick.gain.x, v.y + kick.gain.y, v.w + kick.gain.w, v.inverseMass};
    }
}

void Audit::noteFieldKick(const WorldState& world, BodyIndex body, const FieldKick& kick, const Vec2& base) {
    SolverVelocity& v = start_[body];
    v.x += static_cast<float>(kick.kept.velocity.x());
    v.y += static_cast<float>(kick.kept.velocity.y());
    v.w += static_cast<float>(kick.kept.spin) * world.bodies.turn[body].inverseRho;
    fieldsGiven_.push_back({body, kick, base});
}

void Audit::noteGiven(const BodyStore& bodies, const FieldGiven& given) {
    const double rho = static_cast<double>(bodies.turn[given.body].rho);
    const SolverVelocity &then = start_[given.body], &now = bodies.velocity[given.body];
    const Push mean{0.5 * (linearOf(then) + linearOf(now)), 0.5 * rho * static_cast<double>(then.w + now.w)};
    fieldAccounts_[given.body].add(bodies.record[given.body], given.kick, mean, given.base);
}

void Audit::noteContact(const Lane& before, const Lane& after, bool hits) {
    const ContactBatch& batch = after.batch;
    const double belt = batch.belts ? static_cast<double>(batch.beltSpeed[after.lane]) : 0.0;
    const bool pushA = after.a.inverseMass > 0, pushB = after.b.inverseMass > 0;
    double friction = 0, impacts = 0, drivers = 0;
    Vec2 impulse(0, 0);
    for (std::size_t p = 0; p < 2; ++p) {
        const double normal = after.normal[p] - before.normal[p], tangent = after.tangent[p] - before.tangent[p];
        const double na = 0.5 * (before.normalA(p) + after.normalA(p)),
                     nb = 0.5 * (before.normalB(p) + after.normalB(p));
        const double ta = 0.5 * (before.tangentA(p) + after.tangentA(p));
        const double tb = 0.5 * (before.tangentB(p) + after.tangentB(p));
        impacts += normal * (nb - na);
        friction += tangent * (tb - ta + belt);
        drivers -= tangent * belt;
        // What is not pushed works on what is.
        if (!pushA) drivers += normal * na + tangent * ta;
        if (!pushB) drivers -= normal * nb + tangent * tb;
        impulse += Vec2(after.nx(), after.ny()) * normal + Vec2(-after.ny(), after.nx()) * tangent;
    }
    if (batch.rolls) {
        const double roll = after.roll - before.roll;
        const double ra = 0.5 * (before.rollA() + after.rollA()), rb = 0.5 * (before.rollB() + after.rollB());
        friction += roll * (rb - ra);
        if (!pushA) drivers += roll * ra;
        if (!pushB) drivers -= roll * rb;
    }
    note(&EnergyLedger::friction, friction);
    note(&EnergyLedger::drivers, drivers);
    if (hits) note(&EnergyLedger::impacts, impacts);
    if (pushA != pushB) note(&MomentumLedger::ground, pushB ? impulse : Vec2(-impulse));
}

Audit::Given Audit::givenBy(const JointRows& rows, std::size_t row, double impulse) {
    Given given;
    given.body = rows.body;
    given.all = impulse;
    for (std::size_t e = 0; e < rows.ends; ++e) given.at[e] = rows.at(row, e);
    return given;
}

void Audit::noteRows(const JointRows& rows, const Vec3& impulses, const Vec3& after, const Vec3& slopes) {
    for (std::size_t r = 0; r < rows.count; ++r) {
        const JointRow& row = rows.row[r];
        Given& given = given_.emplace_back(givenBy(rows, r, impulses[r]));
        if (row.holds) continue;
        given.damper = row.dampPush - slopes[r] * after[r];
        if (row.bounded) continue;
        const double curve = impulses[r] - row.push - (given.damper - row.dampPush);
        given.motor = std::clamp(curve, row.low, row.high);
        given.impact = curve - given.motor;
    }
}

void Audit::noteImpact(const JointRows& rows, double impulse) {
    given_.push_back(givenBy(rows, 0, impulse));
    given_.back().impact = impulse;
}

void Audit::noteGiven(const BodyStore& bodies, const Given& given) {
    double mean = 0, driven = 0;
    for (std::size_t e = 0; e < mostEnds; ++e) {
        const BodyIndex body = given.body[e];
        const Vec3& at = given.at[e];
        const double turn = at[2] * static_cast<double>(bodies.turn[body].rho);
        const SolverVelocity& now = bodies.velocity[body];
        mean += 0.5 * (speedAlong(start_[body], at[0], at[1], turn) + speedAlong(now, at[0], at[1], turn));
        if (now.inverseMass == 0) driven += speedAlong(now, at[0], at[1], turn);
    }
    note(&EnergyLedger::drivers, -given.all * driven);
    note(&EnergyLedger::damping, given.damper * mean);
    note(&EnergyLedger::motors, given.motor * mean);
    note(&EnergyLedger::impacts, given.impact * mean);
}

void Audit::endHalf(const WorldState& world) {
    forEachLane(world, [&](const ContactBatch& batch, const ManifoldLanes& manifolds, std::size_t lane) {
        const Lane after(batch, lane, world.bodies.velocity);
        noteContact(Lane::before(batch, lane, start_), after, hits(world, manifolds, lane));
    });
    for (const Given& given : given_) noteGiven(world.bodies, given);
    given_.clear();
    for (const FieldGiven& given : fieldsGiven_) noteGiven(world.bodies, given);
    fieldsGiven_.clear();
}

void Audit::beforeBounces(const WorldState& world) {
    start_ = world.bodies.velocity;
    totals_.clear();
    forEachLane(world, [&](const ContactBatch& batch, const ManifoldLanes&, std::size_t lane) {
        for (const PointLanes& point : batch.points) totals_.push_back(point.totalNormal[lane]);
    });
}

/// What has been given since then is counted in the totals only.
void Audit::afterBounces(const WorldState& world) {
    std::size_t next = 0;
    forEachLane(world, [&](const ContactBatch& batch, const ManifoldLanes&, std::size_t lane) {
        Lane after = Lane::before(batch, lane, world.bodies.velocity);
        for (std::size_t p = 0; p < 2; ++p)
            after.normal[p] = static_cast<double>(batch.points[p].totalNormal[lane] - totals_[next++]);
        noteContact(Lane::before(batch, lane, start_), after, true);
    });
}

void Audit::end(const WorldState& world, const std::vector<BodyIndex>& solved, double dt) {
    for (const BodyIndex body : solved) {
        const BodyRecord& record = world.bodies.record[body];
        if (world.bodies.pushed[body] == 0 || record.type != BodyType::Dynamic) continue;
        note(&EnergyLedger::damping, dampedEnergy_[body]);
        note(&MomentumLedger::damping, dampedMomentum_[body]);
        if (!fieldAccounts_.empty()) noteAccount(fieldAccounts_[body]);
        const SolverDisplacement& moved = world.bodies.displacement[body];
        const Vec2 shift(static_cast<double>(moved.x), static_cast<double>(moved.y));
        const double turn = static_cast<double>(world.bodies.turn[body].angle);
        note(&EnergyLedger::forces, record.force.dot(shift) + record.torque * turn);
        note(&MomentumLedger::forces, record.force * dt);
        note(&MomentumLedger::gravity, record.mass * record.gravityScale * world.def.gravity * dt);
    }
}

}  // namespace plumb
