// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/solver.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <plumb/dynamics/bodies/body_solver.h>
#include <plumb/dynamics/bodies/load_bodies.h>
#include <plumb/dynamics/contacts/contact_lane.h>
#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/dynamics/loads/load_paths.h>
#include <plumb/dynamics/meetings/wall_impact.h>
#include <plumb/dynamics/walls/wall_limits.h>
#include <plumb/dynamics/walls/wall_stops.h>
#include <plumb/math/detail/for_lanes.h>

namespace plumb {

namespace {

/// A contact's spring may have a quarter of the rate of the sub-steps of h [s]: a stiffer one overshoots. Contacts with
/// fixed bodies get twice the frequency, because the ground does not move. Test: "a box rests as deep at 240 steps a
/// second as at 60, and four times as deep at 30"
ContactPasses passesOf(const SolverSettings& settings, double h) {
    const auto passOf = [&](double frequency) -> ContactPass {
        return {static_cast<float>(1 / h), softness(std::min(frequency, 0.25 / h), settings.contactDampingRatio, h),
                static_cast<float>(settings.contactPushSpeed)};
    };
    return {passOf(settings.contactFrequency), passOf(2 * settings.contactFrequency)};
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

/// To a multiple of the lanes, with slot 0, which never moves.
void fillUp(StepList<BodyIndex>& bodies) {
    while (bodies.size() % batchLanes != 0) bodies.push_back(noBody);
}

/// The bodies that are solved: dynamic bodies with a constraint, or so fast that they could pass a wall that no contact
/// predicts, and kinematic bodies, whose motion their contacts need. All others only fly, and moveFreeBodies places
/// them exactly. O(awake bodies).
StepList<BodyIndex> solvedBodies(const BodyStore& bodies) {
    StepList<BodyIndex> solved;
    for (const BodyIndex body : bodies.awake)
        if (bodies.isConstrained(body) || bodies.record[body].type == BodyType::Kinematic || mayPass(bodies, body))
            solved.push_back(body);
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
    Solver(SolverStores& stores, double dt)
        : stores_(stores),
          bodies_(stores.bodies),
          observer_(stores.observer),
          joints_(stores.jointSolver),
          fields_(*stores.fields.solver),
          h_(dt / stores.settings.subSteps),
          bodySolver_(bodySolver(stores.settings.lanes)),
          solverBodies_(bodies_.solverBodies()),
          solved_(solvedBodies(bodies_)),
          passes_(passesOf(stores.settings, h_)),
          walls_({bodies_, stores.contacts, stores.space, joints_}, h_),
          fast_(solved_.size() + batchLanes) {
        cutSlices();
    }

    /// All sub-steps, and what has to be done once before and after them. Joints begin even if nothing is solved: loads
    /// of joints that no longer hold anything are cleared there.
    void run(double dt) {
        outOfLanes_ = joints_.begin(
            {&stores_.graph, &stores_.contacts, &bodies_, &stores_.joints, stores_.settings, observer_, passes_, h_},
            solved_);
        if (solved_.empty() && joints_.islands().empty()) return;
        fillUp(solved_);
        fields_.begin(stores_.fields, bodies_, stores_.space, h_, observer_);
        joints_.fly([this](StepList<BodyIndex>& bodies, int subStep) {
            fillUp(bodies);
            move(bodies, subStep);
        });
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

    const StepList<WallImpact>& wallImpacts() const { return walls_.impacts(); }

private:
    /// The sub-step: kick, solve, drift, kick, relax. Forces act in two halves around the move, as in velocity Verlet,
    /// so motion under a steady force is exact to second order in h. The first half solves with the position errors,
    /// because its velocities are those of the move: what is too near is pushed apart, and what would meet comes just
    /// to the touch. The second half solves without them, so that the push adds no speed to what the next sub-step
    /// begins with. Without it, a box that was pushed out of overlap would go on rising.
    void subStep(int number) {
        halfStep(&ContactSolver::solve, {true, number == 0, false});
        move(solved_, number);
        halfStep(&ContactSolver::relax, {false, false, number + 1 == stores_.settings.subSteps});
    }

    /// One half, in the order of the velocities that each part needs: forces and the warm start first; then fields,
    /// some of which depend on velocities; then joints, which are solved directly from the free velocities of their
    /// island; then contacts, which see jointed bodies with the masses of their islands; and last the response of
    /// joints to what contacts have changed. Batches of islands kick their own bodies, in doubles.
    void halfStep(ContactWork work, const HalfStep& half) {
        if (observer_ != nullptr) observer_->beginHalf(solved_);
        // In the step's first half, contacts have changed nothing yet that the warm start would have to take in.
        kickBodies(solved_.data(), outOfLanes_, solverBodies_, half.isFirst);
        fields_.kick(solved_);
        joints_.solve(half);
        solveContacts(work, half);
        joints_.respondToContacts(half);
        if (observer_ != nullptr) observer_->endHalf();
    }

    /// Moves bodies by a sub-step: batches of islands move their own bodies in doubles. What crosses a wall on its path
    /// is put back to it; that comes last, because it needs the places of all bodies of a machine. number: of the
    /// sub-step.
    void move(std::span<const BodyIndex> bodies, int number) {
        const float h = static_cast<float>(h_);
        const std::size_t fast = bodySolver_.move(bodies.data(), bodies.size(), solverBodies_, h, fast_.data());
        joints_.move();
        if (stores_.hasWalls) walls_.afterMove({fast_.data(), fast}, number * h_);
        fields_.moved();
    }

    /// One pass over all contacts, in the order of their colours, then the contacts of light bodies under heavy ones.
    /// The contacts of load paths are hidden from the lanes meanwhile: solved twice, with two different springs, they
    /// would work against each other.
    void solveContacts(ContactWork work, const HalfStep& half) {
        if (!loads_)  // not before the first half: jointed bodies have the masses of their islands only now
            loads_.emplace(stores_.graph, stores_.contacts, bodies_, solved_, passes_);
        loads_->begin();
        forEachSlice([&](const ContactSolver& solver, ContactBatch* batches, std::size_t contacts,
                         const ContactPass& pass) { (solver.*work)(batches, contacts, solverBodies_, pass); });
        half.correct ? loads_->solve() : loads_->relax();
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
            const ContactPass& pass = passes_.of(isOfGround(index));
            ContactBatch* batches = colours[index].batches.data();
            const int most = colourAt(index) == overflowColour ? 1 : stores_.settings.lanes;
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

    /// For each body, by its slot: 1 if a contact or a wall gave it an impulse, else 0. O(contacts + bodies).
    StepList<std::uint8_t> pushedBodies() const {
        StepList<std::uint8_t> pushed(bodies_.record.size(), 0);
        for (const Slice& slice : slices_) {
            for (std::size_t i = 0; i < slice.contacts; ++i) {
                const ContactBatch& batch = slice.batches[i / batchLanes];
                const std::size_t lane = i % batchLanes;
                if (batch.pushed[lane] != 0) pushed[batch.bodyA[lane]] = pushed[batch.bodyB[lane]] = 1;
            }
        }
        for (const WallImpact& impact : walls_.impacts()) pushed[stores_.space[impact.hit.own].owner] = 1;
        return pushed;
    }

    /// Adds the displacements to the states in double precision. A predicted contact that was missed has given no
    /// impulse: its bodies stay on their closed form, exactly, and moveFreeBodies moves them after this. Islands in
    /// lanes are stored from the doubles of their batches, not from the floats of the records. Test: "a body passing a
    /// wall at one millimetre without touching it stays on its closed form"
    void storeBodies() {
        const StepList<std::uint8_t> pushed = pushedBodies();
        joints_.end([this](BodyIndex body, const BodyMove* move) { storeBody(body, move ? *move : moveOf(body)); });
        for (const BodyIndex body : std::span(solved_).first(outOfLanes_))
            if (pushed[body] != 0 && bodies_.velocity[body].inverseMass > 0) storeBody(body, moveOf(body));
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
        if (!bodies_.isMovedBy(body, MovedBy::ClosedForm)) return;
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

    SolverStores& stores_;
    BodyStore& bodies_;
    StepObserver* observer_;
    JointSolver& joints_;
    FieldSolver& fields_;
    double h_;  ///< of the sub-step [s]
    const BodySolver& bodySolver_;
    SolverBodies solverBodies_;
    StepList<BodyIndex> solved_;
    std::size_t outOfLanes_ = 0;  ///< number of those before the bodies in lanes of islands, and the padding
    ContactPasses passes_;
    StepList<Slice> slices_;
    std::optional<LoadPaths> loads_;
    WallStops walls_;
    StepList<FastBody> fast_;
};

}  // namespace

/// Called once a step, after impacts and before moveFree. Slot 0 stands for all that is fixed, and fills up lists: it
/// must be at rest. The limits of speed are set before the solver is made, because its list of bodies depends on them.
TouchEvents solveConstraints(SolverStores stores, double dt) {
    stores.bodies.rest(noBody);
    if (stores.hasWalls)
        limitByWalls({stores.bodies, stores.contacts, stores.graph, stores.joints, stores.jointSolver, stores.space},
                     dt);
    Solver solver(stores, dt);
    solver.run(dt);
    TouchEvents touches;
    for (const WallImpact& impact : solver.wallImpacts())
        reportWallImpact(stores, impact, dt, stores.hitSpeed, touches);
    return touches;
}

}  // namespace plumb
