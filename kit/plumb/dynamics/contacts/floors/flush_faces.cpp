// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/floors/flush_faces.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/dynamics/contacts/predicted_manifold.h>
#include <plumb/math/vec2.h>

namespace plumb {

namespace {

/// Corners, steps and gaps up to this size count as none [m], and up to this share of the smaller inradius [-]. A floor
/// laid by hand is not quite flush. What is higher is a step: a box of 0.8 m at 3 m/s slides over 3 mm, and is stopped
/// by 5 mm. Test: "a box slides over a step of 1.9 mm in a floor of boxes, and is stopped by one of 5 mm"
constexpr double mostStep = 2e-3, stepShare = 0.05;
/// What slides over a floor is no deeper in it than this [m]: so far a load, a great gravity or a long step may press a
/// body in. Test: "nothing stops on boxes laid flush, at any gravity and step, and under a load"
constexpr double mostDepth = 0.05;
/// A normal counts as that of a face if the cosine of the angle between them is more than this [-]: 0.26 degrees. It
/// must be small: a normal between two faces is that of a corner, and a flush floor has none.
constexpr double sameNormal = 0.99999;

/// Loose bodies of which a point is faster, by more than their acceleration gives in half a step, make no floor [m/s]:
/// two crates that fly side by side are two bodies, and a wall that topples must stop what it hits.
constexpr float atRest = 0.1f;

/// A contact as seen from one of its shapes.
struct Corner {
    BodyIndex owner = noBody, slider = noBody;  ///< the bodies of this and of the other shape
    ProxyId proxy = 0;
    Vec2 shift{0, 0};    ///< to the image of the owner that the other shape touches [m]
    Vec2f normal{0, 0};  ///< outward; in the frame of the owner
    Vec2f center{0, 0};  ///< there, of the slider, from the owner's centre of mass
    Vec2f points[2];     ///< there, from its centre of mass
    float separations[2];
    int count = 0;
};

/// What counts as no distance there [m].
double stepOf(const BodyStore& bodies, const Corner& corner) {
    const double inradius = std::min(bodies.record[corner.owner].inradius, bodies.record[corner.slider].inradius);
    return std::min(mostStep, stepShare * inradius);
}

/// A line has no inside, and covers nothing.
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
    if (bodies.velocity[body].inverseMass == 0) return true;
    const BodyPlace& place = bodies.place[body];
    const float x = place.shiftX - place.pullX * dt, y = place.shiftY - place.pullY * dt;
    const float far = (atRest + std::fabs(place.pullX) + std::fabs(place.pullY)) * dt;
    return x * x + y * y <= far * far && place.turn <= far;
}

bool isPlainPolygon(const Convex& convex) {
    return convex.count >= 3 && convex.radius == 0;
}

/// Is a point of the contact at a corner? It may be anywhere between the surfaces, along the normal.
bool isAt(const Convex& convex, std::size_t corner, const Corner& at, float near) {
    for (int p = 0; p < at.count; ++p) {
        const Vec2f from = at.points[p] - convex.vertices[corner];
        const float aside = std::fabs(cross(from, at.normal)), along = std::fabs(from.dot(at.normal));
        if (aside <= near && along <= std::fabs(at.separations[p]) + near) return true;
    }
    return false;
}

bool isAlong(const Vec2f& normal, const Vec2f& face) {
    return normal.cast<double>().dot(face.cast<double>()) > sameNormal;
}

/// Calls f(face, other face) for the two faces at a corner, in both orders.
template <class F>
void forFacesAt(const Convex& convex, std::size_t corner, const F& f) {
    const std::size_t before = (corner == 0 ? static_cast<std::size_t>(convex.count) : corner) - 1;
    f(corner, before);
    f(before, corner);
}

/// Is the contact on a face at a corner, perhaps far from it, while the slider is above the other face?
bool isBelow(const Convex& convex, std::size_t corner, const Corner& at) {
    bool below = false;
    forFacesAt(convex, corner, [&](std::size_t face, std::size_t other) {
        below = below || (isAlong(at.normal, convex.normals[face]) &&
                          (at.center - convex.vertices[corner]).dot(convex.normals[other]) > 0);
    });
    return below;
}

/// Calls f(corner's index) for the corners of the owner's shape that the contact may belong to, as long as f returns
/// false.
template <class F>
bool anyCornerNear(const Convex& convex, const Corner& at, double step, const F& f) {
    if (!isPlainPolygon(convex)) return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(convex.count); ++i)
        if ((isAt(convex, i, at, static_cast<float>(step)) || isBelow(convex, i, at)) && f(i)) return true;
    return false;
}

/// Calls f(face, other face) for each face at a corner of which the other one has not the contact's normal.
template <class F>
void forCoveredAt(const Convex& convex, std::size_t corner, const Vec2f& normal, const F& f) {
    forFacesAt(convex, corner, [&](std::size_t covered, std::size_t open) {
        if (!isAlong(normal, convex.normals[open])) f(covered, open);
    });
}

/// The question for one contact, seen from one of its shapes: O(corners of the shape x contacts of a body). It is asked
/// only of contacts at corners of which the watch knows nothing better.
class Search {
public:
    Search(const ContactStore& contacts, const BodyStore& bodies, const Space& space, const Corner& corner)
        : contacts_(contacts), bodies_(bodies), space_(space), corner_(corner), step_(stepOf(bodies, corner)) {}

