// SPDX-License-Identifier: MIT
#include <plumb/dynamics/contacts/bounds.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/dynamics/bodies/load_bodies.h>
#include <plumb/dynamics/bodies/shape_radii.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>

namespace plumb {

namespace {

/// New bounds are larger than this step needs by this margin, so that a slow body keeps its bounds for many steps [m].
constexpr double boundsMargin = 0.01;

/// The bounds of up to four corners around a body's centre.
void addCorners(const CornerRows& corners, const BodyMotion& motion, Vec2f& lower, Vec2f& upper) {
    using Four = Eigen::Array4f;
    const auto c = static_cast<float>(motion.rotation.cos), s = static_cast<float>(motion.rotation.sin);
    const Four x = Eigen::Map<const Four>(corners.x), y = Eigen::Map<const Four>(corners.y);
    const Four turnedX = c * x - s * y, turnedY = s * x + c * y;
    lower = lower.cwiseMin(Vec2f(turnedX.minCoeff(), turnedY.minCoeff()));
    upper = upper.cwiseMax(Vec2f(turnedX.maxCoeff(), turnedY.maxCoeff()));
}

/// In floats from the body's centre: the bounds have a margin far above their rounding.
Aabb polygonBox(const ContactStore& contacts, ProxyId proxy, const BodyMotion& motion) {
    const BoxOutline& box = contacts.boxes[proxy];
    constexpr float infinite = std::numeric_limits<float>::infinity();
    Vec2f lower(infinite, infinite), upper(-infinite, -infinite);
    addCorners(contacts.corners[proxy], motion, lower, upper);
    if (box.corners > 4) addCorners(contacts.moreCorners[proxy], motion, lower, upper);
    return inflate({motion.center + lower.cast<double>(), motion.center + upper.cast<double>()},
                   static_cast<double>(box.radius));
}

Aabb tightBox(const Space& space, const ContactStore& contacts, ProxyId proxy, const BodyMotion& motion,
              const Transform& pose) {
    const BoxOutline& box = contacts.boxes[proxy];
    if (box.kind == BoxOutline::Kind::Other && box.corners > 0) return polygonBox(contacts, proxy, motion);
    if (box.kind == BoxOutline::Kind::Other) return aabbOf(space[proxy].def.shape, pose);
    const double c = motion.rotation.cos;
    const double s = motion.rotation.sin;
    const double x = static_cast<double>(box.centerX), y = static_cast<double>(box.centerY);
    const double hx = static_cast<double>(box.halfX), hy = static_cast<double>(box.halfY);
    const Vec2 center(motion.center.x() + (c * x - s * y), motion.center.y() + (s * x + c * y));
    const Vec2 half(std::fabs(c) * hx + std::fabs(s) * hy, std::fabs(s) * hx + std::fabs(c) * hy);
    return inflate({center - half, center + half}, static_cast<double>(box.radius));
}

/// How far a rotation can move a sensor's points: a body's turningRadius does not include its sensors [m].
double sensorTurn(const Shape& shape, const BodyRecord& record, const BodyMotion& motion, double dt) {
    return turningRadiusOf(shape, record.localCenter) * std::min(std::fabs(motion.angularVelocity) * dt, 2.0);
}

}  // namespace

Vec2 predictedShift(const BodyStore& bodies, BodyIndex body) {
    const BodyPlace& place = bodies.place[body];
    const Vec2 shift(static_cast<double>(place.shiftX), static_cast<double>(place.shiftY));
    return bodies.wrap.isExceededBy(shift) ? Vec2(0, 0) : shift;
}

double excessOfPrediction(const BodyStore& bodies, BodyIndex body, const Vec2& moved, double turned) {
    const auto excess = [](double actual, double predicted) {
        return std::max(std::min(predicted, 0.0) - actual, actual - std::max(predicted, 0.0));
    };
    const Vec2 predicted = predictedShift(bodies, body);
    const double aside = std::max({excess(moved.x(), predicted.x()), excess(moved.y(), predicted.y()), 0.0});
    return aside + std::max(turned - static_cast<double>(bodies.place[body].turn), 0.0);
}

void placeBounds(Space& space, const BodyStore& bodies, const ContactStore& contacts, BodyIndex body, double dt) {
    const BodyRecord& record = bodies.record[body];
    const BodyMotion& motion = bodies.motion[body];
    const BodyPlace& place = bodies.place[body];
    const bool moves = record.awake && dt > 0;
    const Vec2 shift = moves ? predictedShift(bodies, body) : Vec2(0, 0);
    const double turn = moves ? static_cast<double>(place.turn) : 0.0;
    const Transform pose = bodies.pose(body);
    for (const ProxyId proxy : bodies.links[body].proxies) {
        const BoxOutline& outline = contacts.boxes[proxy];
        const double swing = outline.sensor && moves ? sensorTurn(space[proxy].def.shape, record, motion, dt) : turn;
        const Aabb now =
            inflate(tightBox(space, contacts, proxy, motion, pose), 0.5 * static_cast<double>(contactMargin) + swing);
        const Aabb ahead{now.lower + shift, now.upper + shift};
        // It may bounce back in any direction, with at most its restitution times its speed.
        const Aabb back = inflate(now, static_cast<double>(outline.restitution) * shift.norm());
        space.place(proxy, merge(ahead, back), boundsMargin);
    }
}

void loadBodies(BodyStore& bodies, Space& space, const ContactStore& contacts, double dt) {
    bodies.someSpin = false;
    for (const BodyIndex body : bodies.awake) {
        loadBody(bodies, body, dt);
        bodies.someSpin = bodies.someSpin || std::fabs(bodies.motion[body].angularVelocity) * dt > spinningTurn;
        if (bodies.record[body].quarantined) continue;
        placeBounds(space, bodies, contacts, body, dt);
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

}  // namespace plumb
