// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/slide_run.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/math/trig.h>

namespace plumb::detail {

namespace {

/// What rounding leaves of a way, of a tick's or of a skin [-].
constexpr double tiny = 1e-9;

}  // namespace

bool SlideRun::isFloor(const Vec2& normal) const {
    return normal.dot(up()) >= leastFloorRise;
}

double leastFloorRise(const SlideSettings& settings, const Vec2& position) {
    if (settings.motionMode == MotionMode::Floating) return 2;
    // Some ten roundings of the place, and of what a cast leaves open.
    const double rounding = 1e-14 * (10 + position.cwiseAbs().maxCoeff());
    return sinCos(settings.maxFloorAngle + std::sqrt(2 * rounding / settings.skin)).cos - 1e-6;
}

Vec2 SlideRun::alongFloor(const Vec2& normal, double side) const {
    const Vec2 way(normal.y(), -normal.x());
    return way * (way.dot(right()) < 0 ? -side : side);
}

SlideHit& SlideRun::note(const CastHit& hit, SlideEffect effect) {
    const bool isPassedBy = effect == SlideEffect::Stepped || effect == SlideEffect::Nudged;
    if (!isPassedBy) touch(hit.normal);
    const BodyView body = std::as_const(world).body(hit.shape.body);
    const Vec2 closing = velocity + carry - body.velocityAt(hit.point);
    out.hits.push_back(
        {hit.shape, hit.tile, hit.point, hit.normal, std::max(0.0, -closing.dot(hit.normal)), 0, effect});
    return out.hits.back();
}

void SlideRun::touch(const Vec2& normal) {
    if (isFloor(normal)) return;
    if (isCeiling(normal)) {
        out.isOnCeiling = true;
        return;
    }
    out.isOnWall = true;
    out.wallNormal = normal;
}

Vec2 meetWall(SlideRun& run, const CastHit& hit, SlideEffect effect) {
    SlideHit& noted = run.note(hit, effect);
    const SlidePush pushed = push(run, hit, run.velocity + run.carry);
    noted.impulse = pushed.impulse;
    if (noted.impulse > 0) noted.effect = SlideEffect::Pushed;
    // What gives way leaves it as much speed as it has itself; what comes gives it none.
    const double kept = std::min(0.0, (pushed.surface - run.carry).dot(hit.normal));
    const double into = run.velocity.dot(hit.normal) - kept;
    if (into < 0) run.velocity -= hit.normal * into;
    return pushed.surface;
}

void walk(SlideRun& run, double length, double side) {
    for (int i = 0; i < run.settings.maxSlides && length > 0; ++i) {
        const Vec2 along = run.alongFloor(run.out.floorNormal, side);
        const double across = along.dot(run.right()) * side;
        const double stretch = run.settings.floorConstantSpeed ? 1 : 1 / across;
        const FreeWay way = run.probe.freeWay(run.position, along * (length * stretch));
        run.position += along * way.length;
        run.places.push_back(run.position);
        run.along = along;
        length -= way.length / stretch;
        if (!way.hit) return;
        if (run.isFloor(way.hit->normal)) {
            run.note(*way.hit, SlideEffect::Landed);
            run.out.floorNormal = way.hit->normal;
            continue;
        }
        if (stepOver(run, *way.hit, run.right() * side, length, run.settings.stepHeight, true)) continue;
        run.velocity = run.right() * run.velocity.dot(run.right());
        const Vec2 surface = meetWall(run, *way.hit, SlideEffect::Stopped);
        // A wall that leans does not lift who walks into it; nor does a ceiling over a slope let it go on.
        if (run.isCeiling(way.hit->normal)) run.out.wallNormal = run.right() * -side;
        run.out.isOnWall = true;
        const double most = std::max(0.0, (surface - run.carry).dot(run.right()) * side);
        run.velocity = run.right() * (side * std::min(run.velocity.dot(run.right()) * side, most));
        return;
    }
}

namespace {

/// Where the floor falls away, the corner is cut: the way was straight on for too long. Goes on along the new floor by
/// what is left of the way beyond the corner.
void bend(SlideRun& run, const Vec2& before, const Vec2& normal) {
    const Vec2 along = run.along;
    const double side = along.dot(run.right()) < 0 ? -1 : 1;
    const Vec2 next = run.alongFloor(normal, side);
    const double turn = cross(along, next);
    if (std::fabs(turn) < tiny) return;
    // The corner is at before - along past, and at run.position - next beyond.
    const Vec2 down = run.position - before;
    const double past = -cross(down, next) / turn, beyond = cross(down, along) / -turn;
    if (!(past > 0 && beyond > 0)) return;
    const double more = run.settings.floorConstantSpeed ? past - beyond : 0;
    const FreeWay way = run.probe.freeWay(run.position, next * more);
    run.position += next * (more < 0 ? -way.length : way.length);
}

/// How far a floor falls over a stretch of this length.
double dropOf(const SlideRun& run, const Vec2& normal, double across) {
    const double side = run.along.dot(run.right()) < 0 ? -1 : 1;
    return std::max(0.0, across * side * normal.dot(run.right()) / normal.dot(run.up()));
}

}  // namespace

bool settle(SlideRun& run, double reach, double across) {
    // From a skin above: it may have come nearer than a skin.
    const double skin = run.settings.skin;
    const Vec2 top = run.position + run.up() * skin;
    const Vec2 down = run.up() * -(reach + 2 * across + 2 * skin);
    const FreeWay any = run.probe.freeWay(top, down);
    if (!any.hit) return false;
    const FreeWay way = run.isFloor(any.hit->normal) ? any : run.probe.freeWay(top, down, run.leastFloorRise);
    // A wall beside it may be as near as the floor, to rounding.
    if (!way.hit || any.length < way.length - skin) return false;
    // A floor that falls away is followed; an edge only as deep as reach.
    const double risen = run.along.dot(run.up()) * across;
    if (any.length - skin > reach + std::max(0.0, risen) + dropOf(run, way.hit->normal, across)) return false;
    const Vec2 before = run.position;
    run.position = top - run.up() * any.length;
    if (!run.along.isZero(0)) bend(run, before, way.hit->normal);
    run.out.isOnFloor = true;
    run.out.floorNormal = way.hit->normal;
    run.out.floor = *way.hit;
    return true;
}

namespace {

/// The rest of a way, along what it met; a wall that leans back does not lift what does not rise.
Vec2 slideAlong(const SlideRun& run, const Vec2& shift, const Vec2& normal) {
    const double into = shift.dot(normal);
    if (!(into < 0)) return shift;
    Vec2 rest = shift - normal * into;
    const double rise = rest.dot(run.up());
    if (rise > 0 && shift.dot(run.up()) <= 0 && !run.floats()) rest.setZero();
    return rest;
}

/// Lands, and walks on by the level part of what is left of its way.
void land(SlideRun& run, const CastHit& hit, const Vec2& rest) {
    run.note(hit, SlideEffect::Landed);
    run.out.isOnFloor = true;
    run.out.floorNormal = hit.normal;
    run.out.floor = hit;
    const double level = rest.dot(run.right());
    walk(run, std::fabs(level), level < 0 ? -1 : 1);
}

bool isAround(SlideRun& run, const CastHit& hit, Vec2& shift) {
    if (run.floats()) return false;
    const double level = shift.dot(run.right()), rise = shift.dot(run.up());
    const double side = level < 0 ? -1 : 1;
    if (run.isCeiling(hit.normal))
        return rise > 0 && run.settings.cornerCorrection > 0 && nudgeAside(run, hit, rise, side);
    if (run.isFloor(hit.normal) || !(run.settings.ledgeNudge > 0)) return false;
    double length = std::fabs(level);
    if (!stepOver(run, hit, run.right() * side, length, run.settings.ledgeNudge, false)) return false;
    shift = run.right() * (side * length) + run.up() * rise;
    return true;
}

/// Does it not slide along what it meets?
bool stopsAt(const SlideRun& run, const Vec2& normal, const Vec2& shift) {
    if (run.isCeiling(normal)) return !run.settings.slideOnCeiling && run.velocity.dot(run.up()) > 0;
    // The angle between the way and the wall's normal is less than that.
    const double into = -shift.dot(normal), along = std::fabs(cross(shift, normal));
    return run.floats() && arcTangent(along, into) < run.settings.wallMinSlideAngle;
}

/// It goes on only against a wall that gives way.
void stop(SlideRun& run, const CastHit& hit) {
    meetWall(run, hit, SlideEffect::Stopped);
    const Vec2 way = run.isCeiling(hit.normal) ? run.up() : hit.normal;
    run.velocity = way * std::min(0.0, run.velocity.dot(way));
}

}  // namespace

void fly(SlideRun& run, Vec2 shift) {
    std::optional<Vec2> plane;
    for (int i = 0; i < run.settings.maxSlides; ++i) {
        const double length = std::sqrt(shift.dot(shift));
        if (!(length > 0)) return;
        const FreeWay way = run.probe.freeWay(run.position, shift);
        run.position += shift * (way.length / length);
        run.places.push_back(run.position);
        if (!way.hit) return;
        shift *= 1 - way.length / length;
        const Vec2 normal = way.hit->normal;
        if (run.isFloor(normal) && run.velocity.dot(run.up()) <= 0) return land(run, *way.hit, shift);
        if (isAround(run, *way.hit, shift)) continue;
        if (stopsAt(run, normal, shift)) {
            stop(run, *way.hit);
            return;
        }
        meetWall(run, *way.hit, SlideEffect::Slid);
        const bool falls = shift.dot(run.up()) < 0;
        const Vec2 rest = slideAlong(run, shift, normal);
        const bool wedged = plane && rest.dot(*plane) < -tiny * length;
        // Between two walls that lean apart it stands as on a floor.
        if (wedged && falls && !run.floats() && (*plane + normal).dot(run.up()) > tiny) {
            run.out.isOnFloor = true;
            run.out.floorNormal = run.up();
            run.out.floor = *way.hit;
        }
        if (wedged || rest.isZero(0)) run.out.hits.back().effect = SlideEffect::Stopped;
        if (wedged) return;
        shift = rest;
        plane = normal;
    }
}

}  // namespace plumb::detail
