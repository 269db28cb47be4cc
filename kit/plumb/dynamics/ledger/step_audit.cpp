// SPDX-License-Identifier: MIT
#include <plumb/dynamics/ledger/step_audit.h>

#include <algorithm>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/contacts/contact_point.h>

namespace plumb {

namespace {

Vec2 linearOf(const SolverVelocity& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y)};
}

}  // namespace

/// One contact: its impulses so far, and the velocities of its bodies. Two of them, before and after a half, are what
/// noteContact compares.
struct StepAudit::Lane {
    const ContactBatch& batch;
    std::size_t lane;
    SolverVelocity a, b;
    double normal[2] = {0, 0}, tangent[2] = {0, 0}, roll = 0;

    /// The contact before its first impulse.
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
    // Of a point on A and on B.
    double normalA(std::size_t p) const { return normalAxis(batch, lane, p, false).speedOf(a); }
    double normalB(std::size_t p) const { return normalAxis(batch, lane, p, true).speedOf(b); }
    double tangentA(std::size_t p) const { return tangentAxis(batch, lane, p, false).speedOf(a); }
    double tangentB(std::size_t p) const { return tangentAxis(batch, lane, p, true).speedOf(b); }
    double approach() const { return std::max(normalA(0) - normalB(0), normalA(1) - normalB(1)); }
    double rollA() const { return static_cast<double>(batch.rollInverseGyrationA[lane] * a.w); }
    double rollB() const { return static_cast<double>(batch.rollInverseGyrationB[lane] * b.w); }
};

/// Free motion changes energy only by forces, damping and fields, each with its own entry: gravity only moves energy
/// from one stored form to another. With damping, the whole change that forces do not explain is its work.
void StepAudit::noteFlight(BodyIndex body, const BodyMotion& from, const BodyMotion& to, double time) {
    const BodyRecord& record = bodies_.record[body];
    if (record.type != BodyType::Dynamic) return;
    const double work = record.force.dot(to.center - from.center) + record.torque * (to.angle - from.angle);
    const Vec2 pull = record.mass * record.gravityScale * bodies_.gravity * time, push = record.force * time;
    account_.note(&EnergyLedger::forces, work);
    account_.note(&MomentumLedger::gravity, pull);
    account_.note(&MomentumLedger::forces, push);
    const auto energyAt = [&](const BodyMotion& m) {
        return kineticEnergyOf(record, m.velocity, m.angularVelocity) +
               gravitationalEnergyOf(record, m.center, bodies_.gravity) +
               view_.fields.solver->energyOf({view_.fields, bodies_, view_.space}, body, m);
    };
    const std::uint32_t flight = bodies_.step[body].flight;
    if (flight != none &&
        !bodies_.flights[flight].steady) {  // the causes are entered by noteFieldFlight, at the end of the flight
        account_.note(&EnergyLedger::solver, energyAt(to) - energyAt(from) - work);
        return;
    }
    const Vec2 fields =
        flight != none ? Vec2(record.mass * view_.fields.accounts[flight].steadyPull * time) : Vec2(0, 0);
    account_.note(&MomentumLedger::fields, fields);
    const FlightLaw law = flightLawOf(bodies_, body);
    if (law.linearDamping == 0 && law.angularDamping == 0) return;
    account_.note(&EnergyLedger::damping, energyAt(to) - energyAt(from) - work);
    account_.note(&MomentumLedger::damping, record.mass * (to.velocity - from.velocity) - pull - push - fields);
}

void StepAudit::noteAccount(const FieldAccount& account) {
    account_.note(&EnergyLedger::forces, account.forced);
    account_.note(&EnergyLedger::damping, account.damped);
    account_.note(&EnergyLedger::friction, account.friction);
    account_.note(&MomentumLedger::fields, account.fields);
    account_.note(&MomentumLedger::damping, account.dampedMomentum);
    account_.note(&MomentumLedger::ground, account.frictionMomentum);
}

