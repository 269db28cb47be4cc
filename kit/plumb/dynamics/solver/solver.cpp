// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/solver.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <plumb/dynamics/bodies/body_solver.h>
#include <plumb/dynamics/bodies/load_bodies.h>
#include <plumb/dynamics/contacts/contact_lane.h>
#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/dynamics/fields/field_phases.h>
#include <plumb/dynamics/joints/joint_islands.h>
#include <plumb/dynamics/loads/load_paths.h>
#include <plumb/dynamics/meetings/wall_impact.h>
#include <plumb/dynamics/walls/wall_limits.h>
#include <plumb/dynamics/walls/wall_stops.h>
#include <plumb/math/detail/for_lanes.h>

namespace plumb {

namespace {

/// The constants of a pass over the contacts: for those of two bodies that move, and for those with a fixed one.
struct Pass {
    ContactPass contacts, groundContacts;
};

/// A contact's spring may have a quarter of the rate of the sub-steps of h [s]: a stiffer one overshoots. Contacts with
/// fixed bodies get twice the frequency, because the ground does not move. Test: "a box rests as deep at 240 steps a
/// second as at 60, and four times as deep at 30"
Pass passOf(const SolverSettings& settings, double h) {
    Pass pass;
    const auto contactPass = [&](double frequency) -> ContactPass {
        return {static_cast<float>(1 / h), softness(std::min(frequency, 0.25 / h), settings.contactDampingRatio, h),
                static_cast<float>(settings.contactPushSpeed)};
    };
    pass.contacts = contactPass(settings.contactFrequency);
    pass.groundContacts = contactPass(2 * settings.contactFrequency);
    return pass;
}

/// May the body meet something, and is it so fast that it could pass it? Such a body takes part in the sub-steps only
/// so that WallStops sees its path. The bound is that of SolverTurn, as limitByWalls has left it. What goes around a
/// world that wraps has no contacts along its path.
bool mayPass(const BodyStore& bodies, BodyIndex body) {
    if (!(speedSquared(bodies.velocity[body]) > bodies.turn[body].farSpeedSquared)) return false;
    const BodyPlace& place = bodies.place[body];
    const Vec2 shift(static_cast<double>(place.shiftX), static_cast<double>(place.shiftY));
    return bodies.links[body].firstContact != none || bodies.wrap.isExceededBy(shift);
}

void fillUp(std::vector<BodyIndex>& bodies) {
    while (bodies.size() % batchLanes != 0) bodies.push_back(noBody);
}

/// The bodies that are solved: dynamic bodies with a constraint, or so fast that they could pass a wall that no contact
/// predicts, and kinematic bodies, whose motion their contacts need. All others only fly, and moveFreeBodies places
/// them exactly. Filled up to a multiple of the lanes with slot 0, which never moves. O(awake bodies).
std::vector<BodyIndex> solvedBodies(const BodyStore& bodies) {
    std::vector<BodyIndex> solved;
    solved.reserve(bodies.awake.size() + batchLanes);
    for (const BodyIndex body : bodies.awake)
        if (bodies.isConstrained(body) || bodies.record[body].type == BodyType::Kinematic || mayPass(bodies, body))
            solved.push_back(body);
    fillUp(solved);
    return solved;
}

/// A rotation turned by a small angle. The series reach up to t^9 / 9! and t^10 / 10!: below 0.1 rad the next terms are
/// less than the rounding of a double, so no sine need be computed for each body and step. Products of rotations drift
/// in length by a rounding each; one step of Newton's method for 1 / sqrt(c^2 + s^2) brings it back to 1.
Rot turnedOn(const BodyMotion& motion, double turn) {
    if (std::fabs(turn) > 0.1) return Rot::fromAngle(motion.angle);
    const double t2 = turn * turn;
    const double sin = turn * (1 - t2 / 6 * (1 - t2 / 20 * (1 - t2 / 42 * (1 - t2 / 72))));
    const double cos = 1 - t2 / 2 * (1 - t2 / 12 * (1 - t2 / 30 * (1 - t2 / 56 * (1 - t2 / 90))));
    const Rot& r = motion.rotation;
    const double c = r.cos * cos - r.sin * sin;
    const double s = r.sin * cos + r.cos * sin;
    const double stretch = 1.5 - 0.5 * (c * c + s * s);  // back to length 1, to first order
    Rot turned;
    turned.cos = c * stretch;
    turned.sin = s * stretch;
    return turned;
}

/// One kind of pass over all contacts: ContactSolver::solve or relax.
using ContactWork = void (*ContactSolver::*)(ContactBatch*, std::size_t, const SolverBodies&, const ContactPass&);

/// The sub-steps of one step. During them, velocities and displacements are floats, relative to the state at the step's
/// start in BodyStore.motion. That state stays untouched until storeBodies adds the displacement to it in double
/// precision: so a body may be far from the origin, and still move by micrometres. Many short sub-steps with one pass
/// over the contacts each reduce errors more than as many passes over one long step: Macklin et al., "Small steps in
/// physics simulation", SCA 2019.
class Solver {
public:
    Solver(const SolverStores& stores, double dt)
        : stores_(stores),
          bodies_(stores.bodies),
          observer_(stores.observer),
          joints_(stores.jointPhases),
          h_(dt / stores.settings.subSteps),
          bodySolver_(bodySolver(stores.settings.lanes)),
          solverBodies_(bodies_.solverBodies()),
          solved_(solvedBodies(bodies_)),
          moving_(static_cast<std::size_t>(std::find(solved_.begin(), solved_.end(), noBody) - solved_.begin())),
          outOfLanes_(moving_),
          pass_(passOf(stores.settings, h_)),
          fields_(stores.fields, bodies_, stores.space, h_, observer_),
          jointed_{stores.graph, stores.contacts, pass_.contacts, pass_.groundContacts},
          walls_({bodies_, stores.contacts, stores.space, stores.jointPhases, stores.joints}, h_),
          fast_(solved_.size()) {
        cutSlices();
    }

