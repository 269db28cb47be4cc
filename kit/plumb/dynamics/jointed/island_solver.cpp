// SPDX-License-Identifier: MIT
#include <plumb/dynamics/jointed/island_solver.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include <plumb/dynamics/bodies/body_solver.h>
#include <plumb/dynamics/joints/joint_measure.h>
#include <plumb/dynamics/joints/joint_springs.h>
#include <plumb/math/detail/sorting.h>

namespace plumb {

namespace {

/// The frequency of the joints of swept islands, as a share of the sub-step rate, so that their compliance falls with
/// the step. Islands that are solved directly close their whole gaps in one sub-step, which is more exact; a sweep that
/// leaves errors becomes unstable with that (tried).
constexpr double jointFrequencyShare = 0.25;
constexpr double jointDampingRatio = 5;

/// With a piece of a sub-step for each so many levels of a swept island, and one for half of them, nets hang with gaps
/// of at most 5 mm, whether they have 10 x 10 links or 100 x 100, and whatever their length is.
constexpr std::size_t levelsAPiece = 17;

/// The turn of a link that is followed well in one move [rad].
constexpr double followed = 0.12;

/// A sleeping joint keeps its load. A joint that no longer holds anything gets no load, and one whose body is out of
/// range gets no first guess.
void resetLoads(JointStore& joints, const BodyStore& bodies) {
    for (JointIndex index = 0; index < joints.records.size(); ++index) {
        JointRecord& record = joints[index];
        if (!record.acts()) continue;
        if (!holdsSomething(joints, bodies, index)) joints.loads[index] = {};
        for (double& impulse : record.impulse) impulse = std::isfinite(impulse) ? impulse : 0;
    }
}

Vec2 momentumOf(const BodyStore& bodies, const std::vector<BodyIndex>& some) {
    Vec2 sum(0, 0);
    for (const BodyIndex body : some) {
        const SolverVelocity& v = bodies.velocity[body];
        sum += bodies.record[body].mass * Vec2(static_cast<double>(v.x), static_cast<double>(v.y));
    }
    return sum;
}

bool touches(const BodyStore& bodies, const JointIsland& island) {
    return std::any_of(island.bodies.begin(), island.bodies.end(),
                       [&](BodyIndex body) { return bodies.links[body].solverContacts > 0; });
}

/// May a link of the island turn faster than this rate [rad/s]?
bool mayTurn(const BodyStore& bodies, const JointIsland& island, double rate) {
    return island.layout->someAlong || std::any_of(island.bodies.begin(), island.bodies.end(), [&](BodyIndex body) {
               return std::fabs(bodies.motion[body].angularVelocity) > rate;
           });
}

/// How fast the island's links turn, or swing under the forces along them if that is not much more [rad/s].
double turningOf(const BodyStore& bodies, const JointIsland& island) {
    constexpr double mostSwing = 4, swing = 0.24;
    double turning = 0, stiffness = 0;
    for (const LaidJoint& joint : island.laid) turning = std::max(turning, turningOf(joint.form, bodies));
    for (std::size_t b = 0; b < island.bodies.size(); ++b) {
        const double inverseInertia = bodies.record[island.bodies[b]].inverseInertia;
        stiffness = std::max(stiffness, 2 * island.stiffness[b].swinging * inverseInertia);
    }
    return std::max(turning, std::min(swing * std::sqrt(stiffness), mostSwing * turning));
}

}  // namespace

const JointSolver& islandSolver() {
    static const IslandSolver empty;
    return empty;
}

/// Here, so that a program which locks a body links the code of joints, and another one does not.
Lock::Lock(bool locked) : solver_(locked ? &islandSolver() : nullptr) {}

/// The impulses of swept joints go to their records first: so a joint that gets another place in a sweep keeps its
/// first guess.
void IslandSolver::findIslands() {
    JointStore& joints = *stores_.joints;
    if (!std::exchange(joints.changed, false)) return;
    for (const JointIsland& island : islands_.islands) island.sweptJoints.release(joints);
    resetLoads(joints, *stores_.bodies);
    findJointIslands(islands_, joints, *stores_.bodies);
    islands_.joints.clear();
    for (const JointIsland& island : islands_.islands)
        islands_.joints.insert(islands_.joints.end(), island.joints.begin(), island.joints.end());
    std::sort(islands_.joints.begin(), islands_.joints.end());
    islands_.breakable.clear();
    std::copy_if(islands_.joints.begin(), islands_.joints.end(), std::back_inserter(islands_.breakable),
                 [&joints](JointIndex index) { return joints[index].mayBreak(); });
}

/// No island may fly while the ledger watches, which has to see all velocities before and after each half, nor while
/// fields act, which read the records of bodies.
std::size_t IslandSolver::begin(JointStores stores, StepList<BodyIndex>& solved) {
    stores_ = stores;
    dt_ = stores.h * stores.settings.subSteps;
    inHalf_ = false;
    findIslands();
    for (const JointIndex index : islands_.joints) {
        stores_.joints->loads[index] = {};
        stores_.joints->loads[index].time = dt_;
    }
    shareSprings(islands_, *stores_.joints, *stores_.bodies, stores_.h);
    forEachSwept([&](JointIsland& island) {
        island.sweptJoints.prepare(sweptKernel(stores_.settings.lanes), *stores_.joints, *stores_.bodies);
        const std::size_t pieces = 1 + (island.levels + levelsAPiece / 2) / levelsAPiece;
        island.sweptPieces.begin(island.bodies, *stores_.bodies, static_cast<int>(pieces));
    });
    bounces_.take(stores_, islands_.islands);
    loadBatches();
    contacts_.find(stores_, islands_.islands);
    moving_ = islands_.meetingBatches();
    return islands_.islands.empty() ? solved.size() : sortBodies(solved);
}

std::size_t IslandSolver::sortBodies(StepList<BodyIndex>& solved) {
    islandOf_.assign(stores_.bodies->record.size(), none);
    for (std::uint32_t i = 0; i < islands_.islands.size(); ++i)
        if (!islands_.islands[i].isSwept())
            for (const BodyIndex body : islands_.islands[i].bodies) islandOf_[body] = i;
    const JointBatch* firstFlying = islands_.flyingBatches().data();
    std::erase_if(solved, [&](BodyIndex body) {
        return islandOf_[body] != none && islands_.islands[islandOf_[body]].batch >= firstFlying;
    });
    StepList<BodyIndex> inLanes;
    for (const BodyIndex body : solved)
        if (islandOf_[body] != none) inLanes.push_back(body);
    std::erase_if(solved, [this](BodyIndex body) { return islandOf_[body] != none; });
    const std::size_t others = solved.size();
    solved.insert(solved.end(), inLanes.begin(), inLanes.end());
    return others;
}

/// Where links turn fast, an island that touches nothing moves in pieces of a sub-step: contacts would not see what
/// happens within. Each change of their number costs some energy, so it rises early and falls slowly.
void IslandSolver::choosePieces(JointIsland& island) const {
    constexpr double memory = 2;  ///< in which the turning of former steps is forgotten [s]
    constexpr int most = 16;
    const BodyStore& bodies = *stores_.bodies;
    const double h = stores_.h, last = std::exchange(island.turning, 0.0);
    island.pieces = 1;
    island.touches = touches(bodies, island);
    if (island.touches) {
        island.mostTurning = 0;
        return;
    }
    if (mayTurn(bodies, island, followed / h / 8)) island.turning = turningOf(bodies, island);
    island.mostTurning = std::max(island.mostTurning * (1 - std::min(dt_ / memory, 1.0)), 2 * island.turning - last);
    const double turn = std::max(island.turning, island.mostTurning) * h;
    while (island.pieces < most && turn > followed * island.pieces) island.pieces *= 2;
}

/// Cuts groups of equal islands that move in as many pieces into batches, as many islands in each as there are lanes.
/// Those that touch something come first in their group, because after contacts only they are solved again.
StepList<std::span<JointIsland*>> IslandSolver::cutBatches(StepList<JointIsland*>& order) {
    StepList<std::span<JointIsland*>> cut;
    for (const std::vector<std::uint32_t>& group : islands_.alike)
        for (const std::uint32_t i : group) order.push_back(&islands_.islands[i]);
    std::span<JointIsland*> rest = order;
    for (const std::vector<std::uint32_t>& group : islands_.alike) {
        std::span<JointIsland*> left = rest.first(group.size());
        rest = rest.subspan(group.size());
        sortBy(left, [](const JointIsland* island) { return std::tuple(island->pieces, !island->touches); });
        while (!left.empty()) {
            std::size_t width = static_cast<std::size_t>(islandLanes(stores_.settings.lanes));
            const int pieces = left.front()->pieces;
            const auto alike = std::find_if(left.begin(), left.end(),
                                            [&](const JointIsland* island) { return island->pieces != pieces; });
            while (width > static_cast<std::size_t>(alike - left.begin())) width /= 2;
            cut.push_back(left.first(width));
            left = left.subspan(width);
        }
    }
    return cut;
}

/// Batches that meet no contact come last: they go through the whole step one after the other, while their numbers are
/// in the cache. Batches that are not needed are kept, with the room for their numbers: how many there are changes from
/// step to step.
void IslandSolver::loadBatches() {
    const bool mayFly = stores_.observer == nullptr && stores_.bodies->flights.empty();
    for (JointIsland& island : islands_.islands)
        if (!island.isSwept()) choosePieces(island);
    StepList<JointIsland*> order;
    StepList<std::span<JointIsland*>> cut = cutBatches(order);
    const auto meets = [mayFly](const auto& some) { return !mayFly || some.front()->touches; };
    StepList<std::span<JointIsland*>> flying;
    for (const std::span<JointIsland*>& some : cut)
        if (!meets(some)) flying.push_back(some);
    std::erase_if(cut, [&](const std::span<JointIsland*>& some) { return !meets(some); });
    islands_.meeting = cut.size();
    cut.insert(cut.end(), flying.begin(), flying.end());
    islands_.batchCount = cut.size();
    if (islands_.batches.size() < cut.size()) islands_.batches.resize(islands_.islands.size());
    for (std::size_t i = 0; i < cut.size(); ++i)
        islands_.batches[i].load(cut[i], *stores_.joints, *stores_.bodies, stores_.h, stores_.settings.lanes);
}

/// Batch by batch, so that its numbers stay in the cache: a batch of eight dolls has 180 KB. A rain of dolls took 0.6
/// to 0.67 times as long as with all batches in each half.
void IslandSolver::fly(FunctionRef<void(StepList<BodyIndex>& bodies, int subStep)> move) {
    flying_ = true;
    for (JointBatch& batch : islands_.flyingBatches()) {
        moving_ = {&batch, 1};
        StepList<BodyIndex> flying;
        for (const JointIsland* island : batch.islands())
            flying.insert(flying.end(), island->bodies.begin(), island->bodies.end());
        for (int i = 0; i < stores_.settings.subSteps; ++i) {
            for (const bool correct : {true, false}) {
                batch.kick(*stores_.bodies, correct);
                batch.solve(*stores_.bodies, turnOf({correct, false}));
                batch.note(stores_.observer);
                if (correct) move(flying, i);
            }
        }
    }
    flying_ = false;
    moving_ = islands_.meetingBatches();
}

IslandTurn IslandSolver::turnOf(const HalfStep& half) const {
    IslandTurn turn{stores_.h, half.correct, false, stores_.settings.contactPushSpeed};
    turn.isLast = half.isLast;
    return turn;
}

void IslandSolver::move() {
    for (JointBatch& batch : moving_)
        batch.move(*stores_.bodies, stores_.h, stores_.settings.contactPushSpeed, stores_.observer);
    if (flying_) return;
    forEachSwept([&](JointIsland& island) {
        island.sweptPieces.move(*stores_.bodies, bodySolver(stores_.settings.lanes), stores_.h, [&](bool correct) {
            sweep(island, {correct, false});
        });
    });
}

/// Calls change(), and reports to the observer how it changed the momentum of some bodies: only fixed bodies can give
/// them momentum.
template <class Change>
void IslandSolver::reportGround(const std::vector<BodyIndex>& bodies, Change&& change) {
    if (stores_.observer == nullptr) return change();
    const Vec2 before = momentumOf(*stores_.bodies, bodies);
    change();
    stores_.observer->noteGround(momentumOf(*stores_.bodies, bodies) - before);
}

/// Islands that are swept are solved joint by joint, with soft corrections.
void IslandSolver::sweep(JointIsland& island, const HalfStep& half) {
    const double h = stores_.h / island.sweptPieces.count();
    const Softness soft = half.correct ? softness(jointFrequencyShare / h, jointDampingRatio, h) : Softness{};
    const SweptPass pass{static_cast<float>(h), half.correct, !half.correct || half.isFirst,
                         static_cast<float>(stores_.settings.contactPushSpeed), soft};
    reportGround(island.bodies, [&] {
        island.sweptJoints.solve(sweptKernel(stores_.settings.lanes), *stores_.bodies, pass, stores_.observer);
    });
}

/// Calls visit(island) for each that is swept.
template <class Visit>
void IslandSolver::forEachSwept(Visit&& visit) {
    for (JointIsland& island : islands_.islands)
        if (island.isSwept()) visit(island);
}

void IslandSolver::solve(const HalfStep& half) {
    inHalf_ = true;
    for (JointBatch& batch : islands_.meetingBatches()) {
        batch.kick(*stores_.bodies, half.correct);
        batch.solve(*stores_.bodies, turnOf(half));
    }
    forEachSwept([&](JointIsland& island) {
        island.sweptPieces.share(*stores_.bodies);
        sweep(island, half);
        markBodies(island.bodies.data(), island.bodies.size(), stores_.bodies->solverBodies());
    });
    bounces_.solve(stores_, *this);
    contacts_.start(stores_, islands_.meetingBatches(), half.isFirst);
}

void IslandSolver::respondToContacts(const HalfStep& half) {
    contacts_.respond(stores_, islands_.meetingBatches(), turnOf(half));
    forEachSwept([&](JointIsland& island) { island.sweptPieces.keep(*stores_.bodies, half.correct); });
    inHalf_ = false;
}

void IslandSolver::end(FunctionRef<void(BodyIndex, const BodyMove*)> store) {
    for (JointBatch& batch : std::span(islands_.batches).first(islands_.batchCount)) {
        batch.pull(*stores_.bodies);
        batch.store(*stores_.joints, *stores_.bodies, dt_);
    }
    for (const JointIsland& island : islands_.islands) {
        island.sweptJoints.addLoads(*stores_.joints);
        for (std::size_t node = 0; node < island.bodies.size(); ++node) {
            if (island.isSwept()) {
                store(island.bodies[node], nullptr);
                continue;
            }
            const BodyMove move = moveOf(island.batch->numbers, node, island.lane);
            store(island.bodies[node], &move);
        }
    }
}

JointIsland* IslandSolver::islandOf(BodyIndex body) {
    if (islands_.islands.empty() || islandOf_[body] == none) return nullptr;
    return &islands_.islands[islandOf_[body]];
}

void IslandSolver::respond(JointIsland& island, std::span<BodyPush> pushes) {
    pullMoves(island.batch->numbers, *stores_.bodies, island.lane);
    island.batch->respond(island.lane, pushes);
}

/// Between the halves, what came through joints from fixed bodies is reported at once; the impulses themselves are not.
void IslandSolver::push(JointIsland& island, std::span<BodyPush> pushes) {
    JointBatch& batch = *island.batch;
    pullMoves(batch.numbers, *stores_.bodies, island.lane);
    if (inHalf_) return batch.push(*stores_.bodies, island.lane, pushes);
    reportGround(island.bodies, [&] {
        batch.push(*stores_.bodies, island.lane, pushes);
        batch.addLoads(island.lane);
    });
    if (stores_.observer != nullptr)
        for (const BodyPush& one : pushes) stores_.observer->noteGround(-Vec2(one.impulse[0], one.impulse[1]));
}

void IslandSolver::closeGaps(JointIsland& island, double time) {
    pullMoves(island.batch->numbers, *stores_.bodies, island.lane);
    reportGround(island.bodies, [&] {
        island.batch->closeGaps(*stores_.bodies, island.lane, time, stores_.settings.contactPushSpeed);
    });
}

double IslandSolver::springEnergy(const JointStore& joints, const BodyStore& bodies) const {
    return plumb::springEnergy(joints, bodies);
}

}  // namespace plumb