/// noteFlight has entered the whole change under the solver's entry, as the causes were not known yet: what they
/// explain goes from there to their own entries.
void StepAudit::noteFieldFlight(std::uint32_t flight) {
    const FieldAccount& account = view_.fields.accounts[flight].account;
    noteAccount(account);
    account_.note(&EnergyLedger::solver, -(account.forced + account.damped + account.friction));
}

/// What none of these explains goes to the phase's own entry: for isolated impacts that is EnergyLedger::impacts.
void StepAudit::noteImpact(double friction, double drivers, double bounce, const Vec2& ground) {
    account_.note(&EnergyLedger::friction, friction);
    account_.note(&EnergyLedger::drivers, drivers);
    account_.note(&EnergyLedger::impacts, bounce);
    account_.note(&MomentumLedger::ground, ground);
}

void StepAudit::noteGround(const Vec2& momentum) {
    account_.note(&MomentumLedger::ground, momentum);
}

/// Sums for each body of what the sub-steps do. They are entered at the end, and only for bodies that the solver moved:
/// the others are placed by their closed form, which is entered by noteFlight.
void StepAudit::beginSolver() {
    dampedEnergy_.assign(bodies_.record.size(), 0.0);
    dampedMomentum_.assign(bodies_.record.size(), Vec2(0, 0));
    fieldAccounts_.assign(bodies_.flights.empty() ? 0 : bodies_.record.size(), {});
}

/// Repeats what kickBodies will do, without the warm start: start_ is the velocity before the first impulse of this
/// half, unforced_ before its forces. Damping by the closed form shortens the velocity and weakens the pull; both are
/// its work.
void StepAudit::beginHalf(std::span<const BodyIndex> solved) {
    const double half = 0.5 * bodies_.lastStep / bodies_.subSteps;
    start_ = unforced_ = bodies_.velocity;
    for (const BodyIndex body : solved) {
        const BodyRecord& record = bodies_.record[body];
        if (bodies_.step[body].flight != none) continue;  // entered by noteFieldKick
        SolverVelocity& v = start_[body];
        const Kick& kick = bodies_.kick[body];
        const double inverseGyration = static_cast<double>(bodies_.turn[body].inverseGyration);
        const double before = kineticEnergyOf(record, linearOf(v), static_cast<double>(v.w) * inverseGyration);
        const Vec2 start = linearOf(v);
        v = {v.x * kick.keep.x, v.y * kick.keep.y, v.w * kick.keep.w, v.inverseMass};
        dampedEnergy_[body] +=
            kineticEnergyOf(record, linearOf(v), static_cast<double>(v.w) * inverseGyration) - before;
        dampedMomentum_[body] += record.mass * (linearOf(v) - start);
        const Vec2 gain(static_cast<double>(kick.gain.x), static_cast<double>(kick.gain.y));
        const Vec2 pull = record.mass * record.gravityScale * bodies_.gravity + record.force;
        if (record.linearDamping > 0) dampedMomentum_[body] += record.mass * gain - pull * half;
        v = {v.x + kick.gain.x, v.y + kick.gain.y, v.w + kick.gain.w, v.inverseMass};
    }
}

/// The kick is a change of velocity like any other, so its work needs the velocity at the half's end: it is entered
/// there.
void StepAudit::noteFieldKick(BodyIndex body, const FieldKick& kick, const Vec2& base) {
    SolverVelocity& v = start_[body];
    v.x += static_cast<float>(kick.kept.velocity.x());
    v.y += static_cast<float>(kick.kept.velocity.y());
    v.w += static_cast<float>(kick.kept.spin) * bodies_.turn[body].gyration;
    fieldsGiven_.push_back({body, kick, base});
}