    /// All sub-steps, and what has to be done once before and after them. Joints are prepared even if nothing is
    /// solved: loads of joints that no longer hold anything are cleared there.
    void run(double dt) {
        if (joints_ != nullptr) joints_->prepare(stores_.joints, dt);
        if (solved_.empty()) return;
        if (joints_ != nullptr)
            bounces_ = joints_->takeBounces(stores_.graph, stores_.contacts, bodies_, stores_.joints.islands);
        // Only now, when each island knows its bodies: which of them are solved in lanes, and which meet nothing.
        if (joints_ != nullptr) loadJoints(dt);
        if (joints_ != nullptr) stepFlying();
        if (observer_ != nullptr) observer_->beginSolver();
        forEachSlice([this](const ContactSolver& solver, ContactBatch* batches, std::size_t contacts,
                            const ContactPass&) { solver.gatherWarmStart(batches, contacts, solverBodies_); });
        // The impulses of the last step are the first guess of this one. They are summed once for each body, because
        // every half sub-step applies them anew, together with gravity (kickBodies).
        for (int i = 0; i < stores_.settings.subSteps; ++i) subStep(i);
        if (loads_) loads_->end();
        // After the last sub-step only: a later pass would take a rebound for an impulse that was too large, and take
        // it back.
        bounceContacts();
        storeBodies();
        if (observer_ != nullptr) observer_->endSolver(solved_, dt);
    }

    const std::vector<WallImpact>& wallImpacts() const { return impacts_; }

private:
    /// Finds out how each jointed body is solved, and sorts solved_ by that: first bodies of swept islands and without
    /// joints, which the passes over records kick; from outOfLanes_ on those that batches of islands kick in doubles.
    /// Those of flying islands go out of the list. No island may fly while the ledger watches, which has to see all
    /// velocities before and after each half, nor while fields act, which read the records of bodies.
    void loadJoints(double dt) {
        joints_->load(stores_.joints, dt, observer_ == nullptr && bodies_.flights.empty());
        if (stores_.joints.islands.islands.empty()) return;
        enum Place : std::uint8_t { OutOfLanes, InLanes, Flying };
        std::vector<Place> places(bodies_.record.size(), OutOfLanes);
        for (const JointIsland& island : stores_.joints.islands.islands)
            for (const BodyIndex body : island.bodies) places[body] = island.isSwept() ? OutOfLanes : InLanes;
        for (const JointBatch& batch : flyingBatchesOf(stores_.joints))
            for (const JointIsland* island : batch.islands())
                for (const BodyIndex body : island->bodies) places[body] = Flying;
        solved_.resize(moving_);
        std::erase_if(solved_, [&](BodyIndex body) { return places[body] == Flying; });
        const auto lanes = std::stable_partition(solved_.begin(), solved_.end(),
                                                 [&](BodyIndex body) { return places[body] == OutOfLanes; });
        moving_ = solved_.size();
        outOfLanes_ = static_cast<std::size_t>(lanes - solved_.begin());
        fillUp(solved_);
        joints_->findJointedContacts(stores_.joints, jointed_);
    }

