// SPDX-License-Identifier: MIT
#include <plumb/dynamics/meetings/wall_impact.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/contacts/pairs.h>
#include <plumb/impact/impact.h>

namespace plumb {

namespace {

/// Most times that each point of a face is solved [-]. What still approaches after that is met again when the body
/// moves on.
constexpr int mostTurns = 4;
/// A slower approach is none any more [m/s].
constexpr double stopped = 1e-6;

/// Impulses at one point of the wall.
/// An impact at one point of the wall. The wall's own motion is not changed: it is static or kinematic.
class WallPoint {
public:
    WallPoint(const BodyMotion& wall, PushedBody& body, const Vec2& point, const Vec2& normal)
        : wall_(wall), body_(body), point_(point), normal_(normal), arm_(point - body.motion().center) {}

    Vec2 velocity() const { return velocityAt(body_.motion(), point_); }
    double approach() const { return Vec2(velocityAt(wall_, point_) - velocity()).dot(normal_); }

    /// Adds its impulses to the impact, and their work by the mean of the speeds before and after. False if nothing
    /// approaches or can be moved. The response of the body is that of its whole machine, so the law of impacts needs
    /// only three numbers: how a unit impulse along each axis changes the speed along it, and how along the other one.
    bool solve(const ImpactLaw& law, WallImpact& impact) {
        const double approach = this->approach();
        const Vec2 t = perp(normal_);
        if (!(approach > stopped)) return false;
        const Vec2 byNormal = changeBy(normal_), byTangent = changeBy(t);
        const ImpactResponse response{byNormal.dot(normal_), byNormal.dot(t), byTangent.dot(t)};
        if (!(response.normal > 0)) return false;
        const Vec2 atWall = velocityAt(wall_, point_), before = velocity();
        const double slip = (before - atWall).dot(t) + law.surfaceSpeed;
        const ImpactImpulses given = impactImpulses(response, approach, slip, law);
        const Vec2 impulse = normal_ * given.normal + t * given.tangent;
        if (!impulse.allFinite()) return false;
        body_.push(at(impulse));
        const Vec2 mean = 0.5 * (before + velocity()) - atWall;
        impact.approachSpeed = std::max(impact.approachSpeed, approach);
        impact.normalImpulse += given.normal;
        impact.tangentImpulse += given.tangent;
        impact.bounce += given.normal * mean.dot(normal_);
        impact.friction += given.tangent * (mean.dot(t) + law.surfaceSpeed);
        impact.drivers += impulse.dot(atWall) - given.tangent * law.surfaceSpeed;
        impact.impulse += impulse;
        return true;
    }

private:
    Vec3 at(const Vec2& impulse) const { return {impulse.x(), impulse.y(), cross(arm_, impulse)}; }
    /// By how much a unit impulse at the point changes the point's velocity.
    Vec2 changeBy(const Vec2& unit) const {
        const Vec3 change = body_.responseTo(at(unit));
        return Vec2(change[0], change[1]) + perp(arm_) * change[2];
    }

