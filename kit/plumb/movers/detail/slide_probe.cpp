// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/slide_probe.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plumb::detail {

namespace {

/// Solid to motion within 60 degrees of the open side, as for contacts.
constexpr double openCosine = 0.5;

/// A motion into a wall by less than this counts as parallel: at the end of a face, the normal of a round shape is
/// accurate only to the square root of a few roundings relative to its size [-].
constexpr double parallel = 1e-6;

double lengthOf(const Vec2& v) {
    return std::sqrt(v.dot(v));
}

OneWayFloor floorOf(const CastHit& hit) {
    return {hit.shape, hit.tile};
}

CastHit asSeenAfter(const MovingBody& other, CastHit hit) {
    const Transform forth = other.undoStep.inverse();
    hit.point = forth * hit.point;
    hit.normal = forth.rotation * hit.normal;
    if (hit.oneWay) hit.oneWay = forth.rotation * *hit.oneWay;
    return hit;
}

struct Core {
    std::vector<Vec2> corners = {};
    double radius = 0;
};

Core coreOf(const Shape& shape) {
    if (const auto* circle = std::get_if<Circle>(&shape)) return {{circle->center}, circle->radius};
    if (const auto* capsule = std::get_if<Capsule>(&shape)) return {{capsule->start, capsule->end}, capsule->radius};
    if (const auto* polygon = std::get_if<Polygon>(&shape)) return {polygon->vertices, polygon->radius};
    if (const auto* segment = std::get_if<Segment>(&shape)) return {{segment->start, segment->end}};
    if (const auto* chain = std::get_if<Chain>(&shape)) return {chain->points};
    return {};
}

}  // namespace

FaceSpan faceSpan(const Shape& shape, const Transform& pose, const Vec2& direction, const Vec2& line) {
    constexpr double inf = std::numeric_limits<double>::infinity(), flush = 1e-3;
    const Core core = coreOf(shape);
    double farthest = -inf;
    for (const Vec2& corner : core.corners) farthest = std::max(farthest, (pose * corner).dot(direction));
    FaceSpan span{inf, -inf, farthest + core.radius};
    for (const Vec2& corner : core.corners) {
        const Vec2 at = pose * corner;
        if (at.dot(direction) < farthest - flush) continue;
        span.low = std::min(span.low, at.dot(line));
        span.high = std::max(span.high, at.dot(line));
    }
    return span;
}

Shape inflatedBy(Shape shape, double by) {
    if (auto* circle = std::get_if<Circle>(&shape)) circle->radius += by;
    if (auto* capsule = std::get_if<Capsule>(&shape)) capsule->radius += by;
    if (auto* polygon = std::get_if<Polygon>(&shape)) polygon->radius += by;
    if (const auto* segment = std::get_if<Segment>(&shape)) return Capsule{segment->start, segment->end, by};
    return shape;
}

MovingBody movingBody(const World& world, BodyId id, double dt, const Vec2& up, const Vec2& near) {
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
        const ShapeDef def = world.shape(id).def();
        if (!def.sensor)
            castShapes_.push_back({def.shape, inflatedBy(def.shape, settings.skin),
                                   inflatedBy(def.shape, settings.skin * (1 + 1e-6) + 1e-9), def.filter});
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
        if (!(floor && id == *floor) && std::find(still.begin(), still.end(), id) != still.end()) return;
        moving_.push_back(movingBody(world_, id, dt_, settings_.up, position));
    };
    if (floor && world_.contains(*floor)) take(*floor);
    for (const CastShape& castShape : castShapes_)
        for (const ShapeId& near :
             world_.overlapBox(inflate(aabbOf(castShape.shape, poseAt(position)), within), castShape.filter))
            take(near.body);
}

const MovingBody* SlideProbe::find(BodyId body) const {
    const auto found =
        std::find_if(moving_.begin(), moving_.end(), [body](const MovingBody& other) { return other.body == body; });
    return found == moving_.end() ? nullptr : &*found;
}

void SlideProbe::addHitMap(const ShapeId& map) const {
    if (std::find(maps_.begin(), maps_.end(), map) == maps_.end()) maps_.push_back(map);
}

template <class Visit>
void SlideProbe::castAll(const Shape& shape, const Filter& filter, const Vec2& from, const Vec2& shift,
                         Visit&& visit) const {
    const Transform pose = poseAt(from);
    const auto report = [&](const CastHit& hit) {
        if (hit.tile) addHitMap(hit.shape);
        visit(hit);
    };
    for (const CastHit& hit : world_.castShapePieces(shape, pose, shift, filter, body_))
        if (find(hit.shape.body) == nullptr) report(hit);
    for (const MovingBody& other : moving_) {
        const Vec2 shiftThere = other.undoStep.rotation * shift;
        for (const CastHit& hit : world_.castShapePieces(shape, other.undoStep * pose, shiftThere, filter, body_))
            if (hit.shape.body == other.body) report(asSeenAfter(other, hit));
    }
}

/// All pieces of a chain are the same obstacle; of a tile map, all tiles that are solid from all sides, and each
/// one-way floor.
bool SlideProbe::isSame(const CastHit& a, const CastHit& b) const {
    if (!(a.shape == b.shape) || a.oneWay.has_value() != b.oneWay.has_value()) return false;
    return !a.oneWay || isOneFloor(world_, floorOf(a), floorOf(b));
}

/// Among the hits of the shape at rest, those of the given obstacle: the normal that the motion points against most, if
/// there is one. It may differ from the cast's normal where the cast began nearer than a skin.
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
    return std::any_of(passedFloors_.begin(), passedFloors_.end(),
                       [&](const OneWayFloor& passed) { return isOneFloor(world_, passed, floor); });
}

