// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/slide_probe.h>

#include <algorithm>
#include <cmath>

namespace plumb::detail {

namespace {

/// Solid to what comes within 60 degrees of the open side, as contacts have it.
constexpr double openCosine = 0.5;

/// A way into a wall by less than this is along it: where a face ends, the normal of a round shape is known to the
/// square root of some roundings over its size only [-].
constexpr double parallel = 1e-6;

double lengthOf(const Vec2& v) {
    return std::sqrt(v.dot(v));
}

OneWayFloor floorOf(const CastHit& hit) {
    return {hit.shape, hit.tile};
}

CastHit asSeenAfter(const MovingThing& thing, CastHit hit) {
    const Transform forth = thing.back.inverse();
    hit.point = forth * hit.point;
    hit.normal = forth.rotation * hit.normal;
    if (hit.oneWay) hit.oneWay = forth.rotation * *hit.oneWay;
    return hit;
}

}  // namespace

Shape grown(Shape shape, double by) {
    if (auto* circle = std::get_if<Circle>(&shape)) circle->radius += by;
    if (auto* capsule = std::get_if<Capsule>(&shape)) capsule->radius += by;
    if (auto* polygon = std::get_if<Polygon>(&shape)) polygon->radius += by;
    if (const auto* segment = std::get_if<Segment>(&shape)) return Capsule{segment->start, segment->end, by};
    return shape;
}

MovingThing movingThing(const World& world, BodyId id, double dt, const Vec2& up, const Vec2& near) {
    const BodyView body = world.body(id);
    Vec2 velocity = body.velocity();
    if (body.type() == BodyType::Dynamic) velocity -= up * std::min(0.0, velocity.dot(up));
    const Vec2 away = body.centerOfMass(), center = away + world.wrap().shiftNear(away, near);
    const double turn = body.angularVelocity() * dt;
    const Rot back = turn == 0 ? Rot{} : Rot::fromAngle(-turn);
    return {id, {center - back * Vec2(center + velocity * dt), back}};
}

SlideProbe::SlideProbe(const World& world, BodyId body, const SlideSettings& settings, double dt)
    : world_(world), body_(body), settings_(settings), dt_(dt), rotation_(world.body(body).pose().rotation) {
    for (const ShapeId& id : world.body(body).shapes()) {
        const ShapeDef def = world.shape(id);
        if (!def.sensor)
            own_.push_back({def.shape, grown(def.shape, settings.skin),
                            grown(def.shape, settings.skin * (1 + 1e-6) + 1e-9), def.filter});
    }
}

void SlideProbe::findMoving(double within, const std::optional<BodyId>& floor, std::span<const BodyId> still) {
    moving_.clear();
    const Vec2 position = world_.body(body_).position();
    const auto take = [&](BodyId id) {
        if (id == body_ || find(id) != nullptr) return;
        const BodyView view = world_.body(id);
        const bool carries = floor && id == *floor && view.type() == BodyType::Dynamic;
        if (view.type() != BodyType::Kinematic && !carries) return;
        if (view.velocity().isZero(0) && view.angularVelocity() == 0) return;
        if (!(floor && id == *floor) && std::ranges::find(still, id) != still.end()) return;
        moving_.push_back(movingThing(world_, id, dt_, settings_.up, position));
    };
    if (floor && world_.contains(*floor)) take(*floor);
    for (const Own& own : own_)
        for (const ShapeId& near : world_.overlapBox(inflate(aabbOf(own.shape, poseAt(position)), within), own.filter))
            take(near.body);
}

const MovingThing* SlideProbe::find(BodyId body) const {
    const auto found = std::ranges::find(moving_, body, &MovingThing::body);
    return found == moving_.end() ? nullptr : &*found;
}

void SlideProbe::meetMap(const ShapeId& map) const {
    if (std::ranges::find(maps_, map) == maps_.end()) maps_.push_back(map);
}

Transform SlideProbe::poseOfMap(const ShapeId& shape, const TileMap& map, const Vec2& near) const {
    const MovingThing* thing = find(shape.body);
    Transform pose = world_.body(shape.body).pose();
    if (thing != nullptr) pose = thing->back.inverse() * pose;
    const Vec2 middle = pose * Vec2(0.5 * map.size() * Vec2(map.columns(), map.rows()));
    pose.position += world_.wrap().shiftNear(middle, near);
    return pose;
}

template <class Visit>
void SlideProbe::meetAll(const Shape& shape, const Filter& filter, const Vec2& from, const Vec2& shift,
                         Visit&& visit) const {
    const Transform pose = poseAt(from);
    const auto tell = [&](const CastHit& hit) {
        if (hit.tile) meetMap(hit.shape);
        visit(hit);
    };
    for (const CastHit& hit : world_.castShapePieces(shape, pose, shift, filter, body_))
        if (find(hit.shape.body) == nullptr) tell(hit);
    for (const MovingThing& thing : moving_) {
        const Vec2 shiftThere = thing.back.rotation * shift;
        for (const CastHit& hit : world_.castShapePieces(shape, thing.back * pose, shiftThere, filter, body_))
            if (hit.shape.body == thing.body) tell(asSeenAfter(thing, hit));
    }
}

/// The pieces of a chain are one; of a tile map those that are solid from all sides, and each one-way floor.
bool SlideProbe::isSame(const CastHit& a, const CastHit& b) const {
    if (!(a.shape == b.shape) || a.oneWay.has_value() != b.oneWay.has_value()) return false;
    return !a.oneWay || isOneFloor(world_, floorOf(a), floorOf(b));
}

/// Of the hits of a shape that stays, those of what was met: the normal that a way goes into most, if it goes into one.
/// It is another than the cast's where that began nearer than a skin.
std::optional<Vec2> SlideProbe::wallOf(const std::vector<CastHit>& here, const CastHit& met, const Vec2& shift) const {
    std::optional<Vec2> wall;
    double into = -parallel * lengthOf(shift);
    for (const CastHit& now : here) {
        if (!isSame(now, met) || !(now.normal.dot(shift) < into)) continue;
        into = now.normal.dot(shift);
        wall = now.normal;
    }
    return wall;
}

bool SlideProbe::isPassed(const OneWayFloor& floor) const {
    return std::ranges::any_of(passedFloors_,
                               [&](const OneWayFloor& passed) { return isOneFloor(world_, passed, floor); });
}

bool SlideProbe::isSolid(const CastHit& hit) const {
    if (passed_ && hit.shape.body == *passed_) return false;
    const std::optional<Vec2> open = openSideOf(hit);
    return !open || (hit.normal.dot(*open) >= openCosine && !isPassed(floorOf(hit)));
}

/// meet(own, shift, visit) casts. What is one-way is solid from a skin on only, and not to what is in it.
template <class Meet>
FreeWay SlideProbe::freeWayBy(const Vec2& from, const Vec2& shift, double leastRise, Meet&& meet) const {
    const double length = lengthOf(shift);
    if (!(length > 0)) return {};
    FreeWay free{length};
    for (const Own& own : own_) {
        std::optional<std::vector<CastHit>> here;
        meet(own.inflated, own.filter, shift, [&](CastHit hit) {
            if (!(hit.fraction * length < free.length)) return;
            if (!(hit.fraction > 0)) {
                if (!here)
                    meet(own.around, own.filter, {0, 0}, [&here](const CastHit& now) {
                        if (!here) here.emplace();
                        here->push_back(now);
                    });
                const std::optional<Vec2> wall = here ? wallOf(*here, hit, shift) : std::nullopt;
                if (!wall) return;
                hit.normal = *wall;
                if (hit.oneWay && isIn(own, from, hit)) return;
            }
            // What is convex lies behind its normal: a way along that goes into it by no more than roundings.
            if (!(hit.normal.dot(shift) < -parallel * length)) return;
            if (isSolid(hit) && hit.normal.dot(settings_.up) >= leastRise) free = {hit.fraction * length, hit};
        });
    }
    return free;
}

bool SlideProbe::isIn(const Own& own, const Vec2& at, const CastHit& met) const {
    bool inside = false;
    meetAll(own.shape, own.filter, at, {0, 0}, [&](const CastHit& hit) { inside |= isSame(hit, met); });
    return inside;
}

FreeWay SlideProbe::freeWay(const Vec2& from, const Vec2& shift, double leastRise) const {
    return freeWayBy(from, shift, leastRise,
                     [&](const Shape& shape, const Filter& filter, const Vec2& way, auto&& visit) {
                         meetAll(shape, filter, from, way, visit);
                     });
}

FreeWay SlideProbe::freeWayAgainst(const MovingThing& thing, const Vec2& from, const Vec2& to) const {
    const auto meet = [&](const Shape& shape, const Filter& filter, const Vec2& way, auto&& visit) {
        for (const CastHit& hit : world_.castShapePieces(shape, poseAt(from), way, filter, body_))
            if (hit.shape.body == thing.body) visit(hit);
    };
    FreeWay free = freeWayBy(from, thing.back * to - from, -2, meet);
    if (free.hit) free.hit = asSeenAfter(thing, *free.hit);
    return free;
}

/// From a place farther out along the normal, back until it touches.
double SlideProbe::depthOf(const Own& own, const Vec2& at, const CastHit& hit) const {
    const Aabb box = aabbOf(own.shape, poseAt(at));
    double out = 0.125 * lengthOf(box.upper - box.lower);
    for (int i = 0; i < 40; ++i, out *= 2) {
        bool inside = false;
        meetAll(own.shape, own.filter, at + hit.normal * out, {0, 0},
                [&](const CastHit& now) { inside |= isSame(now, hit); });
        if (inside) continue;
        double depth = 0;
        meetAll(own.shape, own.filter, at + hit.normal * out, -hit.normal * out, [&](const CastHit& back) {
            if (isSame(back, hit)) depth = std::max(depth, out * (1 - back.fraction));
        });
        return depth;
    }
    return 0;
}

std::vector<Overlapped> SlideProbe::overlaps(const Vec2& at) const {
    std::vector<Overlapped> found;
    for (const Own& own : own_) {
        meetAll(own.shape, own.filter, at, {0, 0}, [&](const CastHit& hit) {
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

bool SlideProbe::isInPassedFloor(const Vec2& at) const {
    bool inside = false;
    const auto look = [&](const CastHit& hit) { inside |= hit.oneWay && isPassed(floorOf(hit)); };
    for (const Own& own : own_) meetAll(own.shape, own.filter, at, {0, 0}, look);
    return inside;
}

void SlideProbe::passFloor(const OneWayFloor& floor) {
    if (!isPassed(floor)) passedFloors_.push_back(floor);
}

void SlideProbe::passFloorsUnder(const Vec2& at, const Vec2& way) {
    const Vec2 lowered = at - settings_.up * (2 * settings_.skin);
    for (const Own& own : own_)
        meetAll(own.shape, own.filter, lowered, way, [&](const CastHit& hit) {
            if (hit.oneWay) passFloor(floorOf(hit));
        });
}

}  // namespace plumb::detail
