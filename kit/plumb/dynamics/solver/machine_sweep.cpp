// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/machine_sweep.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/contacts/contact_graph.h>
#include <plumb/dynamics/joints/joint_response.h>
#include <plumb/dynamics/joints/solve_island.h>

namespace plumb {

namespace {

/// Overlap is pushed out as firmly as with this share of the masses of both parts; by an effective mass that is larger,
/// as where joints keep a body in its place, bodies that are jammed would be torn apart [-].
constexpr double softShare = 0.1;
/// Most sweeps over the contacts in a round, and most rounds of contacts and joints.
constexpr int mostSweeps = 40, mostRounds = 4;
/// A sweep, or a round, that changes speeds by less than this is the last one [m/s].
constexpr std::size_t notFound = ~std::size_t{0};
constexpr double still = 1e-6, stillInRound = 1e-4;

Vec2 momentumOf(const JointIsland& island, const BodyStore& bodies, const std::vector<Vec3>& velocities) {
    Vec2 sum(0, 0);
    for (std::size_t b = 0; b < velocities.size(); ++b)
        sum += bodies.record[island.bodies[b]].mass * Vec2(velocities[b][0], velocities[b][1]);
    return sum;
}

}  // namespace

MachineSweep::MachineSweep(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                           const MachineContacts& machines, const MachinePass& pass)
    : stores_(stores),
      graph_(graph),
      contacts_(contacts),
      machines_(machines),
      pass_(pass),
      joints_(directPass(stores.settings, pass.half)) {}

void MachineSweep::run() {
    for (const MachineContact& machine : machines_.contacts) addRows(machine);
    noteBounces();
    for (int round = 0; round < mostRounds; ++round) {
        load();
        findAnswers();
        sweep();
        if (!solveJoints()) break;
    }
    accept();
    storeImpulses();
}

void MachineSweep::addRows(const MachineContact& machine) {
    const ContactRecord& contact = contacts_[machine.contact];
    const ContactBatch& batch = graph_.colours[contact.colour].batches[contact.slot / batchLanes];
    const std::size_t lane = contact.slot % batchLanes;
    const int colour = colourAt(contact.colour);
    const double nx = static_cast<double>(batch.normalX[lane]), ny = static_cast<double>(batch.normalY[lane]);
    const auto armOf = [&](BodyIndex body, float anchor) {
        const float inverseGyration = stores_.bodies.turn[body].inverseGyration;
        return inverseGyration > 0 ? static_cast<double>(anchor / inverseGyration) : 0.0;
    };
    Rows& rows = rows_.emplace_back();
    rows.friction = static_cast<double>(batch.friction[lane]);
    rows.rollingArm = static_cast<double>(batch.rollingArm[lane]);
    rows.ground = colour >= fixedColour && colour != overflowColour;
    const BodyIndex a = contact.bodyA, b = contact.bodyB;
    for (std::size_t p = 0; p < 2; ++p) {
        const PointLanes& point = batch.points[p];
        if (!(machine.normalMass[p] > 0)) continue;
        rows.separation[p] = static_cast<double>(point.separation[lane]);
        rows.row[p] = rowOf(machine, contact, {-nx, -ny, armOf(a, point.anchorTangentA[lane])},
                            {nx, ny, -armOf(b, point.anchorTangentB[lane])}, machine.normal[p]);
        rows.row[2 + p] = rowOf(machine, contact, {ny, -nx, -armOf(a, point.anchorNormalA[lane])},
                                {-ny, nx, armOf(b, point.anchorNormalB[lane])}, machine.tangent[p]);
        if (batch.hasSurfaceSpeed) rows.row[2 + p].fixedSpeed += static_cast<double>(batch.surfaceSpeed[lane]);
    }
    if (rows.rollingArm > 0 && machine.rollMass > 0)
        rows.row[4] = rowOf(machine, contact, {0, 0, -1}, {0, 0, 1}, machine.roll);
}

MachineSweep::Row MachineSweep::rowOf(const MachineContact& machine, const ContactRecord& contact, const Vec3& pushA,
                                      const Vec3& pushB, float start) const {
    Row row;
    row.a = {machine.a.part, machine.a.node, contact.bodyA, pushA, 0};
    row.b = {machine.b.part, machine.b.node, contact.bodyB, pushB, 0};
    for (const End* end : {&row.a, &row.b})
        if (end->part == none) row.fixedSpeed += dot(end->push, velocityOf(stores_.bodies, end->body));
    row.inverseMass = 1;
    row.start = row.impulse = static_cast<double>(start);
    row.given = pass_.half.correct ? 0.0 : row.start;
    return row;
}

/// Velocities without the impulses of joints. Since the first try, bounces may have changed velocities; the joints are
/// then tried again.
void MachineSweep::noteBounces() {
    for (const MachinePart& part : machines_.parts) {
        before_.emplace_back();
        if (part.island == nullptr) continue;
        JointIsland& island = *part.island;
        std::vector<Vec3>& before = before_.back() = island.trial.before;
        const std::vector<Vec3> now = velocitiesOf(island, stores_.bodies);
        if (now == island.trial.after) continue;
        for (std::size_t b = 0; b < now.size(); ++b)
            for (std::size_t i = 0; i < 3; ++i) before[b][i] += now[b][i] - island.trial.after[b][i];
        tryIsland(island, stores_.joints, stores_.bodies, before, joints_);
    }
}

void MachineSweep::load() {
    velocities_.clear();
    for (const MachinePart& part : machines_.parts) {
        if (part.island != nullptr)
            velocities_.push_back(velocitiesOf(*part.island, stores_.bodies));
        else
            velocities_.push_back({velocityOf(stores_.bodies, part.body)});
    }
}

void MachineSweep::findAnswers() {
    if (sameStates_) return;
    answers_.clear();
    units_.clear();
    unitsAt_.clear();
    for (const std::vector<Vec3>& velocities : velocities_) unitsAt_.emplace_back(velocities.size(), notFound);
    for (Rows& rows : rows_) {
        rows.mass = softMass(rows.row[0]);
        for (Row& row : rows.row) {
            if (row.inverseMass == 0) continue;
            row.inverseMass = 0;
            findAnswer(row, row.a, row.b);
            if (row.b.part != row.a.part) findAnswer(row, row.b, row.a);
        }
    }
}

/// The answer of the part to which an end belongs; if the other end belongs to it, too, then to both.
void MachineSweep::findAnswer(Row& row, End& end, const End& other) {
    if (end.part == none) return;
    const bool both = other.part == end.part;
    end.answer = answers_.size();
    answers_.resize(answers_.size() + velocities_[end.part].size(), Vec3{});
    const std::span<Vec3> answer(answers_.data() + end.answer, velocities_[end.part].size());
    addAnswer(answer, end);
    if (both) addAnswer(answer, other);
    row.inverseMass += dot(end.push, answer[end.node]);
    if (both) row.inverseMass += dot(other.push, answer[other.node]);
    row.inverseMass = std::max(row.inverseMass, 0.0);
}

void MachineSweep::addAnswer(std::span<Vec3> answer, const End& end) {
    const std::span<const Vec3> units = unitAnswers(end.part, end.node, end.body);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t b = 0; b < answer.size(); ++b)
            add(answer[b], times(units[i * answer.size() + b], end.push[i]));
}

