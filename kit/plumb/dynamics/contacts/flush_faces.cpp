// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/flush_faces.h>

#include <algorithm>
#include <cmath>

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
    Vec2 shift{0, 0};                ///< to the image of the owner that the other shape touches [m]
    Vec2 point{0, 0}, normal{0, 0};  ///< outward; in the frame of the owner, from its centre of mass
    double separation = 0;
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
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2 vertex = convex.vertices[i].cast<double>();
            if (!isNear(vertex)) continue;
            const Vec2 face = convex.normals[i].cast<double>(),
                       before = convex.normals[(i + count - 1) % count].cast<double>();
            if (isCoveredAt(vertex, face, before) || isCoveredAt(vertex, before, face)) return true;
        }
        return false;
    }

private:
    /// The point may be anywhere between the surfaces, along the normal.
    bool isNear(const Vec2& vertex) const {
        const Vec2 away = corner_.point - vertex;
        return std::fabs(cross(away, corner_.normal)) <= step_ &&
               std::fabs(away.dot(corner_.normal)) <= std::fabs(corner_.separation) + step_;
    }

    /// Is one face covered, and the normal not that of the other, open one?
    bool isCoveredAt(const Vec2& vertex, const Vec2& face, const Vec2& open) const {
        if (corner_.normal.dot(open) > sameNormal) return false;
        const BodyMotion& owner = bodies_.motion[corner_.owner];
        const Vec2 local = vertex + face * step_ - open * (2 * step_);
        const Vec2 point = owner.center + corner_.shift + owner.rotation * local;
        bool covered = false;
        // What lies flush beside a loose body touches it; what lies beside a fixed one is near the body that slides.
        const bool loose = bodies_.isDynamic(corner_.owner);
        const BodyIndex from = loose ? corner_.owner : corner_.slider;
        forEachContact(bodies_, contacts_, from, [&](ContactIndex index) {
            const ContactRecord& contact = contacts_[index];
            const bool isA = contact.bodyA == from;
            const BodyIndex body = isA ? contact.bodyB : contact.bodyA;
            const ProxyId other = isA ? contact.proxyB : contact.proxyA;
            if (covered || body == corner_.slider || other == corner_.proxy || letsPass(contact.verdict)) return;
            const BodyMotion& cover = bodies_.motion[body];
            const Vec2 shift = (isA ? contact.shift : Vec2(-contact.shift)) + (loose ? corner_.shift : Vec2(0, 0));
            covered = isInside(space_[other].convex, cover.rotation.inverse() * Vec2(point - cover.center - shift));
        });
        return covered;
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

int floorSides(const BodyStore& bodies, BodyIndex a, BodyIndex b, double dt) {
    const auto step = static_cast<float>(dt);
    return (mayBeFloor(bodies, a, b, step) ? floorA : 0) | (mayBeFloor(bodies, b, a, step) ? floorB : 0);
}

bool isAtCoveredFace(const ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex index,
                     const Manifold& manifold, int sides) {
    const ContactRecord& contact = contacts[index];
    const Vec2 point = manifold.points[0].position.cast<double>(), normal = manifold.normal.cast<double>();
    const double separation = static_cast<double>(manifold.points[0].separation);
    const Vec2 shift = contact.shift;
    const Corner onA{contact.bodyA, contact.bodyB, contact.proxyA, -shift, point, normal, separation};
    if ((sides & floorA) != 0 && Search(contacts, bodies, space, onA).isCovered()) return true;
    if ((sides & floorB) == 0) return false;
    const BodyMotion &a = bodies.motion[contact.bodyA], &b = bodies.motion[contact.bodyB];
    const Rot toB = b.rotation.inverse();
    const Vec2 inB = toB * Vec2(a.center + a.rotation * point - b.center - shift);
    const Corner onB{contact.bodyB, contact.bodyA, contact.proxyB, shift, inB, -(toB * (a.rotation * normal)),
                     separation};
    return Search(contacts, bodies, space, onB).isCovered();
}

}  // namespace plumb
