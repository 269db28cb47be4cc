// SPDX-License-Identifier: MIT
#include <plumb/dynamics/loads/push_apart.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include <plumb/dynamics/contacts/lanes/contact_solver.h>
#include <plumb/math/detail/sorting.h>
#include <plumb/math/detail/step_list.h>

namespace plumb {

namespace {

/// Deep overlap goes at this rate [1/s], and at most this share of it in a step [-]: so also at long steps it shrinks
/// without a swing to the other side.
constexpr double rate = 8, mostShare = 0.2;
/// The farthest that a point of a body moves in a step, as a share of its inradius [-]: so no shift takes it past a
/// wall.
constexpr double shareOfInradius = 0.25;
/// Sweeps over the contacts [-]. Each one also lets shifts reach the next bodies, those that were pushed in it.
constexpr int sweeps = 12;
/// A body that goes less far than this in a step, as a share of its inradius, pushes nothing [-].
constexpr double leastShift = 1e-3;

/// Moves a body by its shift, without velocity. Its time of stillness begins anew: what is being shifted must not sleep
/// in overlap.
void shift(BodyStore& bodies, BodyIndex body, const SolverVelocity& by, double dt) {
    const BodyRecord& record = bodies.record[body];
    const Vec2 way = Vec2(static_cast<double>(by.x), static_cast<double>(by.y)) * dt;
    const double turn = static_cast<double>(by.w * bodies.turn[body].inverseGyration) * dt;
    const double far = way.norm() + std::fabs(turn) * record.turningRadius;
    const double share = std::min(1.0, shareOfInradius * record.inradius / far);
    BodyMotion motion = bodies.motion[body];
    motion.center += way * share;
    motion.angle += turn * share;
    motion.rotation = Rot::fromAngle(motion.angle);
    storeMotion(bodies, body, motion);
    bodies.record[body].stillTime = 0;
}

/// The contacts of bodies that overlap, and of those that they push, as shifts see them. The problem grows from the
/// bodies that overlap: in each sweep, bodies that were shifted far enough begin to push, and bring their own contacts.
/// So a pyramid at the other end of the world costs no sweep. Copies of the contacts are solved, so their impulses stay
/// as they are.
class Shifts {
public:
    Shifts(const ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies, double dt)
        : graph_(graph),
          contacts_(contacts),
          bodies_(bodies),
          dt_(dt),
          overlaps_(contacts.overlaps.begin(), contacts.overlaps.end()),
          states_(bodies.record.size(), State::Unknown),
          shifts_(bodies.velocity.size()) {
        sortBy(overlaps_, [](const DeepContact& overlap) { return overlap.contact; });
        for (const DeepContact& overlap : contacts.overlaps)
            if (contacts[overlap.contact].isSolved())
                for (const BodyIndex body : bodiesOf(overlap.contact)) push(body);
    }

    void solve(const ContactPass& pass) {
        addContacts();
        SolverBodies moved;
        moved.velocity = shifts_.data();
        contactSolver(1).solve(batches_.data(), count_, moved, pass);
        for (std::size_t i = 0; i < touched_.size(); ++i)
            if (pushes(touched_[i])) push(touched_[i]);
    }

    /// The bodies that have a shift, perhaps of zero.
    const StepList<BodyIndex>& touched() const { return touched_; }
    /// Per second.
    const SolverVelocity& of(BodyIndex body) const { return shifts_[body]; }

private:
    enum class State : std::uint8_t { Unknown, Touched, Pushing, Added };
    static bool before(const DeepContact& a, const DeepContact& b) { return a.contact < b.contact; }

    std::array<BodyIndex, 2> bodiesOf(ContactIndex index) const {
        return {contacts_[index].bodyA, contacts_[index].bodyB};
    }

    void touch(BodyIndex body) {
        if (states_[body] != State::Unknown || !bodies_.canMove(body)) return;
        states_[body] = State::Touched;
        touched_.push_back(body);
        shifts_[body].inverseMass = bodies_.velocity[body].inverseMass;
    }

    void push(BodyIndex body) {
        touch(body);
        if (states_[body] != State::Touched) return;
        states_[body] = State::Pushing;
        pushing_.push_back(body);
    }