    bool isCovered() const {
        const Convex& convex = space_[corner_.proxy].convex;
        return anyCornerNear(convex, corner_, step_, [&](std::size_t i) { return isCoveredAt(convex, i); });
    }

private:
    /// Is one of the faces at a corner covered as far as the contact reaches down on it, and the normal not that of the
    /// other, open one?
    bool isCoveredAt(const Convex& convex, std::size_t corner) const {
        const Vec2 vertex = convex.vertices[corner].cast<double>();
        bool isCovered = false;
        forCoveredAt(convex, corner, corner_.normal, [&](std::size_t covered, std::size_t open) {
            const Vec2 out = convex.normals[covered].cast<double>(), up = convex.normals[open].cast<double>();
            // A little outside of the covered face, and a little below the open one: there a shape that is flush
            // reaches, and one that stands away by a step or more does not.
            const Vec2 near = vertex + out * step_ - up * (2 * step_);
            isCovered = isCovered || (isInAnother(near) && isInAnother(near - up * depthBelow(vertex, up)));
        });
        return isCovered;
    }

    /// How much farther than a step down from a corner does the contact reach?
    double depthBelow(const Vec2& vertex, const Vec2& up) const {
        double depth = 0;
        for (int p = 0; p < corner_.count; ++p)
            depth = std::max(depth, up.dot(vertex - corner_.points[p].cast<double>()) - step_);
        return depth;
    }

    /// Is a point inside of another shape?
    bool isInAnother(const Vec2& point) const {
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
            return isInside(space_[other].convex, toCover * (origin + owner.rotation * point - cover.center - shift));
        });
    }

    const ContactStore& contacts_;
    const BodyStore& bodies_;
    const Space& space_;
    const Corner& corner_;
    double step_;
};

RelativePose poseOf(const BodyStore& bodies, const ContactRecord& contact) {
    return relativePose(bodies.motion[contact.bodyA], shifted(bodies.motion[contact.bodyB], contact.shift));
}

Corner seenFromA(const BodyStore& bodies, const ContactRecord& contact, const Manifold& manifold) {
    const auto& [first, second] = manifold.points;
    return {contact.bodyA,
            contact.bodyB,
            contact.proxyA,
            -contact.shift,
            manifold.normal,
            poseOf(bodies, contact).position,
            {first.position, second.position},
            {first.separation, second.separation},
            manifold.count};
}

/// The manifold is in A's frame; B's corners are in B's, so points and normal are turned into it.
Corner seenFromB(const BodyStore& bodies, const ContactRecord& contact, const Manifold& manifold) {
    const auto& [first, second] = manifold.points;
    const RelativePose pose = poseOf(bodies, contact);
    const auto turned = [&pose](const Vec2f& v) {
        return Vec2f(pose.cos * v.x() + pose.sin * v.y(), pose.cos * v.y() - pose.sin * v.x());
    };
    return {contact.bodyB,
            contact.bodyA,
            contact.proxyB,
            contact.shift,
            -turned(manifold.normal),
            -turned(pose.position),
            {turned(first.position - pose.position), turned(second.position - pose.position)},
            {first.separation, second.separation},
            manifold.count};
}

/// normal: of the contact, from A to B, in the frame of the corner's owner.
void findFaces(const BodyStore& bodies, const Space& space, const Corner& corner, const Vec2f& normal,
               std::uint8_t (&faces)[2]) {
    const Convex& convex = space[corner.proxy].convex;
    anyCornerNear(convex, corner, stepOf(bodies, corner), [&](std::size_t i) {
        std::size_t found = 0;
        forCoveredAt(convex, i, corner.normal, [&](std::size_t covered, std::size_t) {
            faces[found++] = faceFrom(normal, convex.normals[covered]);
        });
        return found > 0;
    });
}

}  // namespace

bool isAtCorner(const FreshLanes& fresh, std::size_t lane) {
    const float x = fresh.points[1].x[lane] - fresh.points[0].x[lane];
    const float y = fresh.points[1].y[lane] - fresh.points[0].y[lane];
    const bool same = x * x + y * y <= static_cast<float>(mostDepth * mostDepth);
    const bool single = (fresh.count[lane] == 1) & (fresh.inset[lane] <= static_cast<float>(mostStep));
    const bool predicted = fresh.uncertain[lane] != 0;  // as if nothing held the bodies: deeper than it will be
    return single | ((fresh.count[lane] == 2) & (same | predicted));
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
    findFaces(bodies, space, seenFromA(bodies, contact, manifold), manifold.normal, faces.ofA);
    // What has no sharp corners there needs no look from its side.
    if (!isPlainPolygon(space[contact.proxyB].convex)) return faces;
    const Corner onB = seenFromB(bodies, contact, manifold);
    findFaces(bodies, space, onB, -onB.normal, faces.ofB);
    return faces;
}

bool isAtCoveredFace(const ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex index,
                     const Manifold& manifold, int sides) {
    const ContactRecord& contact = contacts[index];
    const auto covered = [&](const Corner& corner) { return Search(contacts, bodies, space, corner).isCovered(); };
    return ((sides & floorA) != 0 && covered(seenFromA(bodies, contact, manifold))) ||
           ((sides & floorB) != 0 && covered(seenFromB(bodies, contact, manifold)));
}

}  // namespace plumb