void StepAudit::noteGiven(const FieldGiven& given) {
    const double inverseGyration = static_cast<double>(bodies_.turn[given.body].inverseGyration);
    const SolverVelocity &then = start_[given.body], &now = bodies_.velocity[given.body];
    const VelocityChange mean{0.5 * (linearOf(then) + linearOf(now)),
                              0.5 * inverseGyration * static_cast<double>(then.w + now.w)};
    fieldAccounts_[given.body].add(bodies_.record[given.body], given.kick, mean, given.base);
}

/// The work of one contact's impulses, by the mean of the speeds before and after the half. Along the tangent it is
/// friction's. Along the normal it is an impact's if the bodies came fast; else it is left to the solver's entry, as
/// the pressure of what rests. Momentum comes in only where one of the two bodies cannot be pushed.
void StepAudit::noteContact(const Lane& before, const Lane& after, bool hits) {
    const ContactBatch& batch = after.batch;
    const double belt = batch.hasSurfaceSpeed ? static_cast<double>(batch.surfaceSpeed[after.lane]) : 0.0;
    const bool pushA = after.a.inverseMass > 0, pushB = after.b.inverseMass > 0;
    double friction = 0, impacts = 0, drivers = 0;
    const Vec2 n = normalAt(batch, after.lane);
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
        // A body that cannot be pushed does work on the one that can.
        if (!pushA) drivers += normal * na + tangent * ta;
        if (!pushB) drivers -= normal * nb + tangent * tb;
        impulse += n * normal + perp(n) * tangent;
    }
    if (batch.hasRollingResistance) {
        const double roll = after.roll - before.roll;
        const double ra = 0.5 * (before.rollA() + after.rollA()), rb = 0.5 * (before.rollB() + after.rollB());
        friction += roll * (rb - ra);
        if (!pushA) drivers += roll * ra;
        if (!pushB) drivers -= roll * rb;
    }
    account_.note(&EnergyLedger::friction, friction);
    account_.note(&EnergyLedger::drivers, drivers);
    if (hits) account_.note(&EnergyLedger::impacts, impacts);
    if (pushA != pushB) account_.note(&MomentumLedger::ground, pushB ? impulse : Vec2(-impulse));
}

/// Rows belong to one pass of the joint solver, so the few numbers that are needed at the half's end are copied.
StepAudit::Given StepAudit::givenBy(const JointRows& rows, std::size_t row, double impulse) {
    Given given;
    given.body = rows.body;
    given.all = impulse;
    for (std::size_t e = 0; e < rows.ends; ++e) given.at[e] = rows.at(row, e);
    return given;
}

