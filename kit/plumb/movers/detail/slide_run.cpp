// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/slide_run.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/math/trig.h>

namespace plumb::detail {

namespace {

/// The rounding error of a motion, relative to a tick's motion or a skin [-].
constexpr double tiny = 1e-9;

}  // namespace

bool SlideRun::isFloor(const Vec2& normal) const {
    return normal.dot(up()) >= leastFloorRise;
}

double leastFloorRise(const SlideSettings& settings, const Vec2& position) {
    if (settings.motionMode == MotionMode::Floating) return 2;
    // About ten roundings of the position, and of the error of a cast.
    const double rounding = 1e-14 * (10 + position.cwiseAbs().maxCoeff());
    return sinCos(settings.maxFloorAngle + std::sqrt(2 * rounding / settings.skin)).cos - 1e-6;
}

Vec2 SlideRun::alongFloor(const Vec2& normal, double side) const {
    const Vec2 tangent(normal.y(), -normal.x());
    return tangent * (tangent.dot(right()) < 0 ? -side : side);
}

SlideHit& SlideRun::recordHit(const CastHit& hit, SlideEffect effect) {
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

Vec2 hitWall(SlideRun& run, const CastHit& hit, SlideEffect effect) {
    SlideHit& noted = run.recordHit(hit, effect);
    const SlidePush pushed = push(run, hit, run.velocity + run.carry);
    noted.impulse = pushed.impulse;
    if (noted.impulse > 0) noted.effect = SlideEffect::Pushed;
    // A pushed body leaves the mover the velocity that it has itself; an approaching one adds none.
    const double kept = std::min(0.0, (pushed.surface - run.carry).dot(hit.normal));
    const double into = run.velocity.dot(hit.normal) - kept;
    if (into < 0) run.velocity -= hit.normal * into;
    return pushed.surface;
}

namespace {

/// Leaves the floor, with the rest of the motion and of the speed along the wall.
void runUp(SlideRun& run, const CastHit& wall, const Vec2& rest) {
    hitWall(run, wall, SlideEffect::Slid);
    fly(run, rest - wall.normal * std::min(0.0, rest.dot(wall.normal)));
}

}  // namespace

void walk(SlideRun& run, double length, double side) {
    for (int i = 0; i < run.settings.maxSlides && length > 0; ++i) {
        const Vec2 along = run.alongFloor(run.out.floorNormal, side);
        const double across = along.dot(run.right()) * side;
        const double stretch = run.settings.floorConstantSpeed ? 1 : 1 / across;
        const FreePath path = run.probe.freePath(run.position, along * (length * stretch));
        run.position += along * path.length;
        run.waypoints.push_back(run.position);
        run.along = along;
        length -= path.length / stretch;
        if (!path.hit) return;
        if (run.isFloor(path.hit->normal)) {
            run.recordHit(*path.hit, SlideEffect::Landed);
            run.out.floorNormal = path.hit->normal;
            continue;
        }
        if (stepOver(run, *path.hit, run.right() * side, length, run.settings.stepHeight, true)) continue;
        run.velocity = run.right() * run.velocity.dot(run.right());
        if (!run.settings.floorBlockOnWall && path.hit->normal.dot(run.up()) > tiny)
            return runUp(run, *path.hit, along * (length * stretch));
        const Vec2 surface = hitWall(run, *path.hit, SlideEffect::Stopped);
        // A leaning wall does not lift a character that walks into it; nor does a ceiling over a slope let it continue.
        if (run.isCeiling(path.hit->normal)) run.out.wallNormal = run.right() * -side;
        run.out.isOnWall = true;
        const double most = std::max(0.0, (surface - run.carry).dot(run.right()) * side);
        run.velocity = run.right() * (side * std::min(run.velocity.dot(run.right()) * side, most));
        return;
    }
}

namespace {

/// Where the floor drops, the straight motion has cut the corner. Moves along the new floor by what is left of the
/// motion beyond the corner. Not over an edge: across [m] was walked on that floor, and the intersection of the two
/// floor lines is farther away than that.
void followCorner(SlideRun& run, const Vec2& before, const Vec2& normal, double across) {
    const Vec2 along = run.along;
    const double side = along.dot(run.right()) < 0 ? -1 : 1;
    const Vec2 next = run.alongFloor(normal, side);
    const double turn = cross(along, next);
    if (std::fabs(turn) < tiny) return;
    // The corner is at before - along past, and at run.position - next beyond.
    const Vec2 down = run.position - before;
    const double past = -cross(down, next) / turn, beyond = cross(down, along) / -turn;
    if (!(past > 0 && beyond > 0) || past > across * (1 + tiny) + run.settings.skin) return;
    const double more = run.settings.floorConstantSpeed ? past - beyond : 0;
    const FreePath path = run.probe.freePath(run.position, next * more);
    run.position += next * (more < 0 ? -path.length : path.length);
}

/// How far a floor drops over a distance of this length.
double dropOf(const SlideRun& run, const Vec2& normal, double across) {
    const double side = run.along.dot(run.right()) < 0 ? -1 : 1;
    return std::max(0.0, across * side * normal.dot(run.right()) / normal.dot(run.up()));
}

}  // namespace

bool snapToFloor(SlideRun& run, double reach, double across) {
    // From a skin above: it may be nearer than a skin.
    const double skin = run.settings.skin;
    const Vec2 top = run.position + run.up() * skin;
    const Vec2 down = run.up() * -(reach + 2 * across + 2 * skin);
    const FreePath any = run.probe.freePath(top, down);
    if (!any.hit) return false;
    const FreePath path = run.isFloor(any.hit->normal) ? any : run.probe.freePath(top, down, run.leastFloorRise);
    // A wall beside it may be as near as the floor, up to rounding.
    if (!path.hit || any.length < path.length - skin) return false;
    // A floor that drops is followed; an edge only if it is no deeper than reach.
    const double risen = run.along.dot(run.up()) * across;
    if (any.length - skin > reach + std::max(0.0, risen) + dropOf(run, path.hit->normal, across)) return false;
    const Vec2 before = run.position;
    run.position = top - run.up() * any.length;
    if (!run.along.isZero(0)) followCorner(run, before, path.hit->normal, across);
    run.out.isOnFloor = true;
    run.out.floorNormal = path.hit->normal;
    run.out.floor = *path.hit;
    return true;
}

namespace {

/// The rest of a motion, deflected along an obstacle; a wall that leans back does not lift a body that does not rise.
Vec2 slideAlong(const SlideRun& run, const Vec2& shift, const Vec2& normal) {
    const double into = shift.dot(normal);
    if (!(into < 0)) return shift;
    Vec2 rest = shift - normal * into;
    const double rise = rest.dot(run.up());
    if (rise > 0 && shift.dot(run.up()) <= 0 && !run.floats()) rest.setZero();
    return rest;
}

/// Lands, and walks on by the horizontal component of the rest of its motion.
void land(SlideRun& run, const CastHit& hit, const Vec2& rest) {
    run.recordHit(hit, SlideEffect::Landed);
    run.out.isOnFloor = true;
    run.out.floorNormal = hit.normal;
    run.out.floor = hit;
    const double horizontal = rest.dot(run.right());
    walk(run, std::fabs(horizontal), horizontal < 0 ? -1 : 1);
}

bool isAround(SlideRun& run, const CastHit& hit, Vec2& shift) {
    if (run.floats()) return false;
    const double horizontal = shift.dot(run.right()), rise = shift.dot(run.up());
    const double side = horizontal < 0 ? -1 : 1;
    if (run.isCeiling(hit.normal))
        return rise > 0 && run.settings.cornerCorrection > 0 && nudgeAside(run, hit, rise, side);
    if (run.isFloor(hit.normal) || !(run.settings.ledgeNudge > 0)) return false;
    double length = std::fabs(horizontal);
    if (!stepOver(run, hit, run.right() * side, length, run.settings.ledgeNudge, false)) return false;
    shift = run.right() * (side * length) + run.up() * rise;
    return true;
}

/// Does it stop instead of sliding along the obstacle?
bool stopsAt(const SlideRun& run, const Vec2& normal, const Vec2& shift) {
    if (run.isCeiling(normal)) return !run.settings.slideOnCeiling && run.velocity.dot(run.up()) > 0;
    // The angle between the motion and the wall's normal is less than that.
    const double into = -shift.dot(normal), along = std::fabs(cross(shift, normal));
    return run.floats() && arcTangent(along, into) < run.settings.wallMinSlideAngle;
}

/// Moves on only against a body that it can push.
void stop(SlideRun& run, const CastHit& hit) {
    hitWall(run, hit, SlideEffect::Stopped);
    const Vec2 direction = run.isCeiling(hit.normal) ? run.up() : hit.normal;
    run.velocity = direction * std::min(0.0, run.velocity.dot(direction));
}

}  // namespace

void fly(SlideRun& run, Vec2 shift) {
    std::optional<Vec2> plane;
    for (int i = 0; i < run.settings.maxSlides; ++i) {
        const double length = std::sqrt(shift.dot(shift));
        if (!(length > 0)) return;
        const FreePath path = run.probe.freePath(run.position, shift);
        run.position += shift * (path.length / length);
        run.waypoints.push_back(run.position);
        if (!path.hit) return;
        shift *= 1 - path.length / length;
        const Vec2 normal = path.hit->normal;
        if (run.isFloor(normal) && run.velocity.dot(run.up()) <= 0) return land(run, *path.hit, shift);
        if (isAround(run, *path.hit, shift)) continue;
        if (stopsAt(run, normal, shift)) {
            stop(run, *path.hit);
            return;
        }
        hitWall(run, *path.hit, SlideEffect::Slid);
        const bool falls = shift.dot(run.up()) < 0;
        const Vec2 rest = slideAlong(run, shift, normal);
        const bool wedged = plane && rest.dot(*plane) < -tiny * length;
        // Between two walls that lean apart it stands as on a floor.
        if (wedged && falls && !run.floats() && (*plane + normal).dot(run.up()) > tiny) {
            run.out.isOnFloor = true;
            run.out.floorNormal = run.up();
            run.out.floor = *path.hit;
        }
        if (wedged || rest.isZero(0)) run.out.hits.back().effect = SlideEffect::Stopped;
        if (wedged) return;
        shift = rest;
        plane = normal;
    }
}

}  // namespace plumb::detail
