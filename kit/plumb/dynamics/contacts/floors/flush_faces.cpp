// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/floors/flush_faces.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <plumb/dynamics/contacts/predicted_manifold.h>
#include <plumb/math/vec2.h>

namespace plumb {

namespace {

/// Corners, steps and gaps up to this size count as none [m], and up to this share of the smaller inradius [-].
constexpr double mostStep = 2e-3, stepShare = 0.05;
/// A normal counts as that of a face if the cosine of the angle between them is more than this: 0.26 degrees.
constexpr double sameNormal = 0.99999;

/// Loose bodies of which a point is faster make no floor [m/s].
constexpr float atRest = 0.1f;

/// A contact as seen from one of its shapes.
struct Corner {
    BodyIndex owner = noBody, slider = noBody;  ///< the bodies of this and of the other shape
    ProxyId proxy = 0;
    Vec2 shift{0, 0};                 ///< to the image of the owner that the other shape touches [m]
    Vec2f point{0, 0}, normal{0, 0};  ///< outward; in the frame of the owner, from its centre of mass
    float separation = 0;
};

bool isInside(const Convex& convex, const Vec2& point) {
    if (convex.count < 3) return false;
    for (int k = 0; k < convex.count; ++k) {
        const auto i = static_cast<std::size_t>(k);
        const Vec2 normal = convex.normals[i].cast<double>(), vertex = convex.vertices[i].cast<double>();
        if (normal.dot(point - vertex) > static_cast<double>(convex.radius)) return false;
    }
    return true;
}

/// Reads only what colliding has just read: this is asked of every contact at a corner.
bool mayBeFloor(const BodyStore& bodies, BodyIndex body, BodyIndex slider, float dt) {
    if (bodies.velocity[slider].inverseMass == 0) return false;
    const BodyPlace& place = bodies.place[body];
    const float far = atRest * dt;
    return bodies.velocity[body].inverseMass == 0 ||
           (place.shiftX * place.shiftX + place.shiftY * place.shiftY <= far * far && place.turn <= far);
}

class Search {
public:
    Search(const ContactStore& contacts, const BodyStore& bodies, const Space& space, const Corner& corner)
        : contacts_(contacts), bodies_(bodies), space_(space), corner_(corner) {
        const double inradius = std::min(bodies.record[corner.owner].inradius, bodies.record[corner.slider].inradius);
        step_ = std::min(mostStep, stepShare * inradius);
    }

    bool isCovered() const {
        const Convex& convex = space_[corner_.proxy].convex;
        if (convex.count < 3 || convex.radius > 0) return false;
        const auto count = static_cast<std::size_t>(convex.count);
        for (std::size_t i = 0; i < count; ++i)
            if (isNear(convex.vertices.x()[i], convex.vertices.y()[i]) && isCoveredAt(convex, i)) return true;
        return false;
    }

private:
    /// The point may be anywhere between the surfaces, along the normal.
    bool isNear(float x, float y) const {
        const float awayX = corner_.point.x() - x, awayY = corner_.point.y() - y;
        const auto step = static_cast<float>(step_);
        return std::fabs(awayX * corner_.normal.y() - awayY * corner_.normal.x()) <= step &&
               std::fabs(awayX * corner_.normal.x() + awayY * corner_.normal.y()) <=
                   std::fabs(corner_.separation) + step;
    }

    /// Is one of the faces at a corner covered, and the normal not that of the other, open one?
    bool isCoveredAt(const Convex& convex, std::size_t corner) const {
        const auto count = static_cast<std::size_t>(convex.count);
        const Vec2 vertex = convex.vertices[corner].cast<double>(), normal = corner_.normal.cast<double>();
        const Vec2 after = convex.normals[corner].cast<double>(),
                   before = convex.normals[(corner + count - 1) % count].cast<double>();
        Vec2 points[2];
        std::size_t asked = 0;
        for (const auto& [covered, open] : {std::pair(after, before), std::pair(before, after)})
            if (normal.dot(open) <= sameNormal) points[asked++] = vertex + covered * step_ - open * (2 * step_);
        return isAnyInside({points, asked});
    }