    bool pushes(BodyIndex body) const {
        const SolverVelocity& by = shifts_[body];
        const double far = static_cast<double>(std::fabs(by.x) + std::fabs(by.y) + std::fabs(by.w)) * dt_;
        return states_[body] == State::Touched && far > leastShift * bodies_.record[body].inradius;
    }

    /// Adds the contacts of bodies that began to push, in the order in which contacts are solved.
    void addContacts() {
        StepList<ContactIndex> order;
        for (const BodyIndex body : std::exchange(pushing_, {})) {
            states_[body] = State::Added;
            forEachContact(bodies_, contacts_, body, [&](ContactIndex index) {
                const ContactRecord& c = contacts_[index];
                if (c.isSolved() && states_[otherOf(c, body)] != State::Added) order.push_back(index);
            });
        }
        sortBy(order,
               [this](ContactIndex index) { return std::tuple(contacts_[index].colour, shapesOf(contacts_[index])); });
        for (const ContactIndex index : order) add(index);
    }

    /// A contact without impulses and friction, with gaps, and with the overlap that is to go: its depth at the last
    /// step's start, corrected by how far the points have moved since. Overlap that was not put there, as from loads,
    /// counts as a touch: springs have to push it out.
    void add(ContactIndex index) {
        for (const BodyIndex body : bodiesOf(index)) touch(body);
        const ContactRecord& contact = contacts_[index];
        const auto overlap = std::lower_bound(overlaps_.begin(), overlaps_.end(), DeepContact{index, {0, 0}}, before);
        const bool overlapsDeeply = overlap != overlaps_.end() && overlap->contact == index;
        const std::size_t lane = count_++ % batchLanes;
        if (lane == 0) batches_.emplace_back();
        ContactBatch& batch = batches_.back();
        const ConstContactLane from = graph_.laneOf(contact);
        copyLane(batch, lane, from.batch, from.lane, batchRows);
        batch.friction[lane] = 0;
        for (std::size_t point = 0; point < 2; ++point) {
            PointLanes& p = batch.points[point];
            const float closed = p.startSeparation[lane] - p.separation[lane];
            const float left = overlapsDeeply ? std::max(overlap->depth[point] + closed, 0.0f) : 0.0f;
            p.separation[lane] = left > 0 ? -left : std::max(p.separation[lane], 0.0f);
            p.normalImpulse[lane] = p.tangentImpulse[lane] = 0;
        }
    }

    const ContactGraph& graph_;
    const ContactStore& contacts_;
    const BodyStore& bodies_;
    double dt_;
    StepList<DeepContact> overlaps_;  ///< sorted by contact
    StepList<State> states_;
    StepList<SolverVelocity> shifts_;
    StepList<BodyIndex> touched_, pushing_;
    StepList<ContactBatch> batches_;
    std::size_t count_ = 0;  ///< of contacts in the batches
};

}  // namespace

/// The first phase of a step, before bounds are placed, because it moves bodies. Solved by the contact solver for one
/// lane: shift per second in place of velocity. O(contacts of the bodies that are shifted) for each of the sweeps.
void pushApart(const ContactGraph& graph, const ContactStore& contacts, BodyStore& bodies,
               const SolverSettings& settings, double dt) {
    const auto isAwake = [&](const DeepContact& overlap) { return contacts[overlap.contact].isSolved(); };
    if (std::none_of(contacts.overlaps.begin(), contacts.overlaps.end(), isAwake)) return;
    Shifts shifts(graph, contacts, bodies, dt);
    ContactPass pass;
    pass.inverseStep = static_cast<float>(1 / dt);
    pass.soft.biasRate = static_cast<float>(std::min(rate, mostShare / dt));
    pass.pushSpeed = static_cast<float>(settings.contactPushSpeed);
    for (int sweep = 0; sweep < sweeps; ++sweep) shifts.solve(pass);
    for (const BodyIndex body : shifts.touched()) {
        const SolverVelocity& by = shifts.of(body);
        if (by.x != 0 || by.y != 0 || by.w != 0) shift(bodies, body, by, dt);
    }
}

}  // namespace plumb
