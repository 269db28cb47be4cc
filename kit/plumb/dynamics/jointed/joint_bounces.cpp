// SPDX-License-Identifier: MIT
#include <plumb/dynamics/jointed/joint_bounces.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include <plumb/dynamics/joints/joint_islands.h>
#include <plumb/dynamics/joints/joint_response.h>
#include <plumb/dynamics/joints/joint_rows.h>
#include <plumb/math/detail/disjoint_sets.h>

namespace plumb {

namespace {

/// Most impacts per contact in a sub-step. A group with more is a pile, and is left to the solver.
constexpr std::size_t impactsPerContact = 16;
/// Most contacts of a group; a larger group is left to the solver, because each impact examines all of its contacts.
constexpr std::size_t mostBounces = 64;

/// A point of a contact, in its present state.
struct Point {
    ContactIndex contact = 0;
    std::size_t number = 0;
    double approach = 0;  ///< [m/s]
};

/// The contact's slot in the solver.
struct Slot {
    const ContactBatch& batch;
    std::size_t lane;

    Slot(const ContactGraph& graph, const ContactRecord& contact)
        : batch(graph.colours[contact.colour].batches[contact.slot / batchLanes]), lane(contact.slot % batchLanes) {}
    Vec2 normal() const { return {static_cast<double>(batch.normalX[lane]), static_cast<double>(batch.normalY[lane])}; }
    /// The separation at the bodies' present positions, computed as in contact_solver.h [m].
    double separation(const BodyStore& bodies, std::size_t point) const {
        const PointLanes& p = batch.points[point];
        const SolverDisplacement& a = bodies.displacement[batch.bodyA[lane]];
        const SolverDisplacement& b = bodies.displacement[batch.bodyB[lane]];
        const float shift = batch.normalX[lane] * (b.x - a.x) + batch.normalY[lane] * (b.y - a.y);
        const float turnA = (p.anchorNormalA[lane] - batch.roundA[lane]) * a.cosMinus1 - p.anchorTangentA[lane] * a.sin;
        const float turnB = (p.anchorNormalB[lane] + batch.roundB[lane]) * b.cosMinus1 - p.anchorTangentB[lane] * b.sin;
        return static_cast<double>(p.startSeparation[lane] + (shift + (turnB - turnA)));
    }
    /// A unit impulse along the normal, as it acts on a body: x, y, turning about its centre of mass.
    Vec3 push(const BodyStore& bodies, BodyIndex body, std::size_t point) const {
        const PointLanes& p = batch.points[point];
        const float anchor = body == batch.bodyA[lane] ? p.anchorTangentA[lane] : p.anchorTangentB[lane];
        const float inverseGyration = bodies.turn[body].inverseGyration;
        return {normal().x(), normal().y(), inverseGyration > 0 ? -static_cast<double>(anchor / inverseGyration) : 0.0};
    }
};

double speedAlong(const BodyStore& bodies, BodyIndex body, const Vec3& push) {
    const SolverVelocity& v = bodies.velocity[body];
    const double spin = static_cast<double>(v.w) * static_cast<double>(bodies.turn[body].inverseGyration);
    return push[0] * static_cast<double>(v.x) + push[1] * static_cast<double>(v.y) + push[2] * spin;
}

class JointBounces {
public:
    JointBounces(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts, double h)
        : islands_(stores.islands),
          bodies_(stores.bodies),
          observer_(stores.observer),
          graph_(graph),
          contacts_(contacts),
          h_(h) {}

    /// The point with the highest approach speed, among those that meet in the sub-step faster than gravity alone makes
    /// resting bodies approach.
    std::optional<Point> fastest(const BounceGroup& bounces) const {
        const double resting = bodies_.gravity.norm() * bodies_.lastStep;
        std::optional<Point> first;
        for (const ContactIndex index : bounces) {
            const ContactRecord& contact = contacts_[index];
            const Slot slot(graph_, contact);
            for (std::size_t p = 0; p < 2; ++p) {
                if (slot.batch.points[p].normalMass[slot.lane] == 0) continue;
                const double approach = approachOf(contact, p);
                if (approach <= resting || slot.separation(bodies_, p) > approach * h_ ||
                    (first && approach <= first->approach))
                    continue;
                first = Point{index, p, approach};
            }
        }
        return first;
    }