    /// What meets no contact goes through the whole step at once, batch by batch, so that its numbers stay in the
    /// cache: a batch of eight dolls has 180 KB. A rain of dolls took 0.6 to 0.67 times as long as with all batches in
    /// each half.
    void stepFlying() {
        for (JointBatch& batch : flyingBatchesOf(stores_.joints)) {
            std::vector<BodyIndex> flying;
            for (const JointIsland* island : batch.islands())
                flying.insert(flying.end(), island->bodies.begin(), island->bodies.end());
            fillUp(flying);
            for (int i = 0; i < stores_.settings.subSteps; ++i) {
                joints_->fly(stores_.joints, batch, {h_, true, i == 0});
                move(flying, {&batch, 1}, i);
                joints_->fly(stores_.joints, batch, {h_, false, false});
            }
        }
    }

    /// The sub-step: kick, solve, drift, kick, relax. Forces act in two halves around the move, as in velocity Verlet,
    /// so motion under a steady force is exact to second order in h. The first half solves with the position errors,
    /// because its velocities are those of the move: what is too near is pushed apart, and what would meet comes just
    /// to the touch. The second half solves without them, so that the push adds no speed to what the next sub-step
    /// begins with. Without it, a box that was pushed out of overlap would go on rising.
    void subStep(int number) {
        // In the step's first half, contacts have changed nothing yet that the warm start would have to take in.
        const JointHalf before{h_, true, number == 0}, after{h_, false, false};
        startHalf(before);
        solveContacts(&ContactSolver::solve, before);
        if (observer_ != nullptr) observer_->endHalf();
        // These velocities keep contacts and joints, up to the errors that one pass leaves. What crosses a wall on its
        // path is put back to it.
        move(solved_, batchesOf(stores_.joints), number);
        // Fields pull where the bodies are now: the pulls of the first half do not hold any more.
        fields_.moved();
        startHalf(after);
        solveContacts(&ContactSolver::relax, after);
        if (observer_ != nullptr) observer_->endHalf();
    }

    /// Moves bodies by a sub-step, then looks for walls that the fast ones have crossed. Batches move their own bodies
    /// in doubles; walls come last, because they need the places of all bodies of a machine. batches: those of jointed
    /// bodies among them. number: of the sub-step.
    void move(const std::vector<BodyIndex>& bodies, std::span<JointBatch> batches, int number) {
        const float h = static_cast<float>(h_);
        const std::size_t fast = bodySolver_.move(bodies.data(), bodies.size(), solverBodies_, h, fast_.data());
        if (joints_ != nullptr) joints_->move(stores_.joints, batches, h_);
        if (stores_.hasWalls) walls_.afterMove({fast_.data(), fast}, number * h_);
    }

    /// Everything of a half before contacts are solved. The order is that of the velocities that each part needs:
    /// forces and the warm start first; then fields, some of which depend on velocities; then joints, which are solved
    /// directly from the free velocities of their island; then bounces of jointed bodies, from velocities with which
    /// joints hold; and last the masses with which contacts see jointed bodies. What forces and joints have changed is
    /// marked as the new reference: else the next half would take it for impulses of contacts, and apply it once more
    /// (see solver_body.h).
    void startHalf(const JointHalf& half) {
        if (observer_ != nullptr) observer_->beginHalf(solved_);
        // Batches of islands kick their own bodies, in doubles.
        kickBodies(solved_.data(), outOfLanes_, solverBodies_, half.isFirst);
        const bool inFields = !bodies_.flights.empty();
        // Fields read and write the records of bodies, so batches write their free velocities there first.
        if (inFields && joints_ != nullptr) joints_->kick(stores_.joints, half);
        if (inFields) (fields_.*stores_.fields.phases->kick)(solved_);
        if (joints_ == nullptr || stores_.joints.islands.joints.empty()) return;
        joints_->solve(stores_.joints, half, inFields);
        joints_->bounce(stores_.joints, stores_.graph, stores_.contacts, bounces_, half.step);
        joints_->startContacts(stores_.joints, half, jointed_);
        markBodies(solved_.data(), moving_, solverBodies_);
    }

