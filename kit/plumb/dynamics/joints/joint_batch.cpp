// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_batch.h>

#include <cmath>

namespace plumb {

namespace {

float rounded(double value) {
    return static_cast<float>(value);
}

/// Adds to value what others have added to its rounded record.
void pullChange(double& value, float record, double scale) {
    const float known = rounded(value * scale);
    if (record != known) value += (static_cast<double>(record) - static_cast<double>(known)) / scale;
}

/// Takes over a place at which others have put a body: it must be the same on the bit, or it may be behind a wall.
bool pullPlace(double& value, float record) {
    if (record == rounded(value)) return false;
    value = static_cast<double>(record);
    return true;
}

}  // namespace

void JointBatch::pullVelocity(const BodyStore& bodies, std::size_t lane, std::size_t n, int field) {
    const BodyIndex index = islands_[lane]->bodies[n];
    const SolverVelocity& v = bodies.velocity[index];
    pullChange(body(n, field, lane), v.x, 1);
    pullChange(body(n, field + 1, lane), v.y, 1);
    pullChange(body(n, field + 2, lane), v.w, static_cast<double>(bodies.turn[index].gyration));
}

bool JointBatch::pullBody(const BodyStore& bodies, std::size_t lane, std::size_t n, bool moved) {
    pullVelocity(bodies, lane, n, BodyField::Vx);
    if (!moved) return false;
    const BodyIndex index = islands_[lane]->bodies[n];
    const SolverDisplacement& d = bodies.displacement[index];
    const bool x = pullPlace(body(n, BodyField::X, lane), d.x), y = pullPlace(body(n, BodyField::Y, lane), d.y);
    return pullPlace(body(n, BodyField::Turn, lane), bodies.turn[index].angle) || x || y;
}

void JointBatch::pull(const BodyStore& bodies) {
    bool changed = false;
    for (std::size_t n = 0; n < layout_->moved; ++n)
        for (std::size_t lane = 0; lane < width_; ++lane) changed = pullBody(bodies, lane, n, moved_) || changed;
    if (changed) kernel_->place(view_);
    moved_ = false;
}

void JointBatch::pull(const BodyStore& bodies, std::size_t lane, bool moved) {
    bool changed = false;
    for (std::size_t n = 0; n < layout_->moved; ++n) changed = pullBody(bodies, lane, n, moved) || changed;
    if (changed) kernel_->place(view_);
}

/// How far a coordinate is from where it is held, or beyond its limits [m]; 0 for angles.
double JointBatch::errorOf(std::size_t i, std::size_t lane) const {
    const double q = row(i, RowField::Coordinate, lane);
    if (layout_->rows[i].axis[0] == RowAxis::Turning) return 0;
    if (layout_->rows[i].holds) return std::fabs(q);
    return std::max({q - row(i, RowField::LimitUpper, lane), row(i, RowField::LimitLower, lane) - q, 0.0});
}

double JointBatch::opening(std::size_t lane) const {
    double most = 0;
    for (std::size_t i = 0; i < layout_->rows.size(); ++i)
        most = std::max(most, errorOf(i, lane) - row(i, RowField::StartError, lane));
    return most;
}

void JointBatch::writeVelocities(BodyStore& bodies, int field) const {
    for (std::size_t n = 0; n < layout_->moved; ++n) {
        for (std::size_t lane = 0; lane < width_; ++lane) {
            if (active_[lane] == 0) continue;
            const BodyIndex index = islands_[lane]->bodies[n];
            SolverVelocity& v = bodies.velocity[index];
            v.x = rounded(body(n, field, lane));
            v.y = rounded(body(n, field + 1, lane));
            v.w = rounded(body(n, field + 2, lane) * static_cast<double>(bodies.turn[index].gyration));
        }
    }
}

void JointBatch::writeVelocities(BodyStore& bodies) const {
    writeVelocities(bodies, BodyField::Vx);
}

void JointBatch::writeFree(BodyStore& bodies) const {
    writeVelocities(bodies, BodyField::FreeX);
}

void JointBatch::pullFree(const BodyStore& bodies) {
    for (std::size_t n = 0; n < layout_->moved; ++n)
        for (std::size_t lane = 0; lane < width_; ++lane) pullVelocity(bodies, lane, n, BodyField::FreeX);
}

void JointBatch::writePlaces(BodyStore& bodies) const {
    for (std::size_t n = 0; n < layout_->moved; ++n) {
        for (std::size_t lane = 0; lane < width_; ++lane) {
            const BodyIndex index = islands_[lane]->bodies[n];
            const double gyration = static_cast<double>(bodies.turn[index].gyration);
            bodies.displacement[index] = {rounded(body(n, BodyField::X, lane)), rounded(body(n, BodyField::Y, lane)),
                                          rounded(body(n, BodyField::Sin, lane) * gyration),
                                          rounded((body(n, BodyField::Cos, lane) - 1) * gyration)};
            bodies.turn[index].angle = rounded(body(n, BodyField::Turn, lane));
        }
    }
}

void JointBatch::addImpulse(const BodyStore& bodies, std::size_t lane, std::size_t n, const SolverVelocity& change) {
    const auto at = [&](int field) -> double& { return body(n, field, lane); };
    const double inverseGyration = static_cast<double>(bodies.turn[islands_[lane]->bodies[n]].inverseGyration);
    const double give = at(BodyField::ContactMass) / at(BodyField::Mass);
    at(BodyField::FreeX) += static_cast<double>(change.x) * give;
    at(BodyField::FreeY) += static_cast<double>(change.y) * give;
    if (at(BodyField::Inertia) > 0)
        at(BodyField::FreeSpin) +=
            static_cast<double>(change.w) * inverseGyration * at(BodyField::ContactInertia) / at(BodyField::Inertia);
}

void JointBatch::kick(const BodyStore& bodies) {
    if (pieces_ > 1) endPieces();
    kernel_->setMasses(view_, h_);
    kernel_->kick(view_);
    for (const Touching& t : touching_) addImpulse(bodies, t.lane, t.node, bodies.warm[t.body]);
    activate(true, 0);
    pushed_ = {};
}

void JointBatch::activate(bool all, std::size_t lane) {
    for (std::size_t l = 0; l < width_; ++l) active_[l] = all || l == lane ? 1 : 0;
}

void JointBatch::noteStates() {
    if (!layout_->someFree) return;
    for (std::size_t i = 0; i < layout_->rows.size(); ++i)
        if (!layout_->rows[i].holds)
            for (std::size_t lane = 0; lane < width_; ++lane)
                if (active_[lane] != 0) row(i, RowField::LastState, lane) = row(i, RowField::State, lane);
}

/// The free velocities are the present ones.
void JointBatch::freeAsIs() {
    for (std::size_t n = 0; n < layout_->moved; ++n)
        for (std::size_t lane = 0; lane < width_; ++lane)
            for (int c = 0; c < 3; ++c) body(n, BodyField::FreeX + c, lane) = body(n, BodyField::Vx + c, lane);
}

/// In some lanes. change: the share of the last change of velocities that is expected again.
void JointBatch::findSolution(const IslandTurn& turn, const Lanes& lanes, double change) {
    active_ = lanes;
    kernel_->guess(view_, change);
    kernel_->prepare(view_, turn);
    kernel_->solve(view_);
    if (turn.closesGaps()) predict(turn);
    active_ = lanes;
    if (!turn.onlyHold) noteStates();
    kernel_->accept(view_);
}

/// Predicts rows from the solution until that matters no more. Where that leads nowhere, they are predicted from the
/// present velocities; and solved at the middle of the sub-step, if links turn far.
void JointBatch::predict(const IslandTurn& turn) {
    constexpr double far = 1e-3;  ///< see WidePlaces::keepMissed
    missed_.fill(1);
    lost_ = {};
    while (kernel_->predictAgain(view_, turn)) kernel_->solve(view_);
    if (lost_ == Lanes{}) return;
    kernel_->guess(view_, 0);
    for (const bool atMiddle : {false, true}) {
        for (std::size_t lane = 0; lane < width_; ++lane)
            active_[lane] = (missed_[lane] > far) == atMiddle ? lost_[lane] : 0;
        if (active_ != Lanes{}) kernel_->predictHeld(view_, turn, atMiddle);
    }
    active_ = lost_;
    kernel_->solve(view_);
}

void JointBatch::note(StepObserver* observer) {
    note(observer, h_, false);
}

void JointBatch::note(StepObserver* observer, double h, bool inPieces) {
    activate(true, 0);
    kernel_->addLoads(view_);
    kernel_->noteForces(view_, h, inPieces);
    if (observer == nullptr) return;
    report(*observer);
    observer->noteGround(givenMomentum());
}

IslandTurn JointBatch::ownTurn(IslandTurn turn) const {
    turn.inPieces = pieces_ > 1;
    return turn;
}

void JointBatch::solve(BodyStore& bodies, const IslandTurn& turn) {
    activate(true, 0);
    findSolution(ownTurn(turn), Lanes(active_), 1);
    writeVelocities(bodies);
}

/// Adds the impulses of the contacts, which have changed the bodies' records, to the free velocities and to the next
/// first guess. Returns the lanes in which there were some.
JointBatch::Lanes JointBatch::takeContactImpulses(BodyStore& bodies) {
    Lanes touched = pushed_;
    pushed_ = {};
    for (const Touching& t : touching_) {
        const SolverVelocity now = bodies.velocity[t.body], before = bodies.before[t.body];
        if (now.x == before.x && now.y == before.y && now.w == before.w) continue;
        touched[t.lane] = 1;
        const SolverVelocity change{now.x - before.x, now.y - before.y, now.w - before.w, 0};
        SolverVelocity& warm = bodies.warm[t.body];
        warm = {warm.x + change.x, warm.y + change.y, warm.w + change.w, 0};
        bodies.before[t.body] = now;
        addImpulse(bodies, t.lane, t.node, change);
    }
    return touched;
}

bool JointBatch::solveAgain(BodyStore& bodies, const IslandTurn& turn) {
    const Lanes touched = answerContacts(bodies, turn);
    for (std::size_t lane = 0; lane < width_; ++lane)
        changed_[lane] = touched[lane] * heavy_[lane] != 0 && areOthersBearing(bodies, lane) ? 1 : 0;
    return changed_ != Lanes{};
}

/// Returns the lanes in which contacts have given impulses.
JointBatch::Lanes JointBatch::answerContacts(BodyStore& bodies, const IslandTurn& turn) {
    const Lanes touched = takeContactImpulses(bodies);
    if (touched == Lanes{}) return touched;
    findSolution(ownTurn(turn), touched, 0);
    active_ = touched;
    writeVelocities(bodies);
    for (std::size_t lane = 0; lane < width_; ++lane)
        if (touched[lane] != 0)
            for (const BodyIndex body : islands_[lane]->bodies) bodies.before[body] = bodies.velocity[body];
    return touched;
}

void JointBatch::sweep(BodyStore& bodies, const IslandTurn& turn, double give, StepObserver* observer) {
    pull(bodies);
    if (turn.correct) noteSpeeds();
    freeAsIs();
    heavy_ = {};  // contacts see the bodies of a swept machine as they are
    kernel_->guess(view_, 0);
    kernel_->prepare(view_, turn);
    // Where an error is removed at the most allowed speed, the joint must not give: else a load opens it for ever.
    double most = 0;
    for (std::size_t i = 0; i < layout_->rows.size(); ++i)
        most = std::max(most, layout_->rows[i].holds ? std::fabs(row(i, RowField::Coordinate, 0)) : errorOf(i, 0));
    const bool isLimited = most * turn.rate * turn.share > turn.fastest;
    view_.compliance = (isLimited ? 0 : give) + (layout_->isTree ? 0 : relativeCompliance);
    kernel_->solve(view_);
    noteStates();
    kernel_->accept(view_);
    kernel_->addLoads(view_);
    if (observer != nullptr) report(*observer);
    writeVelocities(bodies);
}

void JointBatch::hold(BodyStore& bodies, std::size_t lane, double h, double fastest) {
    kernel_->setMasses(view_, h);
    freeAsIs();
    Lanes held{};
    held[lane] = 1;
    findSolution({h, true, true, fastest}, held, 0);
    kernel_->addLoads(view_);
    writeVelocities(bodies);
}

void JointBatch::addLoads(std::size_t lane) {
    activate(false, lane);
    kernel_->addLoads(view_);
}

Vec3 JointBatch::answer(std::size_t lane, std::size_t node, const Vec3& impulse) {
    activate(false, lane);
    kernel_->prepare(view_, {h_, false, false, 0});
    for (std::size_t n = 0; n < layout_->bodies; ++n)
        for (std::size_t l = 0; l < width_; ++l)
            for (int c = 0; c < 3; ++c) body(n, BodyField::Ux + c, l) = body(n, BodyField::Vx + c, l);
    const Vec3 change = changeBy(lane, node, impulse);
    for (int c = 0; c < 3; ++c) body(node, BodyField::Ux + c, lane) += change[static_cast<std::size_t>(c)];
    kernel_->answer(view_);
    Vec3 result{};
    for (int c = 0; c < 3; ++c)
        result[static_cast<std::size_t>(c)] = body(node, BodyField::Ux + c, lane) - body(node, BodyField::Vx + c, lane);
    return result;
}

void JointBatch::push(BodyStore& bodies, std::size_t lane, std::size_t node, const Vec3& impulse) {
    answer(lane, node, impulse);
    kernel_->accept(view_);
    writeVelocities(bodies);
    const Vec3 change = changeBy(lane, node, impulse);
    for (int c = 0; c < 3; ++c) body(node, BodyField::FreeX + c, lane) += change[static_cast<std::size_t>(c)];
    pushed_[lane] = 1;
}

Vec3 JointBatch::changeBy(std::size_t lane, std::size_t node, const Vec3& impulse) const {
    const double mass = body(node, BodyField::Mass, lane), inertia = body(node, BodyField::Inertia, lane);
    return {impulse[0] / mass, impulse[1] / mass, inertia > 0 ? impulse[2] / inertia : 0.0};
}

/// The momentum that joints have given: only fixed bodies can give some.
Vec2 JointBatch::givenMomentum() const {
    Vec2 sum(0, 0);
    for (std::size_t n = 0; n < layout_->moved; ++n)
        for (std::size_t lane = 0; lane < width_; ++lane)
            if (active_[lane] != 0)
                sum += body(n, BodyField::OwnMass, lane) *
                       Vec2(body(n, BodyField::Vx, lane) - body(n, BodyField::FreeX, lane),
                            body(n, BodyField::Vy, lane) - body(n, BodyField::FreeY, lane));
    return sum;
}

void JointBatch::report(StepObserver& observer) const {
    for (std::size_t lane = 0; lane < width_; ++lane) {
        if (active_[lane] == 0) continue;
        for (std::size_t j = 0; j < layout_->jointCount(); ++j) {
            Vec3 impulses{}, after{}, slopes{};
            const JointRows rows = rowsOf(j, lane, impulses, after, slopes);
            observer.noteRows(rows, impulses, after, slopes);
        }
    }
}

JointRows JointBatch::rowsOf(std::size_t j, std::size_t lane, Vec3& impulses, Vec3& after, Vec3& slopes) const {
    JointRows rows;
    const std::size_t first = layout_->joints[j].firstRow,
                      links = layout_->joints[j + 1].firstLink - layout_->joints[j].firstLink;
    rows.body.fill(noBody);
    rows.ends = 2 * links;
    for (std::size_t k = 0; k < links; ++k) {
        const IslandLayout::Link& link = layout_->links[layout_->joints[j].firstLink + k];
        rows.body[2 * k] = islands_[lane]->bodyAt(link.a);
        rows.body[2 * k + 1] = islands_[lane]->bodyAt(link.b);
    }
    for (std::size_t i = first; i < layout_->joints[j + 1].firstRow; ++i) {
        const auto at = [&](int field) { return row(i, field, lane); };
        JointRow& added = rows.add();
        const std::size_t r = i - first;
        for (std::size_t k = 0; k < links; ++k) {
            const int axis = k == 0 ? RowField::AxisX : RowField::SecondAxisX;
            const Vec3 a{-at(axis), -at(axis + 1), at(axis + 2)}, b{at(axis), at(axis + 1), at(axis + 3)};
            (k == 0 ? added.at : rows.far) = {a, b};
            const IslandLayout::Link& link = layout_->links[layout_->joints[j].firstLink + k];
            for (int c = 0; c < 3; ++c)
                after[r] += a[static_cast<std::size_t>(c)] * body(link.a, BodyField::Vx + c, lane) +
                            b[static_cast<std::size_t>(c)] * body(link.b, BodyField::Vx + c, lane);
        }
        impulses[r] = at(RowField::Impulse);
        added.holds = layout_->rows[i].holds;
        added.bounded = layout_->rows[i].bounded;
        if (added.holds) continue;
        added.push = at(RowField::Push);
        added.dampPush = at(RowField::DampPush);
        added.low = at(RowField::Low);
        added.high = at(RowField::High);
        slopes[r] = at(RowField::Slope);
    }
    return rows;
}

BodyMove JointBatch::moveOf(std::size_t lane, std::size_t node) const {
    const auto at = [&](int field) { return body(node, field, lane); };
    return {Vec2(at(BodyField::X), at(BodyField::Y)), at(BodyField::Turn), Vec2(at(BodyField::Vx), at(BodyField::Vy)),
            at(BodyField::Spin)};
}

}  // namespace plumb