    /// Applies a trial impulse, measures the change of the approach speed, and applies the rest of the impulse that is
    /// needed.
    void bounce(const Point& point) {
        const ContactRecord& contact = contacts_[point.contact];
        const Slot slot(graph_, contact);
        const double trial =
            static_cast<double>(slot.batch.points[point.number].normalMass[slot.lane]) * point.approach;
        pushBoth(contact, point.number, trial);
        const double change = point.approach - approachOf(contact, point.number);
        if (!(change > 0)) return;
        const double wanted = (1 + contact.restitution) * point.approach;
        pushBoth(contact, point.number, trial * (wanted / change - 1));
        const double impulse = trial * wanted / change;
        ContactBatch& batch = graph_.colours[contact.colour].batches[contact.slot / batchLanes];
        batch.points[point.number].totalNormal[slot.lane] += static_cast<float>(impulse);
        batch.pushed[slot.lane] = -1;
        if (observer_ != nullptr) observer_->noteRowImpact(partingRow(contact, point.number), impulse);
    }

private:
    double approachOf(const ContactRecord& contact, std::size_t point) const {
        const Slot slot(graph_, contact);
        return speedAlong(bodies_, contact.bodyA, slot.push(bodies_, contact.bodyA, point)) -
               speedAlong(bodies_, contact.bodyB, slot.push(bodies_, contact.bodyB, point));
    }

    void pushBoth(const ContactRecord& contact, std::size_t point, double impulse) {
        const Slot slot(graph_, contact);
        push(contact.bodyA, slot.push(bodies_, contact.bodyA, point), -impulse);
        push(contact.bodyB, slot.push(bodies_, contact.bodyB, point), impulse);
        if (observer_ == nullptr) return;
        if (!bodies_.canMove(contact.bodyA)) observer_->noteGround(slot.normal() * impulse);
        if (!bodies_.canMove(contact.bodyB)) observer_->noteGround(slot.normal() * -impulse);
    }

    void findIslands() {
        islandOf_.assign(bodies_.record.size(), none);
        for (std::uint32_t i = 0; i < islands_.islands.size(); ++i)
            if (!islands_.islands[i].isSwept())
                for (const BodyIndex body : islands_.islands[i].bodies) islandOf_[body] = i;
    }

    /// Applies an impulse to one body, and the joint impulses that follow from it to its island.
    void push(BodyIndex body, const Vec3& along, double impulse) {
        if (!bodies_.canMove(body)) return;
        const Vec3 given{along[0] * impulse, along[1] * impulse, along[2] * impulse};
        if (islandOf_.empty()) findIslands();
        if (islandOf_[body] != none) {
            const JointIsland& island = islands_.islands[islandOf_[body]];
            island.batch->push(bodies_, island.lane, island.nodeOf(body), given);
            return;
        }
        SolverVelocity& v = bodies_.velocity[body];
        const double inverseGyration = static_cast<double>(bodies_.turn[body].inverseGyration);
        const double inverseMass = static_cast<double>(v.inverseMass);
        v.x = static_cast<float>(static_cast<double>(v.x) + inverseMass * given[0]);
        v.y = static_cast<float>(static_cast<double>(v.y) + inverseMass * given[1]);
        v.w = static_cast<float>(static_cast<double>(v.w) + inverseMass * inverseGyration * given[2]);
    }

    /// The rate at which the point separates, as a row.
    JointRows partingRow(const ContactRecord& contact, std::size_t point) const {
        const Slot slot(graph_, contact);
        JointRows rows;
        rows.body = {contact.bodyA, contact.bodyB, noBody, noBody};
        rows.add().at = {times(slot.push(bodies_, contact.bodyA, point), -1), slot.push(bodies_, contact.bodyB, point)};
        return rows;
    }