    /// One pass over all contacts, in the order of their colours, then the contacts of light bodies under heavy ones,
    /// then the response of joints to the contacts' impulses. The contacts of load paths are hidden from the lanes
    /// meanwhile: solved twice, with two different springs, they would work against each other.
    void solveContacts(ContactWork work, const JointHalf& half) {
        if (!loads_)  // not before the first half: jointed bodies have the masses of their islands only now
            loads_.emplace(stores_.graph, stores_.contacts, bodies_, solved_, pass_.contacts, pass_.groundContacts);
        loads_->begin();
        forEachSlice([&](const ContactSolver& solver, ContactBatch* batches, std::size_t contacts,
                         const ContactPass& pass) { (solver.*work)(batches, contacts, solverBodies_, pass); });
        half.correct ? loads_->solve() : loads_->relax();
        if (joints_ != nullptr) joints_->respondToContacts(stores_.joints, half, jointed_);
    }

    /// Restitution, at the step's end: only points that have pushed in this step part, at the speed that their approach
    /// at the step's start demands.
    void bounceContacts() {
        if (observer_ != nullptr) observer_->beginBounces();
        forEachSlice([this](const ContactSolver& solver, ContactBatch* batches, std::size_t contacts,
                            const ContactPass&) { solver.bounce(batches, contacts, solverBodies_); });
        if (observer_ != nullptr) observer_->endBounces();
    }

    /// Contacts that are solved with one number of lanes.
    struct Slice {
        const ContactSolver* solver;
        ContactBatch* batches;
        std::size_t contacts;
        const ContactPass* pass;
    };

    /// Cuts the contacts into runs with one solver and one pass each, once a step, so that passes need not look at
    /// empty colours. Contacts with fixed bodies come last in the order of colours, so their error is the smallest. A
    /// colour's last batch is solved with fewer lanes if it is not full: in a small world most of its lanes would be
    /// empty. In the overflow colour bodies repeat, so its contacts are solved one after the other.
    void cutSlices() {
        auto& colours = stores_.graph.colours;
        for (std::size_t index = 0; index < colours.size(); ++index) {
            const std::size_t contacts = colours[index].contactOf.size(), rest = contacts % batchLanes;
            if (contacts == 0) continue;
            const int colour = colourAt(index);
            const bool ground = colour >= fixedColour && colour != overflowColour;
            const ContactPass& pass = ground ? pass_.groundContacts : pass_.contacts;
            ContactBatch* batches = colours[index].batches.data();
            const int most = colour == overflowColour ? 1 : stores_.settings.lanes;
            if (contacts > rest) slices_.push_back({&contactSolver(most), batches, contacts - rest, &pass});
            if (rest == 0) continue;
            slices_.push_back({&contactSolver(lanesFor(rest, most)), batches + contacts / batchLanes, rest, &pass});
        }
    }

    /// Calls solve(solver, batches, contacts, pass).
    template <class Solve>
    void forEachSlice(Solve&& solve) {
        for (const Slice& s : slices_) solve(*s.solver, s.batches, s.contacts, *s.pass);
    }

    /// For each body, by its slot: 1 if a contact, a wall or a swept joint gave it an impulse, else 0. Bodies of
    /// islands in lanes have 0, because their batches store them. O(contacts + bodies).
    std::vector<std::uint8_t> pushedBodies() const {
        std::vector<std::uint8_t> pushed(bodies_.record.size(), 0);
        for (const Slice& slice : slices_) {
            for (std::size_t i = 0; i < slice.contacts; ++i) {
                const ContactBatch& batch = slice.batches[i / batchLanes];
                const std::size_t lane = i % batchLanes;
                if (batch.pushed[lane] != 0) pushed[batch.bodyA[lane]] = pushed[batch.bodyB[lane]] = 1;
            }
        }
        for (const WallImpact& impact : impacts_) pushed[stores_.space[impact.hit.own].owner] = 1;
        if (joints_ == nullptr) return pushed;
        for (const JointIsland& island : stores_.joints.islands.islands)
            for (const BodyIndex body : island.bodies) pushed[body] = island.isSwept() ? 1 : 0;
        return pushed;
    }