bool SlideProbe::isSolid(const CastHit& hit) const {
    if (passed_ && hit.shape.body == *passed_) return false;
    const std::optional<Vec2> open = openSideOf(hit);
    return !open || (hit.normal.dot(*open) >= openCosine && !isPassed(floorOf(hit)));
}

/// cast(shape, filter, shift, visit) casts. A one-way obstacle is solid only from a skin's distance on, and not to a
/// body inside of it.
template <class Cast>
FreePath SlideProbe::freePathBy(const Vec2& from, const Vec2& shift, double leastRise, Cast&& cast) const {
    const double length = lengthOf(shift);
    if (!(length > 0)) return {};
    FreePath free{length};
    for (const CastShape& castShape : castShapes_) {
        std::optional<std::vector<CastHit>> here;
        cast(castShape.inflated, castShape.filter, shift, [&](CastHit hit) {
            if (!(hit.fraction * length < free.length)) return;
            if (!(hit.fraction > 0)) {
                if (!here)
                    cast(castShape.around, castShape.filter, {0, 0}, [&here](const CastHit& now) {
                        if (!here) here.emplace();
                        here->push_back(now);
                    });
                const std::optional<Vec2> wall = here ? wallOf(*here, hit, shift) : std::nullopt;
                if (!wall) return;
                hit.normal = *wall;
                if (hit.oneWay && isIn(castShape, from, hit)) return;
            }
            // A convex obstacle is behind its normal: a parallel motion enters it by no more than rounding errors.
            if (!(hit.normal.dot(shift) < -parallel * length)) return;
            if (isSolid(hit) && hit.normal.dot(settings_.up) >= leastRise) free = {hit.fraction * length, hit};
        });
    }
    return free;
}

bool SlideProbe::isIn(const CastShape& castShape, const Vec2& at, const CastHit& met) const {
    bool inside = false;
    castAll(castShape.shape, castShape.filter, at, {0, 0}, [&](const CastHit& hit) { inside |= isSame(hit, met); });
    return inside;
}

FreePath SlideProbe::freePath(const Vec2& from, const Vec2& shift, double leastRise) const {
    return freePathBy(from, shift, leastRise,
                      [&](const Shape& shape, const Filter& filter, const Vec2& castShift, auto&& visit) {
                          castAll(shape, filter, from, castShift, visit);
                      });
}

FreePath SlideProbe::freePathAgainst(const MovingBody& other, const Vec2& from, const Vec2& to) const {
    const auto cast = [&](const Shape& shape, const Filter& filter, const Vec2& shift, auto&& visit) {
        for (const CastHit& hit : world_.castShapePieces(shape, poseAt(from), shift, filter, body_))
            if (hit.shape.body == other.body) visit(hit);
    };
    FreePath free = freePathBy(from, other.undoStep * to - from, -2, cast);
    if (free.hit) free.hit = asSeenAfter(other, *free.hit);
    return free;
}

/// From a position farther out along the normal, back until it touches.
double SlideProbe::depthOf(const CastShape& castShape, const Vec2& at, const CastHit& hit) const {
    const Aabb box = aabbOf(castShape.shape, poseAt(at));
    double out = 0.125 * lengthOf(box.upper - box.lower);
    for (int i = 0; i < 40; ++i, out *= 2) {
        bool inside = false;
        castAll(castShape.shape, castShape.filter, at + hit.normal * out, {0, 0},
                [&](const CastHit& now) { inside |= isSame(now, hit); });
        if (inside) continue;
        double depth = 0;
        castAll(castShape.shape, castShape.filter, at + hit.normal * out, -hit.normal * out, [&](const CastHit& back) {
            if (isSame(back, hit)) depth = std::max(depth, out * (1 - back.fraction));
        });
        return depth;
    }
    return 0;
}

std::vector<OverlapHit> SlideProbe::overlaps(const Vec2& at) const {
    std::vector<OverlapHit> found;
    for (const CastShape& castShape : castShapes_) {
        castAll(castShape.shape, castShape.filter, at, {0, 0}, [&](const CastHit& hit) {
            if (world_.body(hit.shape.body).type() == BodyType::Dynamic || openSideOf(hit)) return;
            found.push_back({hit, depthOf(castShape, at, hit)});
        });
    }
    return found;
}

FaceSpan SlideProbe::faceSpanAt(const Vec2& at, const Vec2& direction, const Vec2& line) const {
    FaceSpan farthest;
    for (const CastShape& castShape : castShapes_) {
        const FaceSpan span = faceSpan(castShape.shape, poseAt(at), direction, line);
        if (&castShape == &castShapes_.front() || span.farthest > farthest.farthest) farthest = span;
    }
    return farthest;
}

bool SlideProbe::isInPassedFloor(const Vec2& at) const {
    bool inside = false;
    const auto look = [&](const CastHit& hit) { inside |= hit.oneWay && isPassed(floorOf(hit)); };
    for (const CastShape& castShape : castShapes_) castAll(castShape.shape, castShape.filter, at, {0, 0}, look);
    return inside;
}

void SlideProbe::passFloor(const OneWayFloor& floor) {
    if (!isPassed(floor)) passedFloors_.push_back(floor);
}

void SlideProbe::passFloorsUnder(const Vec2& at, const Vec2& shift) {
    const Vec2 lowered = at - settings_.up * (2 * settings_.skin);
    for (const CastShape& castShape : castShapes_)
        castAll(castShape.shape, castShape.filter, lowered, shift, [&](const CastHit& hit) {
            if (hit.oneWay) passFloor(floorOf(hit));
        });
}

}  // namespace plumb::detail