    JointIslands& islands_;
    BodyStore& bodies_;
    StepObserver* observer_;
    ContactGraph& graph_;
    const ContactStore& contacts_;
    double h_;
    std::vector<std::uint32_t> islandOf_;  ///< of each body, from the first push on; none: in no island, or a swept one
};

/// Which contacts can pass an impact on to each other? Those that meet at a body, or at bodies of one island. Fixed
/// bodies pass nothing on.
class BounceGroups {
public:
    BounceGroups(const BodyStore& bodies, const JointIslands& islands)
        : bodies_(bodies), connected_(bodies.record.size()) {
        for (const JointIsland& island : islands.islands)
            for (const BodyIndex body : island.bodies) connected_.unite(body, island.bodies.front());
    }

    void add(ContactIndex index, const ContactRecord& contact) {
        const bool movesA = bodies_.canMove(contact.bodyA);
        if (movesA && bodies_.canMove(contact.bodyB)) connected_.unite(contact.bodyA, contact.bodyB);
        found_.push_back({movesA ? contact.bodyA : contact.bodyB, index});
    }

    std::vector<BounceGroup> groups() {
        std::map<BodyIndex, BounceGroup> groupOf;
        for (const auto& [body, index] : found_) groupOf[connected_.of(body)].push_back(index);
        std::vector<BounceGroup> groups;
        for (auto& [body, group] : groupOf) {
            std::sort(group.begin(), group.end());
            if (group.size() <= mostBounces) groups.push_back(std::move(group));
        }
        return groups;
    }

private:
    const BodyStore& bodies_;
    DisjointSets connected_;
    std::vector<std::pair<BodyIndex, ContactIndex>> found_;
};

/// The contacts that bounce and have a jointed body.
std::vector<ContactIndex> jointedBounces(const ContactGraph& graph, const ContactStore& contacts,
                                         const BodyStore& bodies) {
    std::vector<ContactIndex> found;
    const auto isJointed = [&](BodyIndex body) { return bodies.links[body].actingJoints > 0; };
    for (const Colour& colour : graph.colours) {
        for (std::size_t i = 0; i < colour.contactOf.size(); ++i) {
            if (!colour.batches[i / batchLanes].bounces) continue;
            const ContactRecord& contact = contacts[colour.contactOf[i]];
            if (contact.restitution > 0 && (isJointed(contact.bodyA) || isJointed(contact.bodyB)))
                found.push_back(colour.contactOf[i]);
        }
    }
    return found;
}

/// Keeps the solver from bouncing the contact.
void take(ContactGraph& graph, const ContactRecord& contact) {
    for (PointLanes& point : graph.colours[contact.colour].batches[contact.slot / batchLanes].points)
        point.bounceSpeed[contact.slot % batchLanes] = 0;
}

}  // namespace

std::vector<BounceGroup> takeJointedBounces(ContactGraph& graph, const ContactStore& contacts, const BodyStore& bodies,
                                            const JointIslands& islands) {
    if (islands.islands.empty()) return {};
    const std::vector<ContactIndex> found = jointedBounces(graph, contacts, bodies);
    if (found.empty()) return {};
    BounceGroups search(bodies, islands);
    for (const ContactIndex index : found) search.add(index, contacts[index]);
    std::vector<BounceGroup> groups = search.groups();
    for (const BounceGroup& group : groups)
        for (const ContactIndex index : group) take(graph, contacts[index]);
    return groups;
}

void bounceJointedBodies(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                         const std::vector<BounceGroup>& groups, double h) {
    JointBounces search(stores, graph, contacts, h);
    for (const BounceGroup& group : groups) {
        for (std::size_t count = 0; count < impactsPerContact * group.size(); ++count) {
            const std::optional<Point> next = search.fastest(group);
            if (!next) break;
            search.bounce(*next);
        }
    }
}

}  // namespace plumb