/// The answers of a part to unit impulses on one of its bodies, one after the other.
std::span<const Vec3> MachineSweep::unitAnswers(std::uint32_t part, std::uint32_t node, BodyIndex body) {
    const std::size_t count = velocities_[part].size();
    std::size_t& at = unitsAt_[part][node];
    if (at != notFound) return {units_.data() + at, 3 * count};
    at = units_.size();
    units_.resize(units_.size() + 3 * count, Vec3{});
    for (std::size_t i = 0; i < 3; ++i) {
        const std::span<Vec3> unit(units_.data() + at + i * count, count);
        Vec3 push{};
        push[i] = 1;
        unit[node] = velocityChangeBy(stores_.bodies, body, push);
        if (machines_.parts[part].island != nullptr) followJoints(*machines_.parts[part].island, unit);
    }
    return {units_.data() + at, 3 * count};
}

double MachineSweep::softMass(const Row& row) const {
    double mass = 0;
    for (const End* end : {&row.a, &row.b}) {
        if (end->part == none) continue;
        const MachinePart& part = machines_.parts[end->part];
        if (part.island == nullptr) {
            mass += stores_.bodies.record[part.body].mass;
            continue;
        }
        for (const BodyIndex body : part.island->bodies) mass += stores_.bodies.record[body].mass;
    }
    return mass * softShare;
}