    const BodyMotion& wall_;
    PushedBody& body_;
    Vec2 point_, normal_, arm_;
};

/// The law of a pair of shapes, whether they have a contact or not. A rebound that is no faster than what gravity makes
/// of rest in half a step is none: else what lies on a wall would hop.
ImpactLaw lawOf(const WallView& view, const WallHit& hit, double approach) {
    ContactRecord contact;
    contact.proxyA = std::min(hit.own, hit.wall);
    contact.proxyB = std::max(hit.own, hit.wall);
    mixMaterials(view.space, contact);
    const double resting = 0.5 * view.bodies.gravity.norm() * view.bodies.lastStep;
    const double restitution = contact.restitution * approach > resting ? contact.restitution : 0;
    return {restitution, contact.friction, static_cast<double>(contact.surfaceSpeed)};
}

}  // namespace

/// Both points of a face are solved in turn, with one law for both, found from the faster one: else a box that lands
/// flat might bounce with one corner only. The manifold belongs to the shape with the lower number, which may be the
/// wall.
WallImpact solveWallImpact(const WallView& view, const WallHit& hit, double duration, PushedBody& body) {
    const BodyMotion wall = motionAt(hit.wallSweep, hit.time, duration), own = body.motion();
    const bool bodyFirst = hit.own < hit.wall;
    const BodyMotion& a = bodyFirst ? own : wall;
    WallImpact impact;
    impact.hit = hit;
    const Vec2 fromA = a.rotation * Vec2(hit.manifold.normal.cast<double>());
    impact.normal = (bodyFirst ? Vec2(-fromA) : fromA).normalized();
    std::vector<WallPoint> points;
    double approach = 0;
    for (int p = 0; p < hit.manifold.count; ++p) {
        const Vec2 local = hit.manifold.points[static_cast<std::size_t>(p)].position.cast<double>();
        const Vec2 at = a.center + a.rotation * local;
        if (p == 0) impact.point = at;
        points.emplace_back(wall, body, at, impact.normal);
        approach = std::max(approach, points.back().approach());
    }
    const ImpactLaw law = lawOf(view, hit, approach);
    for (int turn = 0; turn < mostTurns; ++turn) {
        bool pushed = false;
        for (WallPoint& point : points) pushed = point.solve(law, impact) || pushed;
        if (!pushed) break;
    }
    return impact;
}

namespace {

/// A body that was deflected may meet a wall for which it has no contact: then one is made.
ContactIndex contactOf(const WallTouchStores& stores, const ShiftedShapes& pair) {
    const ContactIndex found = findContact(stores.contacts, stores.bodies, stores.space, pair);
    if (found != none) return found;
    return addEarlyContact(stores.contacts, stores.bodies, stores.space, pair);
}

/// A contact in the solver reports its events itself, from its impulses and its approach speed; so the impact only adds
/// to these.
void addToSolved(ContactGraph& graph, const ContactRecord& contact, const WallImpact& impact) {
    Colour& colour = graph.colours[contact.colour];
    const std::size_t b = contact.slot / batchLanes, lane = contact.slot % batchLanes;
    PointLanes& point = colour.batches[b].points[0];
    point.totalNormal[lane] += static_cast<float>(impact.normalImpulse);
    point.totalTangent[lane] += static_cast<float>(impact.tangentImpulse);
    float& approach = colour.manifolds[b].approachSpeed[lane];
    approach = std::max(approach, static_cast<float>(impact.approachSpeed));
}

/// Makes a near contact one of an isolated impact, with this step's impulses only. Several impacts in a step add up.
void addToOther(ContactStore& contacts, ContactIndex index, const WallImpact& impact, double dt) {
    ContactRecord& contact = contacts[index];
    if (contact.state != ContactState::Impact) {
        contact.state = ContactState::Impact;
        contact.memory = {};
        contact.rollImpulse = 0;
        contacts.impacts.push_back(index);
    }
    contact.manifold = impact.hit.manifold;
    contact.memory[0].totalNormal += static_cast<float>(impact.normalImpulse);
    contact.memory[0].totalTangent += static_cast<float>(impact.tangentImpulse);
    contact.memoryStep = dt;
    contacts.watch(index);
}

}  // namespace

void reportWallImpact(const WallTouchStores& stores, const WallImpact& impact, double dt, double hitSpeed,
                      TouchEvents& touches) {
    if (stores.observer != nullptr)
        stores.observer->noteImpact(impact.friction, impact.drivers, impact.bounce, impact.impulse);
    const ShiftedShapes pair = inOrder(impact.hit.own, impact.hit.wall, impact.hit.shift);
    const ContactIndex index = contactOf(stores, pair);
    ContactRecord& contact = stores.contacts[index];
    if (contact.isSolved()) return addToSolved(stores.graph, contact, impact);
    if (!contact.isNear()) return;
    addToOther(stores.contacts, index, impact, dt);
    const Vec2 normal = pair.shapes.a == impact.hit.wall ? impact.normal : Vec2(-impact.normal);
    const ShapeTouch touch{pair.shapes.a, pair.shapes.b, pair.shift, impact.point, normal, impact.approachSpeed};
    if (!contact.touching) touches.begins.push_back(touch);
    if (impact.approachSpeed > hitSpeed) touches.hits.push_back(touch);
    contact.touching = true;
}

}  // namespace plumb
