// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/bounds.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/dynamics/bodies/load_bodies.h>
#include <plumb/space/detail/shape_radii.h>

namespace plumb {

namespace {

/// New bounds are larger than this step needs by this margin, so that a slow body keeps its bounds for many steps [m].
/// A larger one finds more pairs that do not touch, a smaller one places bounds more often.
constexpr double boundsMargin = 0.01;
/// Rounding error of an extent, as a share of it [-]: about four times 2^-23, the spacing of floats, for a few products
/// and sums. Bounds must contain their shapes, or a pair is lost.
constexpr float roundings = 5e-7f;

/// Bounds relative to a body's centre [m].
struct Extent {
    Vec2f lower, upper;
};

/// A rotated box reaches |c| hx + |s| hy along x, hx and hy its half sizes. Floats are exact enough around the body's
/// centre, wherever the body is.
Extent boxExtent(const BoxOutline& box, float c, float s) {
    const Vec2f center(c * box.centerX - s * box.centerY, s * box.centerX + c * box.centerY);
    const float absC = std::fabs(c), absS = std::fabs(s);
    const Vec2f half(absC * box.halfX + absS * box.halfY + box.radius,
                     absS * box.halfX + absC * box.halfY + box.radius);
    return {center - half, center + half};
}

/// Takes in up to four corners.
void addCorners(const CornerRows& corners, float c, float s, Extent& extent) {
    using Four = Eigen::Array4f;
    const Four x = Eigen::Map<const Four>(corners.x), y = Eigen::Map<const Four>(corners.y);
    const Four turnedX = c * x - s * y, turnedY = s * x + c * y;
    extent.lower = extent.lower.cwiseMin(Vec2f(turnedX.minCoeff(), turnedY.minCoeff()));
    extent.upper = extent.upper.cwiseMax(Vec2f(turnedX.maxCoeff(), turnedY.maxCoeff()));
}

Extent polygonExtent(const ContactStore& contacts, ProxyId proxy, float c, float s) {
    const BoxOutline& box = contacts.boxes[proxy];
    constexpr float infinite = std::numeric_limits<float>::infinity();
    Extent extent{Vec2f(infinite, infinite), Vec2f(-infinite, -infinite)};
    addCorners(contacts.corners[proxy], c, s, extent);
    if (box.corners > 4) addCorners(contacts.moreCorners[proxy], c, s, extent);
    return {extent.lower - Vec2f(box.radius, box.radius), extent.upper + Vec2f(box.radius, box.radius)};
}

/// Boxes, discs, and polygons of up to eight corners are read from the outlines of the contacts, which lie side by
/// side; others, in double, from their shapes.
Extent extentOf(const Space& space, const BodyStore& bodies, const ContactStore& contacts, BodyIndex body,
                ProxyId proxy) {
    const BoxOutline& box = contacts.boxes[proxy];
    const BodyMotion& motion = bodies.motion[body];
    const auto c = static_cast<float>(motion.rotation.cos), s = static_cast<float>(motion.rotation.sin);
    if (box.kind != BoxOutline::Kind::Other) return boxExtent(box, c, s);
    if (box.corners > 0) return polygonExtent(contacts, proxy, c, s);
    const Aabb tight = aabbOf(space[proxy].def.shape, bodies.pose(body));
    return {Vec2(tight.lower - motion.center).cast<float>(), Vec2(tight.upper - motion.center).cast<float>()};
}

/// How far a rotation can move a sensor's points: a body's turningRadius does not include its sensors [m].
float sensorTurn(const Shape& shape, const BodyRecord& record, const BodyMotion& motion, double dt) {
    const double turn = std::min(std::fabs(motion.angularVelocity) * dt, 2.0);
    return static_cast<float>(turningRadiusOf(shape, record.localCenter) * turn);
}

}  // namespace

/// Free flight to the step's end, from loadBody. A bounding box that went around the world would pair the body with
/// everything.
Vec2 predictedShift(const BodyStore& bodies, BodyIndex body) {
    const BodyPlace& place = bodies.place[body];
    const Vec2 shift(static_cast<double>(place.shiftX), static_cast<double>(place.shiftY));
    return bodies.wrap.isExceededBy(shift) ? Vec2(0, 0) : shift;
}

double excessOfPrediction(const BodyStore& bodies, BodyIndex body, const Vec2& moved, double turned) {
    // The prediction's box reaches from 0 to predicted: outside of it counts.
    const auto excess = [](double actual, double predicted) {
        return std::max(std::min(predicted, 0.0) - actual, actual - std::max(predicted, 0.0));
    };
    const Vec2 predicted = predictedShift(bodies, body);
    const double aside = std::max({excess(moved.x(), predicted.x()), excess(moved.y(), predicted.y()), 0.0});
    return aside + std::max(turned - static_cast<double>(bodies.place[body].turn), 0.0);
}

/// The bounds contain the shape now, and where it is at the end of the step if nothing touches it, and where it may be
/// if it bounces back in any direction, with at most its restitution times its speed.
void placeBounds(Space& space, const BodyStore& bodies, const ContactStore& contacts, BodyIndex body, double dt) {
    const BodyRecord& record = bodies.record[body];
    const BodyMotion& motion = bodies.motion[body];
    const bool moves = record.awake && dt > 0;
    const Vec2f shift = moves ? Vec2f(predictedShift(bodies, body).cast<float>()) : Vec2f(0, 0);
    const float turn = moves ? bodies.place[body].turn : 0.0f;
    const float path = std::sqrt(shift.x() * shift.x() + shift.y() * shift.y());
    for (const ProxyId proxy : bodies.links[body].proxies) {
        const BoxOutline& outline = contacts.boxes[proxy];
        const Extent now = extentOf(space, bodies, contacts, body, proxy);
        const bool sensor = outline.sensor && moves;
        const float swing = sensor ? sensorTurn(space[proxy].def.shape, record, motion, dt) : turn;
        // Half of the contact margin is here, half in the bounds of the other shape: so all pairs within the margin are
        // found.
        const float back = outline.restitution * path, spare = 0.5f * contactMargin + swing;
        const Vec2f below(spare + std::max(back, -shift.x()), spare + std::max(back, -shift.y()));
        const Vec2f above(spare + std::max(back, shift.x()), spare + std::max(back, shift.y()));
        const Vec2f lower = now.lower - below - now.lower.cwiseAbs() * roundings;
        const Vec2f upper = now.upper + above + now.upper.cwiseAbs() * roundings;
        space.place(proxy, {motion.center + lower.cast<double>(), motion.center + upper.cast<double>()}, boundsMargin);
    }
}

/// The step's load phase, O(awake bodies). A wall that stands still keeps its bounds, and is not visited.
void loadBodies(BodyStore& bodies, Space& space, const ContactStore& contacts, double dt) {
    bodies.someSpin = false;
    for (const BodyIndex body : bodies.awake) {
        loadBody(bodies, body, dt);
        bodies.someSpin = bodies.someSpin || std::fabs(bodies.motion[body].angularVelocity) * dt > spinningTurn;
        if (bodies.record[body].quarantined) continue;
        placeBounds(space, bodies, contacts, body, dt);
        // What woke after the last step's load has bounds again that fit its motion.
        bodies.step[body].boundsPending = false;
    }
}

bool hasLeftItsBounds(const Space& space, const BodyStore& bodies, BodyIndex body) {
    const Transform pose = bodies.pose(body);
    const std::vector<ProxyId>& proxies = bodies.links[body].proxies;
    return std::any_of(proxies.begin(), proxies.end(), [&](ProxyId proxy) {
        return !contains(space.box(proxy), aabbOf(space[proxy].def.shape, pose));
    });
}

namespace {

void addStale(const Space& space, const BodyStore& bodies, BodyIndex body, std::vector<StaleBound>& bounds) {
    const Transform pose = bodies.pose(body);
    for (const ProxyId proxy : bodies.links[body].proxies) {
        const Aabb box = aabbOf(space[proxy].def.shape, pose);
        if (!contains(space.box(proxy), box)) bounds.push_back({proxy, box});
    }
}

/// Waits until no other thread holds the flag, then holds it. Queries from several threads may be the first after a
/// step; one computes the list, the others spin for that long.
class HeldFlag {
public:
    explicit HeldFlag(std::atomic_flag& flag) : flag_(flag) {
        while (flag_.test_and_set(std::memory_order_acquire)) {
        }
    }
    ~HeldFlag() { flag_.clear(std::memory_order_release); }
    HeldFlag(const HeldFlag&) = delete;
    HeldFlag& operator=(const HeldFlag&) = delete;

private:
    std::atomic_flag& flag_;
};

/// A cheap test that reads three cache lines: is the body so near to its predicted place that its shapes are surely
/// within their bounds? False means that this is not known. The bounds contain all places between the step's start and
/// the prediction, and half a contactMargin more on every side.
bool isSurelyWithin(const BodyStore& bodies, BodyIndex body) {
    if (bodies.step[body].boundsPending) return false;
    const BodyMotion& now = bodies.motion[body];
    const BodyPlace& then = bodies.place[body];
    const Vec2 moved(now.center.x() - static_cast<double>(then.highX) - static_cast<double>(then.lowX),
                     now.center.y() - static_cast<double>(then.highY) - static_cast<double>(then.lowY));
    // The rotation is measured by its chord: the displacement of a point 1 m from the centre.
    const double cos = now.rotation.cos - static_cast<double>(then.cos);
    const double sin = now.rotation.sin - static_cast<double>(then.sin);
    const double turned = std::sqrt(cos * cos + sin * sin) * bodies.record[body].turningRadius;
    const double spare = 0.5 * static_cast<double>(contactMargin);
    return excessOfPrediction(bodies, body, moved, turned) < 0.99 * spare;
}

}  // namespace

/// O(awake bodies) at the first query after a step, with an exact box for the few that pushes have moved out of their
/// bounds. A world that is never asked pays nothing.
std::span<const StaleBound> StaleBounds::of(const Space& space, const BodyStore& bodies) const {
    if (known_) return bounds_;
    const HeldFlag held(busy_);
    if (known_) return bounds_;
    bounds_.clear();
    for (const BodyIndex body : bodies.awake)
        if (!isSurelyWithin(bodies, body)) addStale(space, bodies, body, bounds_);
    known_ = true;
    return bounds_;
}

}  // namespace plumb