void MachineSweep::sweep() {
    for (int turn = 0; turn < mostSweeps; ++turn) {
        double most = 0;
        for (Rows& rows : rows_) most = std::max(most, solveContact(rows));
        if (most < still) return;
    }
}

/// Returns the greatest change of a speed [m/s].
double MachineSweep::solveContact(Rows& rows) {
    double most = 0, normal = 0;
    for (std::size_t p = 0; p < 2; ++p) {
        const double old = rows.row[p].impulse;
        solveNormal(rows, p);
        most = std::max(most, std::fabs(rows.row[p].impulse - old) * rows.row[p].inverseMass);
        normal += rows.row[p].given + rows.row[p].impulse;
    }
    for (std::size_t p = 0; p < 2; ++p)
        solveWithin(rows.row[2 + p], rows.friction * (rows.row[p].given + rows.row[p].impulse), most);
    solveWithin(rows.row[4], rows.rollingArm * normal, most);
    return most;
}

/// As in contacts/lanes/contact_solver.cpp, with the effective mass of the whole machine.
void MachineSweep::solveNormal(Rows& rows, std::size_t point) {
    Row& row = rows.row[point];
    if (!(row.inverseMass > 0)) return;
    const double s = rows.separation[point], mass = 1 / row.inverseMass;
    const ContactPass& pass = rows.ground ? pass_.groundContacts : pass_.contacts;
    const double inverseStep = static_cast<double>(pass.inverseStep);
    if (!pass_.half.correct || s > 0) {
        const double change = -mass * (speedOf(row) + std::max(s, 0.0) * inverseStep);
        setImpulse(row, std::max(row.impulse + change, -row.given));
        return;
    }
    const double bias = std::max(static_cast<double>(pass.soft.biasRate) * s, -static_cast<double>(pass.pushSpeed));
    // v + bias + give L = 0
    const double give =
        static_cast<double>(pass.soft.impulseScale / pass.soft.massScale) * std::max(row.inverseMass, 1 / rows.mass);
    const double change = -(speedOf(row) + bias + give * row.impulse) / (row.inverseMass + give);
    setImpulse(row, std::max(row.impulse + change, 0.0));
}

/// Stops the row, if an impulse within the limit can.
void MachineSweep::solveWithin(Row& row, double limit, double& most) {
    if (!(row.inverseMass > 0)) return;
    const double old = row.impulse;
    const double wanted = old - speedOf(row) / row.inverseMass;
    setImpulse(row, std::max(std::min(wanted, limit - row.given), -limit - row.given));
    most = std::max(most, std::fabs(row.impulse - old) * row.inverseMass);
}

void MachineSweep::setImpulse(Row& row, double impulse) {
    const double change = impulse - row.impulse;
    row.impulse = impulse;
    if (change == 0) return;
    apply(row.a, change);
    if (row.b.part != row.a.part) apply(row.b, change);
}

void MachineSweep::apply(const End& end, double impulse) {
    if (end.part == none) return;
    std::vector<Vec3>& velocities = velocities_[end.part];
    const Vec3* answer = answers_.data() + end.answer;
    for (std::size_t b = 0; b < velocities.size(); ++b)
        for (std::size_t i = 0; i < 3; ++i) velocities[b][i] += answer[b][i] * impulse;
}

double MachineSweep::speedOf(const Row& row) const {
    double speed = row.fixedSpeed;
    for (const End* end : {&row.a, &row.b})
        if (end->part != none) speed += dot(end->push, velocities_[end->part][end->node]);
    return speed;
}

