// SPDX-License-Identifier: MIT
#include <plumb/dynamics/jointed/joint_phases.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/jointed/joint_bounces.h>
#include <plumb/dynamics/joints/joint_islands.h>
#include <plumb/dynamics/joints/joint_measure.h>
#include <plumb/dynamics/joints/joint_springs.h>
#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

namespace {

/// The frequency of the joints of swept islands, as a share of the sub-step rate, so that their compliance falls with
/// the step. Islands that are solved directly close their whole gaps in one sub-step, which is more exact; a sweep that
/// leaves errors becomes unstable with that (tried).
constexpr double jointFrequencyShare = 0.25;
constexpr double jointDampingRatio = 2;

HingePass hingePassOf(const JointStores& stores, const JointHalf& half) {
    const Softness soft = softness(jointFrequencyShare / half.step, jointDampingRatio, half.step);
    return {static_cast<float>(half.step), half.correct, static_cast<float>(stores.settings.contactPushSpeed),
            half.correct ? soft : Softness{}};
}

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

/// The hinges' impulses go to their records first: so a hinge that gets another place in a sweep keeps its first guess.
void findAwakeIslands(const JointStores& stores) {
    JointStore& joints = stores.joints;
    JointIslands& found = stores.islands;
    if (!joints.changed) return;
    joints.changed = false;
    for (const JointIsland& island : found.islands) island.hinges.release(joints);
    resetLoads(joints, stores.bodies);
    findJointIslands(found, joints, stores.bodies);
    found.joints.clear();
    for (const JointIsland& island : found.islands)
        found.joints.insert(found.joints.end(), island.joints.begin(), island.joints.end());
    std::sort(found.joints.begin(), found.joints.end());
    found.breakable.clear();
    std::copy_if(found.joints.begin(), found.joints.end(), std::back_inserter(found.breakable),
                 [&joints](JointIndex index) { return joints[index].mayBreak(); });
}

void prepareJoints(const JointStores& stores, double dt) {
    findAwakeIslands(stores);
    for (const JointIndex index : stores.islands.joints) {
        stores.joints.loads[index] = {};
        stores.joints.loads[index].time = dt;
    }
    for (JointIsland& island : stores.islands.islands)
        island.hinges.prepare(hingeSolver(stores.settings.lanes), stores.bodies);
    shareSprings(stores.islands, stores.joints, stores.bodies, dt / stores.settings.subSteps);
}

Vec2 momentumOf(const BodyStore& bodies, const std::vector<BodyIndex>& some) {
    Vec2 sum(0, 0);
    for (const BodyIndex body : some) {
        const SolverVelocity& v = bodies.velocity[body];
        sum += bodies.record[body].mass * Vec2(static_cast<double>(v.x), static_cast<double>(v.y));
    }
    return sum;
}

/// Calls change(), and reports to the observer how it changed the momentum of some bodies: only fixed bodies can give
/// them momentum.
template <class Change>
void reportGround(const JointStores& stores, const std::vector<BodyIndex>& some, Change&& change) {
    const Vec2 before = stores.observer != nullptr ? momentumOf(stores.bodies, some) : Vec2(0, 0);
    change();
    if (stores.observer != nullptr) stores.observer->noteGround(momentumOf(stores.bodies, some) - before);
}

bool touches(const BodyStore& bodies, const JointIsland& island) {
    return std::any_of(island.bodies.begin(), island.bodies.end(),
                       [&](BodyIndex body) { return bodies.links[body].solverContacts > 0; });
}

/// The turn of a link that is followed well in one move [rad].
constexpr double followed = 0.12;

/// May a link of the island turn faster than this rate [rad/s]?
bool mayTurn(const JointStores& stores, const JointIsland& island, double rate) {
    return island.layout->someAlong || std::any_of(island.bodies.begin(), island.bodies.end(), [&](BodyIndex body) {
               return std::fabs(stores.bodies.motion[body].angularVelocity) > rate;
           });
}

/// How fast the island's links turn, or swing under the forces along them if that is not much more [rad/s].
double turningOf(const JointStores& stores, const JointIsland& island) {
    constexpr double mostSwing = 4, swing = 0.24;
    double turning = 0, stiffness = 0;
    for (const LaidJoint& joint : island.laid) turning = std::max(turning, turningOf(joint.form, stores.bodies));
    for (std::size_t b = 0; b < island.bodies.size(); ++b) {
        const double inverseInertia = stores.bodies.record[island.bodies[b]].inverseInertia;
        stiffness = std::max(stiffness, 2 * island.stiffness[b].swinging * inverseInertia);
    }
    return std::max(turning, std::min(swing * std::sqrt(stiffness), mostSwing * turning));
}

/// Where links turn fast, an island that touches nothing moves in pieces of a sub-step: contacts would not see what
/// happens within. Each change of their number costs some energy, so it rises early and falls slowly.
void choosePieces(const JointStores& stores, JointIsland& island, double dt) {
    constexpr double memory = 2;  ///< in which the turning of former steps is forgotten [s]
    constexpr int most = 16;
    const double h = dt / stores.settings.subSteps, last = std::exchange(island.turning, 0.0);
    island.pieces = 1;
    island.touches = touches(stores.bodies, island);
    if (island.touches) {
        island.mostTurning = 0;
        return;
    }
    if (mayTurn(stores, island, followed / h / 8)) island.turning = turningOf(stores, island);
    island.mostTurning = std::max(island.mostTurning * (1 - std::min(dt / memory, 1.0)), 2 * island.turning - last);
    const double turn = std::max(island.turning, island.mostTurning) * h;
    while (island.pieces < most && turn > followed * island.pieces) island.pieces *= 2;
}

/// Cuts groups of equal islands that move in as many pieces into batches, as many islands in each as there are lanes.
/// Those that touch something come first in their group, because after contacts only they are solved again.
std::vector<std::span<JointIsland*>> cutBatches(const JointStores& stores, std::vector<JointIsland*>& islands) {
    JointIslands& found = stores.islands;
    for (const std::vector<std::uint32_t>& group : found.alike)
        for (const std::uint32_t i : group) islands.push_back(&found.islands[i]);
    std::vector<std::span<JointIsland*>> batches;
    std::span<JointIsland*> rest = islands;
    for (const std::vector<std::uint32_t>& group : found.alike) {
        std::span<JointIsland*> left = rest.first(group.size());
        rest = rest.subspan(group.size());
        const auto orderOf = [](const JointIsland* island) { return std::pair(island->pieces, !island->touches); };
        std::stable_sort(left.begin(), left.end(),
                         [&](const JointIsland* a, const JointIsland* b) { return orderOf(a) < orderOf(b); });
        while (!left.empty()) {
            std::size_t width = static_cast<std::size_t>(islandLanes(stores.settings.lanes));
            const int pieces = left.front()->pieces;
            const auto alike = std::find_if(left.begin(), left.end(),
                                            [&](const JointIsland* island) { return island->pieces != pieces; });
            while (width > static_cast<std::size_t>(alike - left.begin())) width /= 2;
            batches.push_back(left.first(width));
            left = left.subspan(width);
        }
    }
    return batches;
}

/// Batches that meet no contact come last: they go through the whole step one after the other, while their numbers are
/// in the cache. Batches that are not needed are kept, with the room for their numbers: how many there are changes from
/// step to step.
void loadBatches(const JointStores& stores, double dt, bool mayFly) {
    JointIslands& found = stores.islands;
    const double h = dt / stores.settings.subSteps;
    for (JointIsland& island : found.islands)
        if (!island.isSwept()) choosePieces(stores, island, dt);
    std::vector<JointIsland*> islands;
    std::vector<std::span<JointIsland*>> batches = cutBatches(stores, islands);
    const auto flying = std::stable_partition(batches.begin(), batches.end(),
                                              [&](const auto& some) { return !mayFly || some.front()->touches; });
    found.batchCount = batches.size();
    found.meeting = static_cast<std::size_t>(flying - batches.begin());
    if (found.batches.size() < batches.size()) found.batches.resize(found.islands.size());
    for (std::size_t i = 0; i < batches.size(); ++i) found.batches[i].load(batches[i], stores.joints, stores.bodies, h);
    found.sweptBatches.resize(found.swept.size());
    for (std::size_t i = 0; i < found.swept.size(); ++i) {
        JointIsland* alone = &found.swept[i];
        found.sweptBatches[i].load({&alone, 1}, stores.joints, stores.bodies, h);
    }
}

/// Fields act next, on the records: so they must see the free velocities.
void kickBatches(const JointStores& stores, const JointHalf& half) {
    for (JointBatch& batch : batchesOf(stores)) {
        batch.kick(stores.bodies, half.correct);
        writeVelocities(batch.numbers, stores.bodies, BodyField::FreeX);
    }
}

void flyBatch(const JointStores& stores, JointBatch& batch, const JointHalf& half) {
    batch.kick(stores.bodies, half.correct);
    batch.solve(stores.bodies, turnOf(stores, half));
    batch.note(stores.observer);
}

/// The bodies of swept islands have been moved by their records.
void moveBatches(const JointStores& stores, std::span<JointBatch> batches, double h) {
    for (JointBatch& batch : batches) batch.move(stores.bodies, h, stores.settings.contactPushSpeed, stores.observer);
    for (JointBatch& batch : stores.islands.sweptBatches) batch.noteMoves();
}

std::vector<BodyIndex> bodiesOf(const JointBatch& batch) {
    std::vector<BodyIndex> bodies;
    for (const JointIsland* island : batch.islands())
        bodies.insert(bodies.end(), island->bodies.begin(), island->bodies.end());
    return bodies;
}

/// Calls change(), and reports what it changed in the momentum of the batch's bodies.
template <class Change>
void reportGround(const JointStores& stores, const JointBatch& batch, Change&& change) {
    reportGround(stores, stores.observer != nullptr ? bodiesOf(batch) : std::vector<BodyIndex>(),
                 std::forward<Change>(change));
}

/// Swept islands are solved joint by joint, with soft corrections. Each joint is solved from velocities without its own
/// impulse, which so need not be kept.
void sweepHinges(const JointStores& stores, JointIsland& island, const JointHalf& half) {
    island.hinges.solve(hingeSolver(stores.settings.lanes), stores.bodies.solverBodies(), hingePassOf(stores, half));
}

/// Other joints than hinges get the same softness. Where a soft hinge takes back a part of its old impulse, their rows
/// have a compliance.
void sweepJoint(const JointStores& stores, JointBatch& batch, const JointHalf& half) {
    IslandTurn turn = turnOf(stores, half);
    double compliance = 0;
    if (half.correct) {
        const Softness soft = hingePassOf(stores, half).soft;
        turn.share = static_cast<double>(soft.biasRate) * half.step;
        compliance = static_cast<double>(soft.impulseScale / soft.massScale);
    }
    batch.sweep(stores.bodies, turn, compliance, stores.observer);
}

void solveJoints(const JointStores& stores, const JointHalf& half, bool kicked) {
    const IslandTurn turn = turnOf(stores, half);
    for (JointBatch& batch : batchesOf(stores)) {
        if (kicked)
            pullVelocities(batch.numbers, stores.bodies, BodyField::FreeX);
        else
            batch.kick(stores.bodies, half.correct);
        batch.solve(stores.bodies, turn);
    }
    for (JointIsland& island : stores.islands.islands)
        if (island.isSwept()) reportGround(stores, island.bodies, [&] { sweepHinges(stores, island, half); });
    for (JointBatch& batch : stores.islands.sweptBatches)
        reportGround(stores, batch, [&] { sweepJoint(stores, batch, half); });
}

void bounceJointed(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                   const std::vector<BounceGroup>& bounces, double h) {
    if (!bounces.empty()) bounceJointedBodies(stores, graph, contacts, bounces, h);
}

void storeBatches(const JointStores& stores, std::vector<std::pair<BodyIndex, BodyMove>>& moves) {
    for (JointBatch& batch : std::span(stores.islands.batches).first(stores.islands.batchCount)) {
        batch.pull(stores.bodies);
        batch.store(stores.joints, stores.bodies);
        for (std::size_t lane = 0; lane < batch.islands().size(); ++lane) {
            const std::vector<BodyIndex>& bodies = batch.islands()[lane]->bodies;
            for (std::size_t node = 0; node < bodies.size(); ++node)
                moves.emplace_back(bodies[node], moveOf(batch.numbers, node, lane));
        }
    }
    for (JointBatch& batch : stores.islands.sweptBatches) batch.store(stores.joints, stores.bodies);
    for (const JointIsland& island : stores.islands.islands) island.hinges.addLoads(stores.joints);
}

/// Reports only what came through joints from fixed bodies: the impulse itself is taken off again.
void pushJointed(const JointStores& stores, JointIsland& island, BodyIndex body, const Vec3& impulse) {
    reportGround(stores, island.bodies, [&] {
        pullMoves(island.batch->numbers, stores.bodies, island.lane);
        island.batch->push(stores.bodies, island.lane, island.nodeOf(body), impulse);
        island.batch->addLoads(island.lane);
    });
    if (stores.observer != nullptr) stores.observer->noteGround(-Vec2(impulse[0], impulse[1]));
}

void closeGapsOf(const JointStores& stores, JointIsland& island, double h) {
    pullMoves(island.batch->numbers, stores.bodies, island.lane);
    reportGround(stores, island.bodies,
                 [&] { island.batch->closeGaps(stores.bodies, island.lane, h, stores.settings.contactPushSpeed); });
}

Vec3 responseOf(const JointStores& stores, JointIsland& island, BodyIndex body, const Vec3& impulse) {
    pullMoves(island.batch->numbers, stores.bodies, island.lane);
    return island.batch->responseTo(island.lane, island.nodeOf(body), impulse);
}

double openingOf(const JointIsland& island) {
    return island.batch->numbers.openingOf(island.lane);
}

}  // namespace

const JointPhases jointPhases{.prepare = prepareJoints,
                              .load = loadBatches,
                              .fly = flyBatch,
                              .kick = kickBatches,
                              .move = moveBatches,
                              .solve = solveJoints,
                              .takeBounces = takeJointedBounces,
                              .bounce = bounceJointed,
                              .findJointedContacts = findJointedContacts,
                              .startContacts = startContacts,
                              .respondToContacts = respondToContacts,
                              .push = pushJointed,
                              .responseOf = responseOf,
                              .opening = openingOf,
                              .hold = closeGapsOf,
                              .store = storeBatches,
                              .springEnergy = springEnergy};

}  // namespace plumb
