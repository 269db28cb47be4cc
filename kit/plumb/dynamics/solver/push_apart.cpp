// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/push_apart.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>
#include <vector>

#include <plumb/dynamics/contacts/lanes/contact_solver.h>

namespace plumb {

namespace {

/// DeepContact goes at this rate [1/s], and at most this share of it in a step [-].
constexpr double rate = 8, mostShare = 0.2;
/// The farthest that a point of a body moves in a step, as a share of its inradius [-].
constexpr double shareOfInradius = 0.25;
constexpr int sweeps = 12;

/// All contacts of the islands in which something overlaps, in the order in which they are solved.
std::vector<ContactIndex> contactsToShift(const ContactStore& contacts, const BodyStore& bodies) {
    std::vector<bool> seen(bodies.record.size(), false);
    std::vector<BodyIndex> reached;
    const auto reach = [&](const ContactRecord& contact) {
        if (!contact.isSolved()) return;
        for (const BodyIndex body : {contact.bodyA, contact.bodyB}) {
            if (seen[body] || !bodies.canMove(body)) continue;
            seen[body] = true;
            reached.push_back(body);
        }
    };
    for (const DeepContact& overlap : contacts.overlaps) reach(contacts[overlap.contact]);
    using Place = std::tuple<std::uint32_t, ProxyId, ProxyId, double, double>;
    std::vector<std::pair<Place, ContactIndex>> order;
    for (std::size_t i = 0; i < reached.size(); ++i)
        forEachContact(bodies, contacts, reached[i], [&](ContactIndex index) {
            const ContactRecord& c = contacts[index];
            reach(c);
            const bool isFirst = c.bodyA == reached[i] || !bodies.canMove(c.bodyA);
            if (c.isSolved() && isFirst)
                order.push_back({{c.colour, c.proxyA, c.proxyB, c.shift.x(), c.shift.y()}, index});
        });
    std::sort(order.begin(), order.end());
    std::vector<ContactIndex> found;
    for (const auto& [place, index] : order) found.push_back(index);
    return found;
}

/// The contacts as shifts see them: without impulses and friction, with gaps, and with the overlap that is to go.
std::vector<ContactBatch> shiftBatches(const std::vector<ContactIndex>& some, const ContactGraph& graph,
                                       const ContactStore& contacts) {
    std::vector<DeepContact> overlaps = contacts.overlaps;
    const auto before = [](const DeepContact& a, const DeepContact& b) { return a.contact < b.contact; };
    std::sort(overlaps.begin(), overlaps.end(), before);
    std::vector<ContactBatch> batches((some.size() + batchLanes - 1) / batchLanes, ContactBatch{});
    for (std::size_t i = 0; i < some.size(); ++i) {
        const ContactRecord& contact = contacts[some[i]];
        const auto overlap = std::lower_bound(overlaps.begin(), overlaps.end(), DeepContact{some[i], {0, 0}}, before);
        const bool overlapsDeeply = overlap != overlaps.end() && overlap->contact == some[i];
        ContactBatch& batch = batches[i / batchLanes];
        const std::size_t lane = i % batchLanes, slot = contact.slot;
        copyLane(batch, lane, graph.colours[contact.colour].batches[slot / batchLanes], slot % batchLanes, batchRows);
        batch.friction[lane] = 0;
        for (std::size_t point = 0; point < 2; ++point) {
            PointLanes& p = batch.points[point];
            const float closed = p.startSeparation[lane] - p.separation[lane];
            const float left = overlapsDeeply ? std::max(overlap->depth[point] + closed, 0.0f) : 0.0f;
            p.separation[lane] = left > 0 ? -left : std::max(p.separation[lane], 0.0f);
            p.normalImpulse[lane] = p.tangentImpulse[lane] = 0;
        }
    }
    return batches;
}

/// The shift of each body per second.
std::vector<SolverVelocity> shiftsOf(std::vector<ContactBatch> batches, std::size_t count, const BodyStore& bodies,
                                     const SolverSettings& settings, double dt) {
    std::vector<SolverVelocity> shifts(bodies.velocity.size());
    for (const ContactBatch& batch : batches)
        for (std::size_t lane = 0; lane < batchLanes; ++lane)
            for (const BodyIndex body : {batch.bodyA[lane], batch.bodyB[lane]})
                shifts[body].inverseMass = bodies.velocity[body].inverseMass;
    SolverBodies moved;
    moved.velocity = shifts.data();
    ContactPass pass;
    pass.inverseStep = static_cast<float>(1 / dt);
    pass.soft.biasRate = static_cast<float>(std::min(rate, mostShare / dt));
    pass.pushSpeed = static_cast<float>(settings.contactPushSpeed);
    for (int sweep = 0; sweep < sweeps; ++sweep) scalarContactSolver.solve(batches.data(), count, moved, pass);
    return shifts;
}

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
    bodies.notePlaced(body);
}

}  // namespace

void pushApart(const ContactGraph& graph, const ContactStore& contacts, BodyStore& bodies,
               const SolverSettings& settings, double dt) {
    if (contacts.overlaps.empty()) return;
    const std::vector<ContactIndex> some = contactsToShift(contacts, bodies);
    std::vector<SolverVelocity> shifts =
        shiftsOf(shiftBatches(some, graph, contacts), some.size(), bodies, settings, dt);
    for (const ContactIndex index : some)
        for (const BodyIndex body : {contacts[index].bodyA, contacts[index].bodyB}) {
            const SolverVelocity by = std::exchange(shifts[body], {});
            if (by.x != 0 || by.y != 0 || by.w != 0) shift(bodies, body, by, dt);
        }
}

}  // namespace plumb
