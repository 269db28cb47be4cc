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

/// What counts as no distance there [m].
double stepOf(const BodyStore& bodies, const Corner& corner) {
    const double inradius = std::min(bodies.record[corner.owner].inradius, bodies.record[corner.slider].inradius);
    return std::min(mostStep, stepShare * inradius);
}

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

bool isPlainPolygon(const Convex& convex) {
    return convex.count >= 3 && convex.radius == 0;
}

/// Calls f(corner's index) for the corners of the owner's shape where the contact is, as long as f returns false. The
/// point may be anywhere between the surfaces, along the normal.
template <class F>
bool anyCornerNear(const Convex& convex, const Corner& at, double step, const F& f) {
    if (!isPlainPolygon(convex)) return false;
    const auto near = static_cast<float>(step);
    for (std::size_t i = 0; i < static_cast<std::size_t>(convex.count); ++i) {
        const float x = at.point.x() - convex.vertices.x()[i], y = at.point.y() - convex.vertices.y()[i];
        const float aside = std::fabs(x * at.normal.y() - y * at.normal.x()),
                    along = std::fabs(x * at.normal.x() + y * at.normal.y());
        if (aside <= near && along <= std::fabs(at.separation) + near && f(i)) return true;
    }
    return false;
}

/// Calls f(face, other face) for each face at a corner of which the other one has not the contact's normal.
template <class F>
void forFacesAt(const Convex& convex, std::size_t corner, const Vec2f& normal, const F& f) {
    const std::size_t before = (corner == 0 ? static_cast<std::size_t>(convex.count) : corner) - 1;
    for (const auto& [covered, open] : {std::pair(corner, before), std::pair(before, corner)})
        if (Vec2(normal.template cast<double>()).dot(Vec2(convex.normals[open].template cast<double>())) <= sameNormal)
            f(covered, open);
}

class Search {
public:
    Search(const ContactStore& contacts, const BodyStore& bodies, const Space& space, const Corner& corner)
        : contacts_(contacts), bodies_(bodies), space_(space), corner_(corner), step_(stepOf(bodies, corner)) {}

    bool isCovered() const {
        const Convex& convex = space_[corner_.proxy].convex;
        return anyCornerNear(convex, corner_, step_, [&](std::size_t i) { return isCoveredAt(convex, i); });
    }

private:
    /// Is one of the faces at a corner covered, and the normal not that of the other, open one?
    bool isCoveredAt(const Convex& convex, std::size_t corner) const {
        const Vec2 vertex = convex.vertices[corner].cast<double>();
        Vec2 points[2];
        std::size_t asked = 0;
        forFacesAt(convex, corner, corner_.normal, [&](std::size_t covered, std::size_t open) {
            const Vec2 out = convex.normals[covered].cast<double>(), up = convex.normals[open].cast<double>();
            points[asked++] = vertex + out * step_ - up * (2 * step_);
        });
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
    double step_;
};

Corner seenFromA(const ContactRecord& contact, const Manifold& manifold) {
    const ManifoldPoint& point = manifold.points[0];
    return {contact.bodyA,  contact.bodyB,   contact.proxyA,  -contact.shift,
            point.position, manifold.normal, point.separation};
}

Corner seenFromB(const BodyStore& bodies, const ContactRecord& contact, const Manifold& manifold) {
    const ManifoldPoint& point = manifold.points[0];
    const BodyMotion b = shifted(bodies.motion[contact.bodyB], contact.shift);
    const RelativePose pose = relativePose(b, bodies.motion[contact.bodyA]);
    const auto turned = [&pose](const Vec2f& v) {
        return Vec2f(pose.cos * v.x() - pose.sin * v.y(), pose.sin * v.x() + pose.cos * v.y());
    };
    return {contact.bodyB,
            contact.bodyA,
            contact.proxyB,
            contact.shift,
            turned(point.position) + pose.position,
            -turned(manifold.normal),
            point.separation};
}

/// normal: of the contact, from A to B, in the frame of the corner's owner.
void findFaces(const BodyStore& bodies, const Space& space, const Corner& corner, const Vec2f& normal,
               std::uint8_t (&faces)[2]) {
    const Convex& convex = space[corner.proxy].convex;
    anyCornerNear(convex, corner, stepOf(bodies, corner), [&](std::size_t i) {
        std::size_t found = 0;
        forFacesAt(convex, i, corner.normal, [&](std::size_t covered, std::size_t) {
            faces[found++] = faceFrom(normal, convex.normals[covered]);
        });
        return found > 0;
    });
}

}  // namespace

bool isAtCorner(const FreshLanes& fresh, std::size_t lane) {
    const float x = fresh.points[1].x[lane] - fresh.points[0].x[lane];
    const float y = fresh.points[1].y[lane] - fresh.points[0].y[lane];
    const bool same = x * x + y * y <= static_cast<float>(mostStep * mostStep);
    const bool single = (fresh.count[lane] == 1) & (fresh.inset[lane] <= static_cast<float>(mostStep));
    return single | ((fresh.count[lane] == 2) & same);
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

CornerFaces facesAt(const ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex index,
                    const Manifold& manifold) {
    const ContactRecord& contact = contacts[index];
    CornerFaces faces = noFaces;
    findFaces(bodies, space, seenFromA(contact, manifold), manifold.normal, faces.ofA);
    if (!isPlainPolygon(space[contact.proxyB].convex)) return faces;
    const Corner onB = seenFromB(bodies, contact, manifold);
    findFaces(bodies, space, onB, -onB.normal, faces.ofB);
    return faces;
}

bool isAtCoveredFace(const ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex index,
                     const Manifold& manifold, int sides) {
    const ContactRecord& contact = contacts[index];
    const auto covered = [&](const Corner& corner) { return Search(contacts, bodies, space, corner).isCovered(); };
    return ((sides & floorA) != 0 && covered(seenFromA(contact, manifold))) ||
           ((sides & floorB) != 0 && covered(seenFromB(bodies, contact, manifold)));
}

}  // namespace plumb