    /// Is a point just outside of a face, and a little below the other one, inside of another shape?
    bool isAnyInside(std::span<const Vec2> points) const {
        if (points.empty()) return false;
        const BodyMotion& owner = bodies_.motion[corner_.owner];
        const Vec2 origin = owner.center + corner_.shift;
        // What lies flush beside a loose body touches it; what lies beside a fixed one is near the body that slides.
        const bool loose = bodies_.isDynamic(corner_.owner);
        const BodyIndex from = loose ? corner_.owner : corner_.slider;
        return anyContact(bodies_, contacts_, from, [&](ContactIndex index) {
            const ContactRecord& contact = contacts_[index];
            const bool isA = contact.bodyA == from;
            const BodyIndex body = isA ? contact.bodyB : contact.bodyA;
            const ProxyId other = isA ? contact.proxyB : contact.proxyA;
            if (body == corner_.slider || other == corner_.proxy || letsPass(contact.verdict)) return false;
            const BodyMotion& cover = bodies_.motion[body];
            const Vec2 shift = (isA ? contact.shift : Vec2(-contact.shift)) + (loose ? corner_.shift : Vec2(0, 0));
            const Rot toCover = cover.rotation.inverse();
            return std::any_of(points.begin(), points.end(), [&](const Vec2& point) {
                const Vec2 fromCenter = origin + owner.rotation * point - cover.center - shift;
                return isInside(space_[other].convex, toCover * fromCenter);
            });
        });
    }

    const ContactStore& contacts_;
    const BodyStore& bodies_;
    const Space& space_;
    const Corner& corner_;
    double step_ = 0;
};

}  // namespace

bool isAtCorner(const FreshLanes& fresh, std::size_t lane) {
    const float x = fresh.points[1].x[lane] - fresh.points[0].x[lane];
    const float y = fresh.points[1].y[lane] - fresh.points[0].y[lane];
    const bool same = x * x + y * y <= static_cast<float>(mostStep * mostStep);
    return (fresh.count[lane] == 1) | ((fresh.count[lane] == 2) & same);
}

bool someAtCorner(const FreshLanes& fresh, std::size_t count) {
    bool some = false;
    for (std::size_t lane = 0; lane < count; ++lane) some |= isAtCorner(fresh, lane);
    return some;
}

int floorSides(const BodyStore& bodies, BodyIndex a, BodyIndex b, double dt) {
    const auto step = static_cast<float>(dt);
    return (mayBeFloor(bodies, a, b, step) ? floorA : 0) | (mayBeFloor(bodies, b, a, step) ? floorB : 0);
}

bool isAtCoveredFace(const ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex index,
                     const Manifold& manifold, int sides) {
    const ContactRecord& contact = contacts[index];
    const ManifoldPoint& point = manifold.points[0];
    const Vec2 shift = contact.shift;
    const Corner onA{contact.bodyA,  contact.bodyB,   contact.proxyA,  -shift,
                     point.position, manifold.normal, point.separation};
    if ((sides & floorA) != 0 && Search(contacts, bodies, space, onA).isCovered()) return true;
    if ((sides & floorB) == 0) return false;
    const BodyMotion b = shifted(bodies.motion[contact.bodyB], shift);
    const RelativePose pose = relativePose(b, bodies.motion[contact.bodyA]);
    const auto turned = [&pose](const Vec2f& v) {
        return Vec2f(pose.cos * v.x() - pose.sin * v.y(), pose.sin * v.x() + pose.cos * v.y());
    };
    const Corner onB{contact.bodyB,
                     contact.bodyA,
                     contact.proxyB,
                     shift,
                     turned(point.position) + pose.position,
                     -turned(manifold.normal),
                     point.separation};
    return Search(contacts, bodies, space, onB).isCovered();
}

}  // namespace plumb
