// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/joint_impacts.h>

#include <algorithm>
#include <optional>

#include <plumb/dynamics/detail/joint_answer.h>

namespace plumb {

namespace {

/// More impacts than this for each contact in a sub-step: a heap, for the solver.
constexpr std::size_t impactsPerContact = 16;
/// More contacts than this at once: likewise. Each impact looks at all of them.
constexpr std::size_t mostHanging = 64;

/// A point of a contact, as it stands.
struct Point {
    ContactIndex contact = 0;
    std::size_t number = 0;
    double approach = 0;  ///< [m/s]
};

/// Its slot with the solver.
struct Slot {
    const ContactBatch& batch;
    std::size_t lane;

    Slot(const WorldState& world, const ContactRecord& contact)
        : batch(world.graph.colours[static_cast<std::size_t>(contact.colour)].batches[contact.slot / batchLanes]),
          lane(contact.slot % batchLanes) {}
    Vec2 normal() const { return {static_cast<double>(batch.normalX[lane]), static_cast<double>(batch.normalY[lane])}; }
    /// Where the bodies are now, as contact_solver.h has it [m].
    double separation(const BodyStore& bodies, std::size_t point) const {
        const PointLanes& p = batch.points[point];
        const SolverDisplacement& a = bodies.displacement[batch.bodyA[lane]];
        const SolverDisplacement& b = bodies.displacement[batch.bodyB[lane]];
        const float shift = batch.normalX[lane] * (b.x - a.x) + batch.normalY[lane] * (b.y - a.y);
        const float turnA = (p.anchorNormalA[lane] - batch.roundA[lane]) * a.cosMinus1 - p.anchorTangentA[lane] * a.sin;
        const float turnB = (p.anchorNormalB[lane] + batch.roundB[lane]) * b.cosMinus1 - p.anchorTangentB[lane] * b.sin;
        return static_cast<double>(p.startSeparation[lane] + (shift + (turnB - turnA)));
    }
    /// What a unit impulse along the normal is to a body: x, y, turning about its centre of mass.
    Vec3 push(const BodyStore& bodies, BodyIndex body, std::size_t point) const {
        const PointLanes& p = batch.points[point];
        const float anchor = body == batch.bodyA[lane] ? p.anchorTangentA[lane] : p.anchorTangentB[lane];
        const float rho = bodies.turn[body].rho;
        return {normal().x(), normal().y(), rho > 0 ? -static_cast<double>(anchor / rho) : 0.0};
    }
};

double speedAlong(const BodyStore& bodies, BodyIndex body, const Vec3& push) {
    const SolverVelocity& v = bodies.velocity[body];
    const double spin = static_cast<double>(v.w) * static_cast<double>(bodies.turn[body].rho);
    return push[0] * static_cast<double>(v.x) + push[1] * static_cast<double>(v.y) + push[2] * spin;
}

double approachOf(const WorldState& world, const ContactRecord& contact, std::size_t point) {
    const Slot slot(world, contact);
    return speedAlong(world.bodies, contact.bodyA, slot.push(world.bodies, contact.bodyA, point)) -
           speedAlong(world.bodies, contact.bodyB, slot.push(world.bodies, contact.bodyB, point));
}

/// The one that comes together fastest, of those that meet in the sub-step faster than gravity lets lie.
std::optional<Point> fastest(const WorldState& world, const std::vector<ContactIndex>& contacts, double h) {
    const double resting = world.def.gravity.norm() * world.lastStep;
    std::optional<Point> first;
    for (const ContactIndex index : contacts) {
        const ContactRecord& contact = world.contacts.contacts[index];
        const Slot slot(world, contact);
        for (std::size_t p = 0; p < 2; ++p) {
            if (slot.batch.points[p].normalMass[slot.lane] == 0) continue;
            const double approach = approachOf(world, contact, p);
            if (approach <= resting || slot.separation(world.bodies, p) > approach * h ||
                (first && approach <= first->approach))
                continue;
            first = Point{index, p, approach};
        }
    }
    return first;
}

JointNet* netOf(WorldState& world, BodyIndex body) {
    for (JointNet& net : world.nets)
        if (net.direct && std::find(net.bodies.begin(), net.bodies.end(), body) != net.bodies.end()) return &net;
    return nullptr;
}

/// Gives one body an impulse, and its net what follows from it; returns how the speed along it has changed.
void give(WorldState& world, BodyIndex body, const Vec3& push, double impulse, double h) {
    if (!world.bodies.canMove(body)) return;
    const Vec3 given{push[0] * impulse, push[1] * impulse, push[2] * impulse};
    if (JointNet* net = netOf(world, body)) {
        pushNet(*net, world.joints, world.bodies, body, given, h);
        return;
    }
    SolverVelocity& v = world.bodies.velocity[body];
    const double rho = static_cast<double>(world.bodies.turn[body].rho);
    const double inverseMass = static_cast<double>(v.inverseMass);
    v.x = static_cast<float>(static_cast<double>(v.x) + inverseMass * given[0]);
    v.y = static_cast<float>(static_cast<double>(v.y) + inverseMass * given[1]);
    v.w = static_cast<float>(static_cast<double>(v.w) + inverseMass * rho * given[2]);
}

void giveBoth(WorldState& world, const ContactRecord& contact, std::size_t point, double impulse, double h) {
    const Slot slot(world, contact);
    give(world, contact.bodyA, slot.push(world.bodies, contact.bodyA, point), -impulse, h);
    give(world, contact.bodyB, slot.push(world.bodies, contact.bodyB, point), impulse, h);
}

/// How fast the point parts, as a row.
JointRows partingRow(const WorldState& world, const ContactRecord& contact, std::size_t point) {
    const Slot slot(world, contact);
    JointRows rows;
    rows.body = {contact.bodyA, contact.bodyB, noBody, noBody};
    rows.add().at = {times(slot.push(world.bodies, contact.bodyA, point), -1),
                     slot.push(world.bodies, contact.bodyB, point)};
    return rows;
}

/// Tries how much a small impulse does, and gives what is then known to be needed.
void bounce(WorldState& world, const Point& point, double h) {
    const ContactRecord& contact = world.contacts.contacts[point.contact];
    const Slot slot(world, contact);
    const double trial = static_cast<double>(slot.batch.points[point.number].normalMass[slot.lane]) * point.approach;
    giveBoth(world, contact, point.number, trial, h);
    const double change = point.approach - approachOf(world, contact, point.number);
    if (!(change > 0)) return;
    const double wanted = (1 + contact.restitution) * point.approach;
    giveBoth(world, contact, point.number, trial * (wanted / change - 1), h);
    const double impulse = trial * wanted / change;
    Colour& colour = world.graph.colours[static_cast<std::size_t>(contact.colour)];
    ContactBatch& batch = colour.batches[contact.slot / batchLanes];
    batch.points[point.number].totalNormal[slot.lane] += static_cast<float>(impulse);
    batch.pushed[slot.lane] = -1;
    if (world.audit) world.audit->noteImpact(partingRow(world, contact, point.number), impulse);
}

}  // namespace

std::vector<ContactIndex> takeHangingBounces(WorldState& world) {
    std::vector<ContactIndex> found;
    if (world.nets.empty()) return found;
    for (Colour& colour : world.graph.colours) {
        for (std::size_t b = 0; b < colour.batches.size(); ++b) {
            if (!colour.batches[b].bounces) continue;
            const std::size_t count = std::min<std::size_t>(batchLanes, colour.contactOf.size() - b * batchLanes);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const ContactIndex index = colour.contactOf[b * batchLanes + lane];
                const ContactRecord& contact = world.contacts.contacts[index];
                const auto hangs = [&](BodyIndex body) { return world.bodies.record[body].actingJoints > 0; };
                if (contact.restitution <= 0 || !(hangs(contact.bodyA) || hangs(contact.bodyB))) continue;
                found.push_back(index);
            }
        }
    }
    if (found.size() > mostHanging) return {};
    for (const ContactIndex index : found) {
        const ContactRecord& contact = world.contacts.contacts[index];
        Colour& colour = world.graph.colours[static_cast<std::size_t>(contact.colour)];
        for (PointLanes& point : colour.batches[contact.slot / batchLanes].points)
            point.bounceSpeed[contact.slot % batchLanes] = 0;
    }
    std::sort(found.begin(), found.end());
    return found;
}

void bounceHanging(WorldState& world, const std::vector<ContactIndex>& contacts, double h) {
    for (std::size_t count = 0; count < impactsPerContact * contacts.size(); ++count) {
        const std::optional<Point> next = fastest(world, contacts, h);
        if (!next) return;
        bounce(world, *next, h);
    }
}

}  // namespace plumb
