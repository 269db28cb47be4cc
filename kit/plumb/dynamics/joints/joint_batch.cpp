// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_batch.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/dynamics/joints/island_energy.h>
#include <plumb/dynamics/joints/island_report.h>

namespace plumb {

void JointBatch::load(std::span<JointIsland* const> islands, const JointStore& joints, BodyStore& bodies, double h,
                      int mostFloats) {
    pieces_ = islands.front()->pieces;
    given_ = raised_ = {};
    touchesNothing_ = false;
    moved_ = false;
    h_ = h;
    numbers.layOut(islands, mostFloats);
    for (std::size_t lane = 0; lane < numbers.width; ++lane) {
        islands[lane]->batch = this;
        islands[lane]->lane = lane;
        lost_[lane] = lostNext_[lane] = islands[lane]->lost;
        touchesNothing_ = touchesNothing_ || !islands[lane]->touches;
    }
    loadIslands(numbers, joints, bodies, h);
    contacts.find(numbers, bodies);
    numbers.activateAll();
    for (std::size_t lane = 0; lane < numbers.width; ++lane)
        energy_[lane] = std::max({islands[lane]->energy, energyOf(numbers, bodies, lane),
                                  2 * plumb::fallOf(numbers, lane, BodyField::GainX)});
    writeVelocities(numbers, bodies);
    numbers.kernel().place(numbers.view);
    for (std::size_t i = 0; i < numbers.layout->rows.size(); ++i)
        for (std::size_t lane = 0; lane < numbers.width; ++lane)
            numbers.row(i, RowField::StartError, lane) = numbers.errorOf(i, lane);
}

void JointBatch::store(JointStore& joints, BodyStore& bodies, double dt) {
    numbers.kernel().findInertias(numbers.view, h_);
    storeIslands(numbers, joints, bodies);
    constexpr double memory = 2;  ///< in which the energy of former steps is forgotten [s]
    for (std::size_t lane = 0; lane < numbers.width; ++lane) {
        numbers.islands[lane]->lost = lostNext_[lane];
        numbers.islands[lane]->energy = energy_[lane] * (1 - std::min(dt / memory, 1.0));
    }
}

void JointBatch::pull(const BodyStore& bodies) {
    if (std::exchange(moved_, false)) pullPlaces(numbers, bodies);
    pullVelocities(numbers, bodies);
}

void JointBatch::noteSpeeds(bool ofFree) {
    if (ofFree) numbers.kernel().noteSpeeds(numbers.view, false);
    if (touchesNothing_) numbers.kernel().noteSpeeds(numbers.view, true);
}

/// Dampers act by the speeds before this half, so these are noted before the kicks of fields are taken in.
void JointBatch::kick(const BodyStore& bodies, bool correct) {
    if (std::exchange(moved_, false)) pullPlaces(numbers, bodies);
    noteSpeeds(correct);
    pullVelocities(numbers, bodies);
    if (pieces_ > 1) {
        endPieces();
        noteSpeeds(false);
    }
    for (std::size_t lane = 0; lane < numbers.width && correct; ++lane)
        raised_[lane] = 0.5 * fallOf(lane, BodyField::Vx);
    numbers.activateAll();
    numbers.kernel().setMasses(numbers.view, h_);
    numbers.kernel().kick(numbers.view);
    contacts.addFirstGuess(numbers, bodies);
    pushed_ = {};
}

/// The free velocities are the present ones: no forces act.
void JointBatch::setFreeVelocities() {
    numbers.forEachMoved([&](std::size_t n, std::size_t lane) {
        for (int c = 0; c < 3; ++c)
            numbers.body(n, BodyField::FreeX + c, lane) = numbers.body(n, BodyField::Vx + c, lane);
    });
}

void JointBatch::findSolution(const BodyStore& bodies, const IslandTurn& turn, const LaneFlags& lanes, double change) {
    numbers.active = lanes;
    numbers.kernel().guess(numbers.view, change);
    numbers.kernel().prepare(numbers.view, turn);
    solvePrepared(bodies, turn, lanes);
}

void JointBatch::solvePrepared(const BodyStore& bodies, const IslandTurn& turn, const LaneFlags& lanes) {
    numbers.active = lanes;
    numbers.kernel().solve(numbers.view);
    if (turn.closesGaps()) predict(turn);
    numbers.active = lanes;
    if (!turn.onlyHold) noteStates();
    numbers.kernel().accept(numbers.view);
    if (!touchesNothing_) return;
    numbers.kernel().findWork(numbers.view);
    for (std::size_t lane = 0; lane < numbers.width; ++lane)
        if (lanes[lane] != 0 && !numbers.islands[lane]->touches) keepEnergy(bodies, lane, turn);
}

double JointBatch::fallOf(std::size_t lane, int velocity) const {
    return numbers.layout->someFree || numbers.islands[lane]->touches ? 0.0 : plumb::fallOf(numbers, lane, velocity);
}

/// A gain of less than mayGain comes back of itself, as that of a pendulum that swings through. A loss may do so, too.
void JointBatch::keepEnergy(const BodyStore& bodies, std::size_t lane, const IslandTurn& turn) {
    constexpr double mayGain = 0.003, mayReturn = 0.03;
    const double work = numbers.work[lane];
    if (turn.correct) {
        given_[lane] = work;
        lost_[lane] = lostNext_[lane];
        return;
    }
    const double fall = turn.onlyHold ? 0.0 : 0.5 * fallOf(lane, BodyField::Vx);
    const double lost = lost_[lane] - given_[lane] - raised_[lane] - work - fall;
    lostNext_[lane] = std::min(lost, mayReturn * energy_[lane]);
    if (lost >= -mayGain * energy_[lane]) return;
    energy_[lane] = std::max(energy_[lane], energyOf(numbers, bodies, lane) + lost);  // without the gain
    const double least = -mayGain * energy_[lane];
    if (lost >= least) return;
    lostNext_[lane] = lost + takeEnergy(numbers, bodies, lane, least - lost);
}

/// Predicts rows from the solution until that matters no more: where joints will be after the sub-step depends on the
/// velocities that are solved for. Where that leads nowhere, they are predicted from the present velocities; or,
/// if links turn far, the gap that will open is closed in the next sub-steps.
void JointBatch::predict(const IslandTurn& turn) {
    constexpr double far = 1e-3;  ///< see WidePlaces::keepMissed
    const IslandKernel& kernel = numbers.kernel();
    numbers.missed.fill(1);
    numbers.lost = {};
    while (kernel.predictAgain(numbers.view, turn)) kernel.solve(numbers.view);
    if (numbers.lost == LaneFlags{}) return;
    kernel.guess(numbers.view, 0);
    for (const bool isFar : {false, true}) {
        for (std::size_t lane = 0; lane < numbers.width; ++lane)
            numbers.active[lane] = (numbers.missed[lane] > far) == isFar ? numbers.lost[lane] : 0;
        if (numbers.active != LaneFlags{}) kernel.predictHeld(numbers.view, turn, !isFar);
    }
    numbers.active = numbers.lost;
    kernel.solve(numbers.view);
}

void JointBatch::noteStates() {
    numbers.forEachFreeRow([&](std::size_t i, std::size_t lane) {
        if (numbers.active[lane] != 0)
            numbers.row(i, RowField::LastState, lane) = numbers.row(i, RowField::State, lane);
    });
}

void JointBatch::note(StepObserver* observer, double h, bool inPieces) {
    numbers.activateAll();
    numbers.kernel().addLoads(numbers.view);
    numbers.kernel().noteForces(numbers.view, h, inPieces);
    if (observer == nullptr) return;
    reportRows(numbers, *observer);
    observer->noteGround(givenMomentum(numbers));
}

/// A move in pieces closes the gaps itself, so the half before it must not.
IslandTurn JointBatch::ownTurn(IslandTurn turn) const {
    turn.inPieces = pieces_ > 1;
    return turn;
}

void JointBatch::solve(BodyStore& bodies, const IslandTurn& turn) {
    numbers.activateAll();
    findSolution(bodies, ownTurn(turn), LaneFlags(numbers.active), 1);
    writeVelocities(numbers, bodies);
}

/// After the half that does not correct, the next half solves for what contacts have given, too: the rows do not move
/// in between. Heavy islands may not wait: a light body would have the speed of all that the machine was given. Rows
/// that hold want what they wanted before contacts.
LaneFlags JointBatch::respondToContacts(BodyStore& bodies, const IslandTurn& turn) {
    const LaneFlags pushed = std::exchange(pushed_, LaneFlags{});
    LaneFlags touched = pushed, waits{}, prepared{}, others{};
    for (std::size_t lane = 0; lane < numbers.width && !turn.correct && !turn.isLast; ++lane)
        waits[lane] = pushed[lane] == 0 && numbers.heavy[lane] == 0 ? 1 : 0;
    contacts.takeImpulses(numbers, bodies, touched, waits);
    if (touched == LaneFlags{}) return touched;
    for (std::size_t lane = 0; lane < numbers.width; ++lane)
        if (touched[lane] > waits[lane]) (numbers.layout->someFree || pushed[lane] != 0 ? others : prepared)[lane] = 1;
    if (prepared != LaneFlags{}) solvePrepared(bodies, ownTurn(turn), prepared);
    if (others != LaneFlags{}) findSolution(bodies, ownTurn(turn), others, 0);
    numbers.active = touched;
    writeVelocities(numbers, bodies);
    return touched;
}

void JointBatch::closeGaps(BodyStore& bodies, std::size_t lane, double h, double fastest) {
    numbers.activateOnly(lane);
    numbers.kernel().setMasses(numbers.view, h);
    setFreeVelocities();
    LaneFlags only{};
    only[lane] = 1;
    const LaneFlags given = given_;  // what is closed here belongs to no move
    findSolution(bodies, {h, true, true, fastest}, only, 0);
    given_ = given;
    numbers.kernel().addLoads(numbers.view);
    writeVelocities(numbers, bodies);
}

void JointBatch::addLoads(std::size_t lane) {
    numbers.activateOnly(lane);
    numbers.kernel().addLoads(numbers.view);
}

void JointBatch::respond(std::size_t lane, std::span<BodyPush> pushes) {
    numbers.activateOnly(lane);
    numbers.kernel().prepare(numbers.view, {h_, false, false, 0});
    for (std::size_t n = 0; n < numbers.layout->bodies; ++n)
        for (std::size_t l = 0; l < numbers.width; ++l)
            for (int c = 0; c < 3; ++c) numbers.body(n, BodyField::Ux + c, l) = numbers.body(n, BodyField::Vx + c, l);
    addPushes(lane, pushes, BodyField::Ux);
    numbers.kernel().solvePush(numbers.view);
    for (BodyPush& one : pushes) {
        const std::size_t node = numbers.islands[lane]->nodeOf(one.body);
        for (int c = 0; c < 3; ++c)
            one.change[static_cast<std::size_t>(c)] =
                numbers.body(node, BodyField::Ux + c, lane) - numbers.body(node, BodyField::Vx + c, lane);
    }
}

/// The impulses go to the free velocities too: else the next solution in this half would take them back.
void JointBatch::push(BodyStore& bodies, std::size_t lane, std::span<BodyPush> pushes) {
    respond(lane, pushes);
    numbers.kernel().accept(numbers.view);
    writeVelocities(numbers, bodies);
    addPushes(lane, pushes, BodyField::FreeX);
    pushed_[lane] = 1;
}

void JointBatch::addPushes(std::size_t lane, std::span<BodyPush> pushes, int field) {
    for (const BodyPush& one : pushes) {
        const std::size_t node = numbers.islands[lane]->nodeOf(one.body);
        const Vec3 change = changeBy(lane, node, one.impulse);
        for (int c = 0; c < 3; ++c) numbers.body(node, field + c, lane) += change[static_cast<std::size_t>(c)];
    }
}

Vec3 JointBatch::changeBy(std::size_t lane, std::size_t node, const Vec3& impulse) const {
    const double mass = numbers.body(node, BodyField::Mass, lane);
    const double inertia = numbers.body(node, BodyField::Inertia, lane);
    return {impulse[0] / mass, impulse[1] / mass, inertia > 0 ? impulse[2] / inertia : 0.0};
}

void JointBatch::move(BodyStore& bodies, double h, double fastest, StepObserver* observer) {
    if (pieces_ == 1)
        numbers.kernel().move(numbers.view, h);
    else
        moveInPieces(bodies, h, fastest, observer);
    for (std::size_t lane = 0; lane < numbers.width; ++lane) raised_[lane] -= fallOf(lane, BodyField::Vx);
    writePlaces(numbers, bodies);
}

template <class Change>
void JointBatch::forEachCoordinate(Change&& change) {
    numbers.forEachMoved([&](std::size_t n, std::size_t lane) {
        for (int c = 0; c < 3; ++c)
            change(numbers.body(n, BodyField::Vx + c, lane), numbers.body(n, BodyField::X + c, lane),
                   numbers.body(n, BodyField::BentX + c, lane));
    });
}

/// Where links turn fast: in each piece, joints are solved before and after the bodies move, and no forces act. For all
/// others the bodies have moved at their mean velocities.
/// Source, of short steps for the fast part of a motion: Tuckerman, Berne, Martyna, "Reversible multiple time scale
/// molecular dynamics", J. Chem. Phys. 97 (1992) 1990.
/// Test: "ropes let go from any angle gain at most 1 % of their fall in a minute, and lose at most 20 %"
void JointBatch::moveInPieces(BodyStore& bodies, double h, double fastest, StepObserver* observer) {
    const double piece = h / pieces_;
    const LaneFlags raised = std::exchange(raised_, LaneFlags{});
    forEachCoordinate([](double&, double place, double& bent) { bent = place; });
    for (int i = 0; i < pieces_; ++i) {
        for (const bool correct : {true, false}) {
            numbers.activateAll();
            setFreeVelocities();
            noteSpeeds(false);
            findSolution(bodies, {piece, correct, true, fastest}, LaneFlags(numbers.active), correct && i > 0 ? 1 : 0);
            note(observer, piece, true);
            if (correct) numbers.kernel().move(numbers.view, piece);
        }
    }
    forEachCoordinate([h](double& velocity, double place, double& bent) {
        const double mean = (place - bent) / h;
        bent = velocity - mean;
        velocity = mean;
    });
    raised_ = raised;
    given_ = {};
    lost_ = lostNext_;
    writeVelocities(numbers, bodies);
}

/// Goes on from the velocities at the end of the last piece, with what others have changed since.
void JointBatch::endPieces() {
    forEachCoordinate([](double& velocity, double, double& bent) { velocity += std::exchange(bent, 0.0); });
}

}  // namespace plumb
