// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/slide_probe.h>

#include <algorithm>
#include <cmath>

namespace plumb::detail {

namespace {

/// Solid to what comes within 60 degrees of the open side, as contacts have it.
constexpr double openCosine = 0.5;

double lengthOf(const Vec2& v) {
    return std::sqrt(v.dot(v));
}

CastHit asSeenAfter(const MovingThing& thing, CastHit hit) {
    const Transform forth = thing.back.inverse();
    hit.point = forth * hit.point;
    hit.normal = forth.rotation * hit.normal;
    if (hit.oneWay) hit.oneWay = forth.rotation * *hit.oneWay;
    return hit;
}

}  // namespace

std::optional<Vec2> openSideOf(const CastHit& hit) {
    if (!hit.oneWay) return std::nullopt;
    return Vec2(*hit.oneWay / lengthOf(*hit.oneWay));
}

MovingThing movingThing(const BodyView& body, double dt, const Vec2& up) {
    Vec2 velocity = body.velocity();
    if (body.type() == BodyType::Dynamic) velocity -= up * std::min(0.0, velocity.dot(up));
    const Vec2 center = body.centerOfMass();
    const double turn = body.angularVelocity() * dt;
    const Rot back = turn == 0 ? Rot{} : Rot::fromAngle(-turn);
    return {body.id(), {center - back * Vec2(center + velocity * dt), back}};
}

SlideProbe::SlideProbe(const World& world, BodyId body, const SlideSettings& settings, double dt)
    : world_(world), body_(body), settings_(settings), dt_(dt), rotation_(world.body(body).pose().rotation) {
    for (const ShapeId& id : world.body(body).shapes()) {
        const ShapeDef def = world.shape(id);
        if (!def.sensor) own_.push_back({def.shape, def.filter});
    }
}

void SlideProbe::findMoving(double within, const std::optional<BodyId>& floor) {
    moving_.clear();
    const auto take = [&](BodyId id) {
        if (id == body_ || find(id) != nullptr) return;
        const BodyView view = world_.body(id);
        const bool carries = floor && id == *floor && view.type() == BodyType::Dynamic;
        if (view.type() != BodyType::Kinematic && !carries) return;
        if (view.velocity().isZero(0) && view.angularVelocity() == 0) return;
        moving_.push_back(movingThing(view, dt_, settings_.up));
    };
    if (floor && world_.contains(*floor)) take(*floor);
    const Vec2 position = world_.body(body_).position();
    for (const Own& own : own_)
        for (const ShapeId& near : world_.overlapBox(inflate(aabbOf(own.shape, poseAt(position)), within), own.filter))
            take(near.body);
}

const MovingThing* SlideProbe::find(BodyId body) const {
    const auto found = std::ranges::find(moving_, body, &MovingThing::body);
    return found == moving_.end() ? nullptr : &*found;
}

template <class Visit>
void SlideProbe::meetAll(const Own& own, const Vec2& from, const Vec2& shift, Visit&& visit) const {
    const Transform pose = poseAt(from);
    for (const CastHit& hit : world_.castShapePieces(own.shape, pose, shift, own.filter, body_))
        if (find(hit.shape.body) == nullptr) visit(hit);
    for (const MovingThing& thing : moving_) {
        const Vec2 shiftThere = thing.back.rotation * shift;
        for (const CastHit& hit : world_.castShapePieces(own.shape, thing.back * pose, shiftThere, own.filter, body_))
            if (hit.shape.body == thing.body) visit(asSeenAfter(thing, hit));
    }
}

/// The hit, if it is one that stops; with the way out for a normal where it began inside.
std::optional<CastHit> SlideProbe::stopping(const Own& own, const Transform& pose, const Vec2& shift,
                                            CastHit hit) const {
    if (passed_ && hit.shape.body == *passed_) return std::nullopt;
    if (const std::optional<Vec2> open = openSideOf(hit))
        if (passOneWays_ || !(hit.fraction > 0) || hit.normal.dot(*open) < openCosine) return std::nullopt;
    if (hit.fraction > 0) return hit;
    // Of a chain's pieces that it is in, the one that the way goes into most.
    double into = 0;
    meetAll(own, pose.position, {0, 0}, [&](const CastHit& now) {
        if (now.shape != hit.shape || !(now.normal.dot(shift) < into)) return;
        into = now.normal.dot(shift);
        hit.normal = now.normal;
    });
    if (!(into < -1e-12 * lengthOf(shift))) return std::nullopt;
    return hit;
}

/// How far it is free until a skin short of what a cast of this length met.
double SlideProbe::freeBefore(const CastHit& hit, const Vec2& unit, double length) const {
    const double closing = -hit.normal.dot(unit);
    return closing > 0 ? hit.fraction * length - settings_.skin / closing : 0;
}

FreeWay SlideProbe::freeWay(const Vec2& from, const Vec2& shift, const FreeWayOptions& options) const {
    const double length = lengthOf(shift);
    if (!(length > 0)) return {};
    const Vec2 unit = shift / length;
    const double whole = length + 2 * settings_.skin;
    FreeWay free{length};
    for (const Own& own : own_) {
        meetAll(own, from, unit * whole, [&](const CastHit& met) {
            if (!(freeBefore(met, unit, whole) < free.length)) return;
            const std::optional<CastHit> hit = stopping(own, poseAt(from), shift, met);
            if (!hit || hit->normal.dot(settings_.up) < options.leastRise) return;
            if (freeBefore(*hit, unit, whole) < free.length) free = {freeBefore(*hit, unit, whole), hit};
        });
    }
    free.length = std::max(free.length, -options.backward);
    return free;
}

FreeWay SlideProbe::freeWayAgainst(const MovingThing& thing, const Vec2& from, const Vec2& to) const {
    const Vec2 shift = thing.back * to - from;
    const double length = lengthOf(shift);
    if (!(length > 0)) return {};
    const Vec2 unit = shift / length;
    const double whole = length + 2 * settings_.skin;
    FreeWay free{length};
    for (const Own& own : own_) {
        for (const CastHit& hit : world_.castShapePieces(own.shape, poseAt(from), unit * whole, own.filter, body_)) {
            if (hit.shape.body != thing.body || !(hit.fraction > 0)) continue;  // an overlap is parted by itself
            const double before = freeBefore(hit, unit, whole);
            if (before < free.length && stopping(own, poseAt(from), shift, hit)) free = {before, hit};
        }
    }
    free.length = std::max(free.length, 0.0);
    if (free.hit) free.hit = asSeenAfter(thing, *free.hit);
    return free;
}

/// From a place farther out along the normal, back until it touches.
double SlideProbe::depthOf(const Own& own, const Vec2& at, const CastHit& hit) const {
    const Aabb box = aabbOf(own.shape, poseAt(at));
    double out = 0.125 * lengthOf(box.upper - box.lower);
    for (int i = 0; i < 40; ++i, out *= 2) {
        bool inside = false;
        meetAll(own, at + hit.normal * out, {0, 0}, [&](const CastHit& now) { inside |= now.shape == hit.shape; });
        if (inside) continue;
        double depth = 0;
        meetAll(own, at + hit.normal * out, -hit.normal * out, [&](const CastHit& back) {
            if (back.shape == hit.shape) depth = std::max(depth, out * (1 - back.fraction));
        });
        return depth;
    }
    return 0;
}

std::vector<Overlapped> SlideProbe::overlaps(const Vec2& at) const {
    std::vector<Overlapped> found;
    for (const Own& own : own_) {
        meetAll(own, at, {0, 0}, [&](const CastHit& hit) {
            if (world_.body(hit.shape.body).type() == BodyType::Dynamic || openSideOf(hit)) return;
            found.push_back({hit, depthOf(own, at, hit)});
        });
    }
    return found;
}

FaceSpan SlideProbe::faceSpanAt(const Vec2& at, const Vec2& way, const Vec2& line) const {
    FaceSpan farthest;
    for (const Own& own : own_) {
        const FaceSpan span = faceSpan(own.shape, poseAt(at), way, line);
        if (&own == &own_.front() || span.farthest > farthest.farthest) farthest = span;
    }
    return farthest;
}

bool SlideProbe::isInOneWay(const Vec2& at) const {
    bool inside = false;
    const auto look = [&](const CastHit& hit) { inside |= openSideOf(hit).has_value(); };
    for (const Own& own : own_) meetAll(own, at, settings_.up * (-2 * settings_.skin), look);
    return inside;
}

}  // namespace plumb::detail
