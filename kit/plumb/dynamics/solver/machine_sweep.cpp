// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/machine_sweep.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/joints/joint_response.h>

namespace plumb {

namespace {

/// Overlap is pushed out as firmly as with this share of the masses of both parts; by an effective mass that is larger,
/// as where joints keep a body in its place, bodies that are jammed would be torn apart [-].
constexpr double softShare = 0.1;
/// Most sweeps over the contacts in a round, and most rounds of contacts and joints; where there are more than a few
/// machines, as in a heap of dolls, fewer must do.
constexpr int mostSweeps = 40, mostRounds = 4, fewRounds = 2, fewMachines = 2;
/// Compliance of a row, relative to the effective inverse mass of its bodies alone. It is larger than that of joints: a
/// contact that only the joints' compliance lets move would get impulses without bounds [-].
constexpr double rowCompliance = 2e-5;
/// In the first sweeps of a round, friction follows the normal impulses; then its limits stay. If it always followed,
/// both could grow without end where bodies are jammed.
constexpr int limitedSweeps = 4;
constexpr std::size_t notFound = ~std::size_t{0};
/// A sweep, or a round, that changes speeds by less than this share of the fastest, or of 1 m/s, is the last one [-].
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
      joints_{pass.half.step, pass.half.correct, false, stores.settings.contactPushSpeed} {}

void MachineSweep::run() {
    for (const MachineContact& machine : machines_.contacts)
        rows_.push_back(rowsOf(machine, graph_, contacts_[machine.contact], stores_.bodies, pass_.half));
    guess_ = impulses();
    findBefore();
    load();
    tried_ = velocities_;
    for (const std::vector<Vec3>& velocities : velocities_)
        for (const Vec3& v : velocities) scale_ = std::max({scale_, std::fabs(v[0]), std::fabs(v[1])});
    const auto isMachine = [](const MachinePart& part) { return part.island != nullptr; };
    const bool few = std::count_if(machines_.parts.begin(), machines_.parts.end(), isMachine) <= fewMachines;
    for (int round = 0; round < (few ? mostRounds : fewRounds); ++round) {
        findAnswers();
        sweep();
        if (!solveJoints()) break;
    }
    dropIfUseless();
    accept();
    for (std::size_t i = 0; i < rows_.size(); ++i)
        storeRows(machines_.contacts[i], rows_[i], graph_, contacts_[machines_.contacts[i].contact], pass_.half);
}

/// Finds the velocities without the impulses of joints. They have changed since the first try where there were bounces,
/// and where the first guess of the contacts' impulses has acted on other masses than it does here: then the joints are
/// tried again.
void MachineSweep::findBefore() {
    for (const MachinePart& part : machines_.parts) {
        if (part.island != nullptr)
            before_.push_back(part.island->trial.before);
        else
            before_.push_back({velocityOf(stores_.bodies, part.body)});
    }
    for (std::size_t p = 0; p < machines_.parts.size(); ++p) {
        if (machines_.parts[p].island == nullptr) continue;
        JointIsland& island = *machines_.parts[p].island;
        const std::vector<Vec3> now = velocitiesOf(island, stores_.bodies);
        bool changed = false;
        for (std::size_t b = 0; b < now.size(); ++b) {
            const Vec3 acted = velocityChangeBy(stores_.bodies, island.bodies[b], guess_[p][b]);
            Vec3 other = changeBy(p, b, guess_[p][b]), bounced = now[b];
            subtract(other, acted);
            subtract(bounced, island.trial.after[b]);
            if (dot(other, other) < 1e-10 * dot(acted, acted)) other = {};
            changed = changed || other != Vec3{} || bounced != Vec3{};
            add(before_[p][b], other);
            add(before_[p][b], bounced);
        }
        if (changed) island.batch->tryFrom(stores_.bodies, before_[p], joints_);
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
    for (MachineRows& rows : rows_) {
        const double own = std::max(rows.row[0].ownInverseMass, rows.row[1].ownInverseMass);
        double mass = 0;
        for (const MachineEnd* end : {&rows.row[0].a, &rows.row[0].b})
            if (end->part != none) mass += massOf(machines_.parts[end->part]);
        rows.softMass = std::max(1 / own, softShare * mass);
        for (MachineRow& row : rows.row) {
            if (row.inverseMass == 0) continue;
            row.inverseMass = 0;
            findAnswer(row, row.a, row.b);
            if (row.b.part != row.a.part) findAnswer(row, row.b, row.a);
        }
    }
}

/// The answer of the part to which an end belongs; if the other end belongs to it, too, then to both.
void MachineSweep::findAnswer(MachineRow& row, MachineEnd& end, const MachineEnd& other) {
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

void MachineSweep::addAnswer(std::span<Vec3> answer, const MachineEnd& end) {
    const std::span<const Vec3> units = unitAnswers(end.part, end.node);
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t b = 0; b < answer.size(); ++b)
            add(answer[b], times(units[i * answer.size() + b], end.push[i]));
}

/// The change of a body's velocity by an impulse, without the joints'. A machine's bodies may have more mass than their
/// own (see joints/lanes/island_stiffness_wide.h); contacts must act on the same masses as joints, or they would add
/// energy.
Vec3 MachineSweep::changeBy(std::size_t part, std::size_t node, const Vec3& push) const {
    const JointIsland* island = machines_.parts[part].island;
    if (island == nullptr) return velocityChangeBy(stores_.bodies, machines_.parts[part].body, push);
    return island->batch->changeBy(island->lane, node, push);
}

/// The answers of a part to unit impulses on one of its bodies, one after the other.
std::span<const Vec3> MachineSweep::unitAnswers(std::uint32_t part, std::uint32_t node) {
    const std::size_t count = velocities_[part].size();
    std::size_t& at = unitsAt_[part][node];
    if (at != notFound) return {units_.data() + at, 3 * count};
    at = units_.size();
    units_.resize(units_.size() + 3 * count, Vec3{});
    for (std::size_t i = 0; i < 3; ++i) {
        const std::span<Vec3> unit(units_.data() + at + i * count, count);
        Vec3 push{};
        push[i] = 1;
        unit[node] = changeBy(part, node, push);
        if (machines_.parts[part].island != nullptr) machines_.parts[part].island->batch->follow(unit);
    }
    return {units_.data() + at, 3 * count};
}

double MachineSweep::massOf(const MachinePart& part) const {
    if (part.island == nullptr) return stores_.bodies.record[part.body].mass;
    double mass = 0;
    for (const BodyIndex body : part.island->bodies) mass += stores_.bodies.record[body].mass;
    return mass;
}

void MachineSweep::sweep() {
    for (int turn = 0; turn < mostSweeps; ++turn) {
        double most = 0;
        for (MachineRows& rows : rows_) most = std::max(most, solveContact(rows, turn < limitedSweeps));
        if (most < still * scale_) return;
    }
}

/// Returns the greatest change of a speed [m/s].
double MachineSweep::solveContact(MachineRows& rows, bool findLimits) {
    double most = 0, normal = 0;
    for (std::size_t p = 0; p < 2; ++p) {
        const double old = rows.row[p].impulse;
        solveNormal(rows, p);
        most = std::max(most, std::fabs(rows.row[p].impulse - old) * rows.row[p].inverseMass);
        normal += rows.row[p].given + rows.row[p].impulse;
        if (findLimits) rows.row[2 + p].limit = rows.friction * (rows.row[p].given + rows.row[p].impulse);
    }
    if (findLimits) rows.row[4].limit = rows.rollingArm * normal;
    for (std::size_t r = 2; r < rows.row.size(); ++r) solveWithin(rows.row[r], most);
    return most;
}

/// As in contacts/lanes/contact_solver.cpp, with the effective mass of the whole machine.
void MachineSweep::solveNormal(MachineRows& rows, std::size_t point) {
    MachineRow& row = rows.row[point];
    const double s = rows.separation[point];
    const ContactPass& pass = rows.ground ? pass_.groundContacts : pass_.contacts;
    const bool soft = pass_.half.correct && s <= 0;
    double bias = std::max(s, 0.0) * static_cast<double>(pass.inverseStep), give = 0;
    if (soft) {
        bias = std::max(static_cast<double>(pass.soft.biasRate) * s, -static_cast<double>(pass.pushSpeed));
        give = static_cast<double>(pass.soft.impulseScale / pass.soft.massScale) *
               std::max(row.inverseMass, 1 / rows.softMass);
    }
    setImpulse(row, std::max(wantedImpulse(row, bias, give), -row.given));
}

/// Stops the row, if an impulse within the limit can.
void MachineSweep::solveWithin(MachineRow& row, double& most) {
    const double old = row.impulse, wanted = wantedImpulse(row, 0, 0);
    setImpulse(row, std::max(std::min(wanted, row.limit - row.given), -row.limit - row.given));
    most = std::max(most, std::fabs(row.impulse - old) * row.inverseMass);
}

/// The impulse L with which the speed is v = -bias - give L.
double MachineSweep::wantedImpulse(const MachineRow& row, double bias, double give) const {
    if (!(row.inverseMass > 0)) return 0;
    give = std::max(give, rowCompliance * row.ownInverseMass);
    return row.impulse - (speedOf(row) + bias + give * row.impulse) / (row.inverseMass + give);
}

void MachineSweep::setImpulse(MachineRow& row, double impulse) {
    const double change = impulse - row.impulse;
    row.impulse = impulse;
    if (change == 0) return;
    apply(row.a, change);
    if (row.b.part != row.a.part) apply(row.b, change);
}

void MachineSweep::apply(const MachineEnd& end, double impulse) {
    if (end.part == none) return;
    std::vector<Vec3>& velocities = velocities_[end.part];
    const Vec3* answer = answers_.data() + end.answer;
    for (std::size_t b = 0; b < velocities.size(); ++b)
        for (std::size_t i = 0; i < 3; ++i) velocities[b][i] += answer[b][i] * impulse;
}

double MachineSweep::speedOf(const MachineRow& row) const {
    double speed = row.fixedSpeed;
    for (const MachineEnd* end : {&row.a, &row.b})
        if (end->part != none) speed += dot(end->push, velocities_[end->part][end->node]);
    return speed;
}

/// The contacts' impulses on each body: x, y, turning.
std::vector<std::vector<Vec3>> MachineSweep::impulses() const {
    std::vector<std::vector<Vec3>> impulses;
    for (const MachinePart& part : machines_.parts)
        impulses.emplace_back(part.island != nullptr ? part.island->bodies.size() : 1, Vec3{});
    for (const MachineRows& rows : rows_)
        for (const MachineRow& row : rows.row)
            for (const MachineEnd* end : {&row.a, &row.b})
                if (end->part != none) add(impulses[end->part][end->node], times(end->push, row.impulse));
    return impulses;
}

/// The same, less those of the first guess, which have acted already.
std::vector<std::vector<Vec3>> MachineSweep::pushes() const {
    std::vector<std::vector<Vec3>> pushes = impulses();
    for (std::size_t p = 0; p < pushes.size(); ++p)
        for (std::size_t b = 0; b < pushes[p].size(); ++b) subtract(pushes[p][b], guess_[p][b]);
    return pushes;
}

/// Velocities with these contacts' impulses, and without the joints'.
std::vector<std::vector<Vec3>> MachineSweep::withoutJoints() const {
    std::vector<std::vector<Vec3>> velocities = before_;
    const std::vector<std::vector<Vec3>> pushed = pushes();
    for (std::size_t p = 0; p < machines_.parts.size(); ++p) {
        for (std::size_t b = 0; b < velocities[p].size(); ++b) add(velocities[p][b], changeBy(p, b, pushed[p][b]));
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
        changed = part.island->batch->tryFrom(stores_.bodies, before[p], joints_) || changed;
    }
    sameStates_ = !changed;
    std::vector<double> speeds;
    for (const MachineRows& rows : rows_)
        for (const MachineRow& row : rows.row) speeds.push_back(speedOf(row));
    load();
    auto speed = speeds.begin();
    for (const MachineRows& rows : rows_)
        for (const MachineRow& row : rows.row)
            changed = changed || std::fabs(speedOf(row) - *speed++) > stillInRound * scale_;
    return changed;
}

/// Kinetic energy [J].
double MachineSweep::energyOf(const std::vector<std::vector<Vec3>>& velocities) const {
    double energy = 0;
    for (std::size_t p = 0; p < machines_.parts.size(); ++p) {
        const MachinePart& part = machines_.parts[p];
        for (std::size_t b = 0; b < velocities[p].size(); ++b) {
            const BodyRecord& body = stores_.bodies.record[part.island != nullptr ? part.island->bodies[b] : part.body];
            const Vec3& v = velocities[p][b];
            energy += 0.5 * (body.mass * (v[0] * v[0] + v[1] * v[1]) + body.inertia * v[2] * v[2]);
        }
    }
    return energy;
}

/// The energy that contacts may give, where they push out overlap, or where a body that cannot be pushed drives them.
double MachineSweep::givenEnergy() const {
    double mass = 0, fastest = 0;
    for (const MachineRows& rows : rows_)
        for (const MachineRow& row : rows.row) fastest = std::max(fastest, std::fabs(row.fixedSpeed));
    for (const MachinePart& part : machines_.parts) mass += massOf(part);
    const double given = static_cast<double>(pass_.contacts.pushSpeed) + 2 * fastest;
    return 0.5 * mass * given * given;
}

/// Apart from that, contacts take energy. At speeds without measure, or in joints that contradict each other, a
/// solution may not be one, and give it: then the contacts give no impulses, and the joints have the last word. What
/// joints give without contacts, as motors do, is allowed.
void MachineSweep::dropIfUseless() {
    const double energy = energyOf(velocities_), given = givenEnergy();
    const std::vector<MachineRows> solved = rows_;
    for (MachineRows& rows : rows_)
        for (MachineRow& row : rows.row) row.impulse = 0;
    const std::vector<std::vector<Vec3>> free = withoutJoints();
    if (energy <= 1.01 * energyOf(free) + given) {
        rows_ = solved;
        return;
    }
    const std::vector<std::vector<Vec3>> velocities = velocities_;
    velocities_ = tried_;
    for (std::size_t p = 0; p < machines_.parts.size(); ++p)
        if (machines_.parts[p].island == nullptr) velocities_[p] = free[p];
    solveJoints();
    if (!(energy <= 1.5 * energyOf(velocities_) + given)) return;
    rows_ = solved;
    velocities_ = velocities;
    solveJoints();
}

/// Reports the joints' impulses. They are no contact impulses, so they are kept out of the contacts' next first guess.
void MachineSweep::accept() {
    const std::vector<std::vector<Vec3>> before = withoutJoints(), pushed = pushes();
    BodyStore& bodies = stores_.bodies;
    for (std::size_t p = 0; p < machines_.parts.size(); ++p) {
        if (machines_.parts[p].island == nullptr) continue;
        JointIsland& island = *machines_.parts[p].island;
        const std::vector<Vec3> now = velocitiesOf(island, bodies);
        if (stores_.observer != nullptr)
            stores_.observer->noteGround(momentumOf(island, bodies, now) - momentumOf(island, bodies, before[p]));
        island.batch->acceptTry(stores_.observer);
        for (std::size_t b = 0; b < island.bodies.size(); ++b) {
            const BodyIndex body = island.bodies[b];
            const Vec3 change = velocityChangeBy(bodies, body, pushed[p][b]);
            SolverVelocity& mark = bodies.before[body];
            mark.x = static_cast<float>(now[b][0] - change[0]);
            mark.y = static_cast<float>(now[b][1] - change[1]);
            mark.w = static_cast<float>((now[b][2] - change[2]) * static_cast<double>(bodies.turn[body].gyration));
        }
    }
}

void solveMachineContacts(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                          MachineContacts& machines, const MachinePass& pass) {
    MachineSweep(stores, graph, contacts, machines, pass).run();
}

}  // namespace plumb
