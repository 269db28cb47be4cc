// SPDX-License-Identifier: MIT
#include <plumb/dynamics/jointed/joint_bounces.h>

#include <algorithm>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/contacts/contact_point.h>
#include <plumb/dynamics/contacts/lanes/single_lane.h>
#include <plumb/dynamics/joints/joint_rows.h>
#include <plumb/impact/detail/bounces.h>
#include <plumb/math/detail/disjoint_sets.h>
#include <plumb/math/detail/sorting.h>

namespace plumb {

namespace {

/// Most impacts per contact in a sub-step. A group with more is a pile, and is left to the solver.
constexpr std::size_t impactsPerContact = 16;
/// Most contacts of a group; a larger group is left to the solver, because each impact examines all of its contacts.
constexpr std::size_t mostBounces = 64;
/// A slower approach is none [m/s].
constexpr double slowestBounce = 1e-6;

/// Calls visit(group) for each run of bounces of one group.
template <class Bounces, class Visit>
void forEachGroup(Bounces& bounces, Visit&& visit) {
    for (auto first = bounces.begin(); first != bounces.end();) {
        const auto last = std::find_if(first, bounces.end(), [&](const auto& b) { return b.group != first->group; });
        visit(std::span(first, last));
        first = last;
    }
}

/// From the centre of mass of one of its bodies to the point [m].
Vec2 armTo(const BodyStore& bodies, const ConstContactLane& at, std::size_t point, bool isB) {
    const double gyration =
        static_cast<double>(bodies.turn[isB ? at.batch.bodyB[at.lane] : at.batch.bodyA[at.lane]].gyration);
    const PointLanes& p = at.batch.points[point];
    const float along = (isB ? p.anchorNormalB : p.anchorNormalA)[at.lane],
                across = (isB ? p.anchorTangentB : p.anchorTangentA)[at.lane];
    const Vec2 n = normalAt(at.batch, at.lane);
    return gyration * (n * static_cast<double>(along) + perp(n) * static_cast<double>(across));
}

}  // namespace

void JointBounces::take(JointStores& stores, std::span<const JointIsland> islands) {
    const BodyStore& bodies = *stores.bodies;
    found_.clear();
    if (islands.empty()) return;
    const auto isJointed = [&](BodyIndex body) { return bodies.links[body].actingJoints > 0; };
    stores.graph->forEachBouncing([&](ContactIndex index) {
        const ContactRecord& contact = (*stores.contacts)[index];
        if (contact.restitution > 0 && (isJointed(contact.bodyA) || isJointed(contact.bodyB)))
            found_.push_back({bodies.canMove(contact.bodyA) ? contact.bodyA : contact.bodyB, index});
    });
    if (found_.empty()) return;
    DisjointSets connected(bodies.record.size());
    for (const JointIsland& island : islands)
        for (const BodyIndex body : island.bodies) connected.unite(body, island.bodies.front());
    for (const Bounce& one : found_) {
        const ContactRecord& contact = (*stores.contacts)[one.contact];
        if (bodies.canMove(contact.bodyA) && bodies.canMove(contact.bodyB))
            connected.unite(contact.bodyA, contact.bodyB);
    }
    for (Bounce& one : found_) one.group = connected.of(one.group);
    sortBy(found_, [](const Bounce& one) { return std::pair(one.group, one.contact); });
    auto end = found_.begin();
    forEachGroup(found_, [&](std::span<Bounce> group) {
        if (group.size() <= mostBounces) end = std::copy(group.begin(), group.end(), end);
    });
    found_.erase(end, found_.end());
    for (const Bounce& one : found_) {
        const ContactLane at = stores.graph->laneOf((*stores.contacts)[one.contact]);
        for (PointLanes& point : at.batch.points) point.bounceSpeed[at.lane] = 0;
    }
}

void JointBounces::solve(JointStores& stores, JointSolver& joints) const {
    forEachGroup(found_, [&](std::span<const Bounce> group) {
        for (std::size_t count = 0; count < impactsPerContact * group.size(); ++count) {
            const Point next = fastest(stores, group);
            if (next.contact == none) break;
            bounce(stores, joints, next);
        }
    });
}

/// The point with the highest approach speed, among those that meet in the sub-step and bounce there.
JointBounces::Point JointBounces::fastest(const JointStores& stores, std::span<const Bounce> group) {
    const BodyStore& bodies = *stores.bodies;
    Point first;
    for (const Bounce& one : group) {
        const ContactRecord& contact = (*stores.contacts)[one.contact];
        const ConstContactLane at = std::as_const(*stores.graph).laneOf(contact);
        for (std::size_t p = 0; p < 2; ++p) {
            if (at.batch.points[p].normalMass[at.lane] == 0) continue;
            const double approach = normalAxis(at.batch, at.lane, p, false).speedOf(bodies.velocity[contact.bodyA]) -
                                    normalAxis(at.batch, at.lane, p, true).speedOf(bodies.velocity[contact.bodyB]);
            if (!(approach > std::max(first.approach, slowestBounce))) continue;
            const double resting = restingSpeed(bodies, contact.bodyA, contact.bodyB, normalAt(at.batch, at.lane));
            const float gap = separationNow(at.batch, p, at.lane, bodies.displacement.data());
            if (bounces(contact.restitution, approach, resting) && static_cast<double>(gap) <= approach * stores.h)
                first = {one.contact, p, approach};
        }
    }
    return first;
}

void JointBounces::bounce(JointStores& stores, JointSolver& joints, const Point& point) {
    BodyStore& bodies = *stores.bodies;
    const ContactRecord& contact = (*stores.contacts)[point.contact];
    const ContactLane at = stores.graph->laneOf(contact);
    const ConstContactLane seen{at.batch, at.manifolds, at.lane};
    const MeetingPoint arms{armTo(bodies, seen, point.number, false), armTo(bodies, seen, point.number, true)};
    const Vec2 normal = normalAt(at.batch, at.lane);
    SolvedBodies both(bodies, joints, contact.bodyA, contact.bodyB);
    const Meeting meeting = solveMeeting({&arms, 1}, normal, {contact.restitution, 0, 0}, 0, both);
    at.batch.points[point.number].totalNormal[at.lane] += static_cast<float>(meeting.normalImpulse);
    at.batch.pushed[at.lane] = -1;
    if (stores.observer == nullptr) return;
    if (!bodies.canMove(contact.bodyA)) stores.observer->noteGround(meeting.onB);
    if (!bodies.canMove(contact.bodyB)) stores.observer->noteGround(-meeting.onB);
    JointRows rows;
    rows.body = {contact.bodyA, contact.bodyB, noBody, noBody};
    rows.add().at = {Vec3{-normal.x(), -normal.y(), -cross(arms.armA, normal)},
                     Vec3{normal.x(), normal.y(), cross(arms.armB, normal)}};
    stores.observer->noteRowImpact(rows, meeting.normalImpulse);
}

}  // namespace plumb