    /// Adds the displacements to the states in double precision. A predicted contact that was missed has given no
    /// impulse: its bodies stay on their closed form, exactly, and moveFreeBodies moves them after this. Islands in
    /// lanes are stored from the doubles of their batches, not from the floats of the records. Test: "a body passing a
    /// wall at one millimetre without touching it stays on its closed form"
    void storeBodies() {
        impacts_ = walls_.impacts();
        const std::vector<std::uint8_t> pushed = pushedBodies();
        for (const BodyIndex body : solved_) {
            if (pushed[body] != 0 && bodies_.velocity[body].inverseMass > 0) storeBody(body, moveOf(body));
        }
        if (joints_ == nullptr) return;
        std::vector<std::pair<BodyIndex, BodyMove>> moves;
        joints_->store(stores_.joints, moves);
        for (const auto& [body, move] : moves) storeBody(body, move);
    }

    /// Of a body that is not in lanes; spin = w / k, as velocities are stored with w = omega k (see SolverVelocity).
    BodyMove moveOf(BodyIndex body) const {
        const SolverVelocity& v = bodies_.velocity[body];
        const SolverDisplacement& d = bodies_.displacement[body];
        const SolverTurn& turn = bodies_.turn[body];
        return {Vec2(static_cast<double>(d.x), static_cast<double>(d.y)), static_cast<double>(turn.angle),
                Vec2(static_cast<double>(v.x), static_cast<double>(v.y)),
                static_cast<double>(v.w * turn.inverseGyration)};
    }

    /// Leaves out discs that slide along a chain: their contacts are solved for impulses and events, their motion is
    /// the closed form's. Contacts have seen a jointed body with the mass of its island; from here on its own mass
    /// counts again.
    void storeBody(BodyIndex body, const BodyMove& move) {
        if (bodies_.isMovedBy(body, MovedBy::Impacts)) return;
        bodies_.step[body].movedBy = MovedBy::Solver;
        BodyMotion motion = bodies_.motion[body];
        motion.center += move.shift;
        motion.velocity = move.velocity;
        motion.angularVelocity = move.spin;
        const BodyRecord& record = bodies_.record[body];
        if (record.inverseGyration != bodies_.turn[body].inverseGyration ||
            static_cast<float>(record.inverseMass) != bodies_.velocity[body].inverseMass)
            setSolverMass(stores_.graph, stores_.contacts, bodies_, body, static_cast<float>(record.inverseMass),
                          record.inverseGyration);
        motion.angle += move.turn;
        motion.rotation = turnedOn(motion, move.turn);
        storeMotion(bodies_, body, motion);
    }

    const SolverStores& stores_;
    BodyStore& bodies_;
    StepObserver* observer_;
    const JointPhases* joints_;
    double h_;  ///< of the sub-step [s]
    const BodySolver& bodySolver_;
    SolverBodies solverBodies_;
    std::vector<BodyIndex> solved_;
    std::size_t
        moving_;  ///< number of those before the padding, whose records all are one: each would wait for the last
    std::size_t outOfLanes_;  ///< number of those before the bodies in lanes of islands
    Pass pass_;
    std::vector<Slice> slices_;
    FieldSolving fields_;
    std::vector<BounceGroup> bounces_;  ///< of jointed bodies
    JointedContacts jointed_;
    std::optional<LoadPaths> loads_;
    WallStops walls_;
    std::vector<FastBody> fast_;
    std::vector<WallImpact> impacts_;
};

}  // namespace

/// Called once a step, after impacts and before moveFree. Slot 0 stands for all that is fixed, and fills up lists: it
/// must be at rest. The limits of speed are set before the solver is made, because its list of bodies depends on them.
TouchEvents solveConstraints(const SolverStores& stores, double dt) {
    stores.bodies.rest(noBody);
    if (stores.hasWalls) limitByWalls(stores.bodies, stores.contacts, stores.space, dt);
    Solver solver(stores, dt);
    solver.run(dt);
    TouchEvents touches;
    const WallTouchStores found{stores.graph, stores.contacts, stores.bodies, stores.space, stores.observer};
    for (const WallImpact& impact : solver.wallImpacts()) reportWallImpact(found, impact, dt, stores.hitSpeed, touches);
    return touches;
}

}  // namespace plumb