/// Splits a row's impulse by cause. A row that only holds does no work. A damper's part falls with the speed; a motor's
/// part is what lies between its bounds; what is beyond these came from a limit, and is an impact. Springs need no
/// entry: their energy is stored.
void StepAudit::noteRows(const JointRows& rows, const Vec3& impulses, const Vec3& after, const Vec3& slopes) {
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

/// Of a bounce that passes through joints: whole an impact.
void StepAudit::noteRowImpact(const JointRows& rows, double impulse) {
    given_.push_back(givenBy(rows, 0, impulse));
    given_.back().impact = impulse;
}

/// At the half's end, when all impulses of the half have acted (see the header).
void StepAudit::noteGiven(const Given& given) {
    double mean = 0, driven = 0;
    for (std::size_t e = 0; e < maxEnds; ++e) {
        const BodyIndex body = given.body[e];
        const Vec3& at = given.at[e];
        const SolverVelocity& now = bodies_.velocity[body];
        const auto speedOf = [&](const SolverVelocity& v) {
            return linearOf(v).dot(Vec2(at[0], at[1])) +
                   at[2] * (static_cast<double>(v.w) * static_cast<double>(bodies_.turn[body].inverseGyration));
        };
        mean += 0.5 * (speedOf(start_[body]) + speedOf(now));
        if (now.inverseMass == 0) driven += speedOf(now);
    }
    account_.note(&EnergyLedger::drivers, -given.all * driven);
    account_.note(&EnergyLedger::damping, given.damper * mean);
    account_.note(&EnergyLedger::motors, given.motor * mean);
    account_.note(&EnergyLedger::impacts, given.impact * mean);
}

/// Is it the contact of a disc that slides along a chain? The solver does not move it, and noteSlide enters its
/// changes.
bool StepAudit::isAlongChain(const ContactBatch& batch, std::size_t lane) const {
    return bodies_.isMovedBy(batch.bodyA[lane], MovedBy::Chain) || bodies_.isMovedBy(batch.bodyB[lane], MovedBy::Chain);
}

/// Contacts, then joints, then fields: all with the same two velocities, before and after the half.
void StepAudit::endHalf() {
    view_.graph.forEachLane([&](const ConstContactLane& at, ContactIndex) {
        const Lane before = Lane::before(at.batch, at.lane, start_), after(at.batch, at.lane, bodies_.velocity);
        const Lane unforced = Lane::before(at.batch, at.lane, unforced_);
        if (isAlongChain(at.batch, at.lane)) return;
        noteContact(before, after,
                    hits(static_cast<double>(at.manifolds.approachSpeed[at.lane])) || hits(unforced.approach()));
    });
    for (const Given& given : given_) noteGiven(given);
    given_.clear();
    for (const FieldGiven& given : fieldsGiven_) noteGiven(given);
    fieldsGiven_.clear();
}

/// Is the approach faster than what gravity makes of rest in two steps? The approach is that at the step's start, or
/// that before a half of a sub-step: joints and other impacts may have turned a body towards what it then hits.
bool StepAudit::hits(double approach) const {
    return approach > 2 * bodies_.gravity.norm() * bodies_.lastStep + 1e-3;
}

/// As beginHalf; the totals of all points are copied, because bounce adds to them only.
void StepAudit::beginBounces() {
    start_ = bodies_.velocity;
    totals_.clear();
    view_.graph.forEachLane([&](const ConstContactLane& at, ContactIndex) {
        for (const PointLanes& point : at.batch.points) totals_.push_back(point.totalNormal[at.lane]);
    });
}

/// The bounces' impulses are counted in the totals only.
void StepAudit::endBounces() {
    std::size_t next = 0;
    view_.graph.forEachLane([&](const ConstContactLane& at, ContactIndex) {
        Lane after = Lane::before(at.batch, at.lane, bodies_.velocity);
        for (std::size_t p = 0; p < 2; ++p)
            after.normal[p] = static_cast<double>(at.batch.points[p].totalNormal[at.lane] - totals_[next++]);
        if (!isAlongChain(at.batch, at.lane)) noteContact(Lane::before(at.batch, at.lane, start_), after, true);
    });
}

/// The work of a force is that along the real path, and its momentum that of the whole step.
void StepAudit::endSolver(std::span<const BodyIndex> solved, double dt) {
    for (const BodyIndex body : solved) {
        const BodyRecord& record = bodies_.record[body];
        if (!bodies_.isMovedBy(body, MovedBy::Solver) || record.type != BodyType::Dynamic) continue;
        account_.note(&EnergyLedger::damping, dampedEnergy_[body]);
        account_.note(&MomentumLedger::damping, dampedMomentum_[body]);
        if (!fieldAccounts_.empty()) noteAccount(fieldAccounts_[body]);
        const SolverDisplacement& moved = bodies_.displacement[body];
        const Vec2 shift(static_cast<double>(moved.x), static_cast<double>(moved.y));
        const double turn = static_cast<double>(bodies_.turn[body].angle);
        account_.note(&EnergyLedger::forces, record.force.dot(shift) + record.torque * turn);
        account_.note(&MomentumLedger::forces, record.force * dt);
        account_.note(&MomentumLedger::gravity, record.mass * record.gravityScale * bodies_.gravity * dt);
    }
}

}  // namespace plumb
