// SPDX-License-Identifier: MIT
#include <compare/engine/textbook/frame_loop.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <compare/scene/shape_pair.h>
#include <plumb/collide/bisection.h>
#include <plumb/collide/distance.h>
#include <plumb/impact/impact.h>

namespace plumb::compare {
namespace {

constexpr int mostImpacts = 32;  // in a frame

[[noreturn]] void lacks(const std::string& what) {
    throw Unsupported("a loop of a textbook has no " + what);
}

void requireSimple(const Scene& scene) {
    if (!scene.movers.empty()) lacks("movers");
    if (scene.wrap.any()) lacks("edges where the world goes on at the other side");
    for (const SceneBody& body : scene.bodies) {
        if (!isAlwaysThere(body)) lacks("bodies that come later: " + body.name);
        if (body.def.lockX || body.def.lockY) lacks("locks: " + body.name);
        for (const ShapeDef& shape : body.def.shapes) {
            if (std::holds_alternative<TileMap>(shape.shape)) lacks("tile maps: " + body.name);
            if (shape.oneWay) lacks("one-way shapes: " + body.name);
        }
    }
}

/// To another place at the frame's end.
void shift(auto& body, const Vec2& by) {
    body.center += by;
    body.way.shift += by;
}

bool collides(const ShapeDef& a, const ShapeDef& b) {
    return !a.sensor && !b.sensor && accepts(a.filter, b.filter);
}

}  // namespace

Transform FrameLoop::Body::pose() const {
    const Rot turned = Rot::fromAngle(angle);
    return {center - turned * mass.center, turned};
}

double FrameLoop::Body::shareOfWay(double fraction) const {
    return from < 1 ? std::clamp((fraction - from) / (1 - from), 0.0, 1.0) : 1;
}

Transform FrameLoop::Body::poseAt(double fraction) const {
    return plumb::poseAt(way, shareOfWay(fraction));
}

FrameLoop::FrameLoop(const Scene& scene, Integration integration, CollisionTest test)
    : scene_(scene), integration_(integration), test_(test), fields_(scene) {
    requireSimple(scene);
    for (const SceneBody& each : scene.bodies) {
        const BodyDef& def = each.def;
        const bool isMoved = def.type == BodyType::Dynamic && def.enabled;
        Body body;
        body.def = def;
        body.angle = def.angle;
        body.angularVelocity = def.angularVelocity;
        if (isMoved) body.mass = massOf(def);
        if (isMoved) body.inverseMass = 1 / body.mass.mass;
        if (isMoved && !def.fixedRotation && body.mass.inertia > 0) body.inverseInertia = 1 / body.mass.inertia;
        body.center = def.position + Rot::fromAngle(def.angle) * body.mass.center;
        body.velocity = def.velocity;
        if (isMoved) moving_.push_back(bodies_.size());
        bodies_.push_back(std::move(body));
    }
    for (const JointGeometry& joint : jointGeometries(scene)) {
        const auto* rod = std::get_if<DistanceJointDef>(&joint.def);
        if (!rod || !rod->spring) lacks("joints but springs");
        SpringBetween spring{joint.bodyA,        joint.bodyB,   joint.localAnchorA,
                             joint.localAnchorB, *joint.length, *rod->spring};
        for (const auto& [body, anchor] : {std::pair{spring.a, spring.anchorA}, std::pair{spring.b, spring.anchorB}})
            if (bodies_[body].inverseMass > 0 && (anchor - bodies_[body].mass.center).norm() > 1e-9)
                lacks("springs beside the middle of a body: " + scene.bodies[body].name);
        springs_.push_back(spring);
    }
}

Eigen::VectorXd FrameLoop::accelerations(const Eigen::VectorXd& position, const Eigen::VectorXd& velocity,
                                         double dt) const {
    std::vector<Vec2> force(bodies_.size(), Vec2(0, 0));
    const auto at = [](const Eigen::VectorXd& all, std::size_t i) -> Vec2 {
        return all.segment<2>(2 * static_cast<Eigen::Index>(i));
    };
    std::vector<BodyState> now = states();
    std::vector<Vec2> centers(bodies_.size()), speeds(bodies_.size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        centers[i] = bodies_[i].center;
        speeds[i] = bodies_[i].velocity;
    }
    for (std::size_t i = 0; i < moving_.size(); ++i) {
        const std::size_t body = moving_[i];
        centers[body] = at(position, i);
        speeds[body] = at(velocity, i);
        now[body].position += centers[body] - bodies_[body].center;
        now[body].velocity = speeds[body];
    }
    if (!fields_.empty()) {
        const std::vector<FieldForce> pushes = fields_.at(now, dt);
        for (std::size_t i = 0; i < bodies_.size(); ++i) force[i] += pushes[i].force;
    }
    for (const SpringBetween& each : springs_) {
        const auto end = [&](std::size_t body, const Vec2& anchor) {
            return bodies_[body].inverseMass > 0 ? centers[body] : bodies_[body].pose() * anchor;
        };
        const Vec2 a = end(each.a, each.anchorA), b = end(each.b, each.anchorB);
        const Vec2 along = (b - a).normalized();
        const double pull = each.spring.stiffness * ((b - a).norm() - each.length) +
                            each.spring.damping * along.dot(speeds[each.b] - speeds[each.a]);
        force[each.a] += pull * along;
        force[each.b] -= pull * along;
    }
    Eigen::VectorXd result(position.size());
    for (std::size_t i = 0; i < moving_.size(); ++i) {
        const Body& body = bodies_[moving_[i]];
        const Vec2 a = body.def.gravityScale * scene_.gravity + body.inverseMass * force[moving_[i]] -
                       body.def.linearDamping * at(velocity, i);
        result.segment<2>(2 * static_cast<Eigen::Index>(i)) = Eigen::Vector2d(a);
    }
    return result;
}

/// All bodies, as if nothing were in their way.
void FrameLoop::move(double dt) {
    const auto size = 2 * static_cast<Eigen::Index>(moving_.size());
    plumb::Phase<Eigen::VectorXd> all{Eigen::VectorXd(size), Eigen::VectorXd(size)};
    for (std::size_t i = 0; i < moving_.size(); ++i) {
        const auto at = 2 * static_cast<Eigen::Index>(i);
        all.position.segment<2>(at) = Eigen::Vector2d(bodies_[moving_[i]].center);
        all.velocity.segment<2>(at) = Eigen::Vector2d(bodies_[moving_[i]].velocity);
    }
    const auto acceleration = [&](const Eigen::VectorXd& x, const Eigen::VectorXd& v) {
        return accelerations(x, v, dt);
    };
    if (size > 0) all = integrated<Eigen::VectorXd>(integration_, acceleration, all, dt);
    for (Body& body : bodies_) {
        body.from = 0;
        body.way = {body.center, dt * body.velocity, body.angle, dt * body.angularVelocity, body.mass.center};
    }
    for (std::size_t i = 0; i < moving_.size(); ++i) {
        const auto at = 2 * static_cast<Eigen::Index>(i);
        Body& body = bodies_[moving_[i]];
        body.way.shift = Vec2(all.position.segment<2>(at)) - body.center;
        body.gain = Vec2(all.velocity.segment<2>(at)) - body.velocity;
        body.velocity += body.gain;
        body.angularVelocity *= std::exp(-body.def.angularDamping * dt);
    }
    for (Body& body : bodies_) {
        body.center += body.way.shift;
        body.angle += body.way.turn;
    }
}

bool FrameLoop::mayMeet(std::size_t a, std::size_t b) const {
    if (bodies_[a].inverseMass == 0 && bodies_[b].inverseMass == 0) return false;
    return std::ranges::none_of(springs_, [&](const SpringBetween& spring) {
        return (spring.a == a && spring.b == b) || (spring.a == b && spring.b == a);
    });
}

template <class Act>
void FrameLoop::forEachPair(const Act& act) {
    for (std::size_t a = 0; a < bodies_.size(); ++a)
        for (std::size_t b = a + 1; b < bodies_.size(); ++b)
            if (mayMeet(a, b)) act(a, b);
}

/// Each shape of one with each of the other that it may touch.
template <class Act>
void FrameLoop::forEachShapes(std::size_t a, std::size_t b, const Act& act) const {
    const std::vector<ShapeDef>&ofA = bodies_[a].def.shapes, &ofB = bodies_[b].def.shapes;
    for (std::size_t i = 0; i < ofA.size(); ++i)
        for (std::size_t k = 0; k < ofB.size(); ++k)
            if (collides(ofA[i], ofB[k])) act(i, k, ofA[i].shape, ofB[k].shape);
}

/// What overlaps at the frame's end is moved apart, and the law of impact applies there.
void FrameLoop::separate(std::size_t a, std::size_t b) {
    Body &first = bodies_[a], &second = bodies_[b];
    forEachShapes(a, b, [&](std::size_t i, std::size_t k, const Shape& shapeA, const Shape& shapeB) {
        const auto found = overlap(shapeA, first.pose(), shapeB, second.pose());
        if (!found) return;
        const Vec2 out = found->depth / (first.inverseMass + second.inverseMass) * found->normal;
        shift(first, -first.inverseMass * out);
        shift(second, second.inverseMass * out);
        resolve({a, b, i, k, 1, (found->pointA + found->pointB) / 2, found->normal});
    });
}

/// The lecture's time of collision by five probes: both go back to it, and on from there with their new velocities.
void FrameLoop::bisect(std::size_t a, std::size_t b, double dt) {
    Body &first = bodies_[a], &second = bodies_[b];
    forEachShapes(a, b, [&](std::size_t i, std::size_t k, const Shape& shapeA, const Shape& shapeB) {
        const auto isOverlapping = [&](double fraction) {
            return overlap(shapeA, first.poseAt(fraction), shapeB, second.poseAt(fraction)).has_value();
        };
        const auto time = bisectCollision(isOverlapping);
        if (!time) return;
        const Distance gap = distance(shapeA, first.poseAt(time->apart), shapeB, second.poseAt(time->apart));
        const Meeting meeting{a, b, i, k, time->apart, (gap.pointA + gap.pointB) / 2, gap.normal};
        if (!approach(meeting)) return;
        resolve(meeting);
        for (const std::size_t body : {a, b}) goOn(body, time->apart, dt);
    });
}

/// From this share of the frame on the body moves straight, with the mean of its velocity then and at the end.
void FrameLoop::goOn(std::size_t index, double fraction, double dt) {
    Body& body = bodies_[index];
    const Transform there = body.poseAt(fraction);
    const double left = (1 - fraction) * dt, angle = body.way.angle + body.shareOfWay(fraction) * body.way.turn;
    const Vec2 mean = (body.velocityAt(fraction) + body.velocity) / 2;
    body.way = {there * body.mass.center, left * mean, angle, left * body.angularVelocity, body.mass.center};
    body.from = fraction;
    body.center = body.way.start + body.way.shift;
    body.angle = body.way.angle + body.way.turn;
}

std::vector<FrameLoop::Meeting> FrameLoop::touches(std::size_t a, std::size_t b) const {
    const Body &first = bodies_[a], &second = bodies_[b];
    const double from = std::max(first.from, second.from);
    const auto rest = [&](const Body& body) { return partOf(body.way, body.shareOfWay(from), 1); };
    std::vector<Meeting> found;
    forEachShapes(a, b, [&](std::size_t i, std::size_t k, const Shape& shapeA, const Shape& shapeB) {
        const auto touch = firstTouch(shapeA, rest(first), shapeB, rest(second));
        if (touch) found.push_back({a, b, i, k, from + (1 - from) * touch->time, touch->point, touch->normal});
    });
    return found;
}

bool FrameLoop::approach(const Meeting& meeting) const {
    const Body &a = bodies_[meeting.a], &b = bodies_[meeting.b];
    const auto at = [&](const Body& body) -> Vec2 {
        const Vec2 arm = meeting.point - body.poseAt(meeting.time) * body.mass.center;
        return body.velocityAt(meeting.time) + body.angularVelocity * Vec2(-arm.y(), arm.x());
    };
    return (at(b) - at(a)).dot(meeting.normal) < 0;
}

/// To the impact, through it, and on for the rest of the frame; the earliest impact first.
void FrameLoop::sweep(double dt) {
    for (int impacts = 0; impacts < mostImpacts; ++impacts) {
        std::optional<Meeting> next;
        forEachPair([&](std::size_t a, std::size_t b) {
            for (const Meeting& meeting : touches(a, b))
                if ((!next || meeting.time < next->time) && approach(meeting)) next = meeting;
        });
        if (!next) return;
        resolve(*next);
        for (const std::size_t body : {next->a, next->b}) goOn(body, next->time, dt);
    }
}

void FrameLoop::resolve(const Meeting& meeting) {
    firstImpact_ = std::min(meeting.time, firstImpact_.value_or(1));
    Body &a = bodies_[meeting.a], &b = bodies_[meeting.b];
    const Material &ofA = a.def.shapes[meeting.shapeA].material, &ofB = b.def.shapes[meeting.shapeB].material;
    const ImpactLaw law{
        .restitution = mixed(ruleOf(ofA.restitutionMix, ofB.restitutionMix), ofA.restitution, ofB.restitution),
        .friction = mixed(ruleOf(ofA.frictionMix, ofB.frictionMix), ofA.friction, ofB.friction)};
    const auto side = [&](const Body& body) {
        const Vec2 arm = meeting.point - body.poseAt(meeting.time) * body.mass.center;
        return ImpactSide{body.velocityAt(meeting.time), body.angularVelocity, body.inverseMass, body.inverseInertia,
                          arm};
    };
    const ImpactResult after = impact(side(a), side(b), meeting.normal, law);
    a.velocity = after.velocityA + (1 - meeting.time) * a.gain;
    b.velocity = after.velocityB + (1 - meeting.time) * b.gain;
    a.angularVelocity = after.angularVelocityA;
    b.angularVelocity = after.angularVelocityB;
}

void FrameLoop::advance(double dt) {
    firstImpact_.reset();
    move(dt);
    if (test_ == CollisionTest::AtEnd) forEachPair([&](std::size_t a, std::size_t b) { separate(a, b); });
    if (test_ == CollisionTest::Bisection) forEachPair([&](std::size_t a, std::size_t b) { bisect(a, b, dt); });
    if (test_ == CollisionTest::Swept) sweep(dt);
}

std::vector<BodyState> FrameLoop::states() const {
    std::vector<BodyState> result;
    for (const Body& body : bodies_)
        result.push_back({body.pose().position, body.angle, body.velocity, body.angularVelocity});
    return result;
}

}  // namespace plumb::compare
