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

struct Pass {
    ContactPass contacts, groundContacts;
};

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

/// May the body meet something, and so fast that it could pass? What goes around a world that wraps has no contacts
/// along its way.
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
/// predicts, and kinematic bodies, whose motion their contacts need. Filled up to a multiple of the lanes with slot 0,
/// which never moves.
std::vector<BodyIndex> solvedBodies(const BodyStore& bodies) {
    std::vector<BodyIndex> solved;
    solved.reserve(bodies.awake.size() + batchLanes);
    for (const BodyIndex body : bodies.awake)
        if (bodies.isConstrained(body) || bodies.record[body].type == BodyType::Kinematic || mayPass(bodies, body))
            solved.push_back(body);
    fillUp(solved);
    return solved;
}

/// A rotation turned by a small angle, with a series in double that is exact to rounding.
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

/// One kind of pass over all contacts: a function of ContactSolver.
using ContactWork = void (*ContactSolver::*)(ContactBatch*, std::size_t, const SolverBodies&, const ContactPass&);

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

    void run(double dt) {
        if (joints_ != nullptr) joints_->prepare(stores_.joints, dt);
        if (solved_.empty()) return;
        if (joints_ != nullptr)
            bounces_ = joints_->takeBounces(stores_.graph, stores_.contacts, bodies_, stores_.joints.islands);
        if (joints_ != nullptr) loadJoints(dt);
        if (joints_ != nullptr) stepFlying();
        if (observer_ != nullptr) observer_->beginSolver();
        forEachSlice([this](const ContactSolver& solver, ContactBatch* batches, std::size_t contacts,
                            const ContactPass&) { solver.gatherWarmStart(batches, contacts, solverBodies_); });
        for (int i = 0; i < stores_.settings.subSteps; ++i) subStep(i);
        if (loads_) loads_->end();
        bounceContacts();
        storeBodies();
        if (observer_ != nullptr) observer_->endSolver(solved_, dt);
    }

    const std::vector<WallImpact>& wallImpacts() const { return impacts_; }

private:
    /// Bodies in lanes of islands go behind all others; those of flying islands are not among them.
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

    /// What meets no contact goes through the whole step at once, batch by batch: its numbers stay at hand.
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

    void subStep(int number) {
        const JointHalf before{h_, true, number == 0}, after{h_, false, false};
        startHalf(before);
        solveContacts(&ContactSolver::solve, before);
        if (observer_ != nullptr) observer_->endHalf();
        move(solved_, batchesOf(stores_.joints), number);
        fields_.moved();
        startHalf(after);
        solveContacts(&ContactSolver::relax, after);
        if (observer_ != nullptr) observer_->endHalf();
    }

    /// batches: those of jointed bodies among them. number: of the sub-step.
    void move(const std::vector<BodyIndex>& bodies, std::span<JointBatch> batches, int number) {
        const float h = static_cast<float>(h_);
        const std::size_t fast = bodySolver_.move(bodies.data(), bodies.size(), solverBodies_, h, fast_.data());
        if (joints_ != nullptr) joints_->move(stores_.joints, batches, h_);
        if (stores_.hasWalls) walls_.afterMove({fast_.data(), fast}, number * h_);
    }

    /// Applies forces and solves joints.
    void startHalf(const JointHalf& half) {
        if (observer_ != nullptr) observer_->beginHalf(solved_);
        kickBodies(solved_.data(), outOfLanes_, solverBodies_, half.isFirst);
        const bool inFields = !bodies_.flights.empty();
        if (inFields && joints_ != nullptr) joints_->kick(stores_.joints, half);
        if (inFields) (fields_.*stores_.fields.phases->kick)(solved_);
        if (joints_ == nullptr || stores_.joints.islands.joints.empty()) return;
        joints_->solve(stores_.joints, half, inFields);
        joints_->bounce(stores_.joints, stores_.graph, stores_.contacts, bounces_, half.step);
        joints_->startContacts(stores_.joints, half, jointed_);
        markBodies(solved_.data(), moving_, solverBodies_);
    }

    void solveContacts(ContactWork work, const JointHalf& half) {
        if (!loads_)  // not before the first half: jointed bodies have the masses of their islands only now
            loads_.emplace(stores_.graph, stores_.contacts, bodies_, solved_, pass_.contacts, pass_.groundContacts);
        loads_->begin();
        forEachSlice([&](const ContactSolver& solver, ContactBatch* batches, std::size_t contacts,
                         const ContactPass& pass) { (solver.*work)(batches, contacts, solverBodies_, pass); });
        half.correct ? loads_->solve() : loads_->relax();
        if (joints_ != nullptr) joints_->answerContacts(stores_.joints, half, jointed_);
    }

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

    /// Contacts with fixed bodies have twice the frequency: the ground does not move. A colour's last batch is solved
    /// with fewer lanes if it is not full.
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

    /// For each body, by its slot: 1 if a contact or joint gave it an impulse, else 0.
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

    BodyMove moveOf(BodyIndex body) const {
        const SolverVelocity& v = bodies_.velocity[body];
        const SolverDisplacement& d = bodies_.displacement[body];
        const SolverTurn& turn = bodies_.turn[body];
        return {Vec2(static_cast<double>(d.x), static_cast<double>(d.y)), static_cast<double>(turn.angle),
                Vec2(static_cast<double>(v.x), static_cast<double>(v.y)),
                static_cast<double>(v.w * turn.inverseGyration)};
    }

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