/// For each machine: velocities with these contacts' impulses, and without the joints'.
std::vector<std::vector<Vec3>> MachineSweep::withoutJoints() const {
    std::vector<std::vector<Vec3>> velocities = before_;
    for (const Rows& rows : rows_) {
        for (const Row& row : rows.row) {
            for (const End* end : {&row.a, &row.b}) {
                if (end->part == none || velocities[end->part].empty()) continue;
                add(velocities[end->part][end->node],
                    times(velocityChangeBy(stores_.bodies, end->body, end->push), row.impulse - row.start));
            }
        }
    }
    return velocities;
}

/// Solves the joints again, from the contacts' impulses. Returns true if the contacts' speeds are others by that.
bool MachineSweep::solveJoints() {
    const std::vector<std::vector<Vec3>> before = withoutJoints();
    bool changed = false;
    for (std::size_t p = 0; p < machines_.parts.size(); ++p) {
        const MachinePart& part = machines_.parts[p];
        if (part.island == nullptr) {
            setVelocity(stores_.bodies, part.body, velocities_[p].front());
            continue;
        }
        for (std::size_t b = 0; b < part.island->bodies.size(); ++b)
            setVelocity(stores_.bodies, part.island->bodies[b], velocities_[p][b]);
        changed = tryIsland(*part.island, stores_.joints, stores_.bodies, before[p], joints_) || changed;
    }
    sameStates_ = !changed;
    std::vector<double> speeds;
    for (const Rows& rows : rows_)
        for (const Row& row : rows.row) speeds.push_back(speedOf(row));
    load();
    auto speed = speeds.begin();
    for (const Rows& rows : rows_)
        for (const Row& row : rows.row) changed = changed || std::fabs(speedOf(row) - *speed++) > stillInRound;
    return changed;
}

/// Reports the joints' impulses. They are no contact impulses, so they are kept out of the contacts' next first guess.
void MachineSweep::accept() {
    const std::vector<std::vector<Vec3>> before = withoutJoints();
    BodyStore& bodies = stores_.bodies;
    for (std::size_t p = 0; p < machines_.parts.size(); ++p) {
        const MachinePart& part = machines_.parts[p];
        if (part.island == nullptr) continue;
        JointIsland& island = *part.island;
        const std::vector<Vec3> now = velocitiesOf(island, bodies);
        if (stores_.observer != nullptr)
            stores_.observer->noteGround(momentumOf(island, bodies, now) - momentumOf(island, bodies, before[p]));
        acceptIsland(island, stores_.joints, bodies, pass_.half.step, stores_.observer);
        for (std::size_t b = 0; b < island.bodies.size(); ++b) {
            const BodyIndex body = island.bodies[b];
            SolverVelocity& mark = bodies.before[body];
            Vec3 unpushed = now[b];
            for (std::size_t i = 0; i < 3; ++i) unpushed[i] -= before[p][b][i] - before_[p][b][i];
            mark.x = static_cast<float>(unpushed[0]);
            mark.y = static_cast<float>(unpushed[1]);
            mark.w = static_cast<float>(unpushed[2] * static_cast<double>(bodies.turn[body].gyration));
        }
    }
}

void MachineSweep::storeImpulses() const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Rows& rows = rows_[i];
        const ContactRecord& contact = contacts_[machines_.contacts[i].contact];
        ContactBatch& batch = graph_.colours[contact.colour].batches[contact.slot / batchLanes];
        const std::size_t lane = contact.slot % batchLanes;
        for (std::size_t p = 0; p < 2; ++p) {
            PointLanes& point = batch.points[p];
            const Row &normal = rows.row[p], &tangent = rows.row[2 + p];
            point.normalImpulse[lane] = static_cast<float>(normal.impulse);
            point.tangentImpulse[lane] = static_cast<float>(tangent.impulse);
            if (pass_.half.correct) continue;
            point.totalNormal[lane] += static_cast<float>(normal.given + normal.impulse);
            point.totalTangent[lane] += static_cast<float>(tangent.given + tangent.impulse);
            if (normal.given > 0 || normal.impulse > 0) batch.pushed[lane] = -1;
        }
        batch.rollImpulse[lane] = static_cast<float>(rows.row[4].impulse);
    }
}

}  // namespace plumb
