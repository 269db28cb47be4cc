// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/movers/detail/slide_run.h>

namespace plumb::detail {

bool stepOver(SlideRun& run, const CastHit& wall, const Vec2& along, double& length, double height, bool toFloor) {
    if (!(height > 0)) return false;
    const double skin = run.settings.skin;
    const double lift = run.probe.freePath(run.position, run.up() * (height + skin)).length;
    const Vec2 above = run.position + run.up() * lift;
    // A little over the edge, even for a short motion: it would never get onto the step otherwise.
    const double wanted = std::max(length, 2 * skin);
    const double on = run.probe.freePath(above, along * wanted).length;
    if (!(on > skin)) return false;
    const Vec2 over = above + along * on;
    const FreePath down = run.probe.freePath(over, run.up() * -lift);
    const double gain = lift - down.length;
    if (!(gain > 0) || !down.hit || !run.isFloor(down.hit->normal) || gain > height + skin) return false;
    run.recordHit(wall, toFloor ? SlideEffect::Stepped : SlideEffect::Nudged);
    run.position = over - run.up() * down.length;
    run.along.setZero();
    length = std::max(0.0, length - on);
    if (toFloor) run.out.floorNormal = down.hit->normal;
    return true;
}

bool nudgeAside(SlideRun& run, const CastHit& ceiling, double rise, double side) {
    for (const double to : {side, -side}) {
        const Vec2 along = run.right() * to;
        const double aside = run.probe.freePath(run.position, along * run.settings.cornerCorrection).length;
        if (!(aside > 0)) continue;
        const Vec2 beside = run.position + along * aside;
        const Vec2 lift = run.up() * rise;
        if (run.probe.freePath(beside, lift).hit) continue;
        const double back = run.probe.freePath(beside + lift, along * -aside).length;
        run.recordHit(ceiling, SlideEffect::Nudged);
        run.position += along * (aside - back);
        return true;
    }
    return false;
}

namespace {

/// A direction that was deflected must gain at least this along the push: otherwise the mover counts as blocked, 6
/// degrees from head-on [-].
constexpr double leastGain = 0.1;

/// Moves by a length along a normal, and slides along obstacles, also up floors, until it has moved as far along that
/// normal. Returns how far it moved.
double moveAlongNormal(SlideRun& run, const Vec2& normal, double length) {
    Vec2 direction = normal;
    double left = length;
    std::optional<Vec2> plane;
    for (int i = 0; i < run.settings.maxSlides && left > 0; ++i) {
        const double gain = direction.dot(normal);
        const FreePath free = run.probe.freePath(run.position, direction * (left / gain));
        run.position += direction * free.length;
        if (!free.hit) return length;
        left -= free.length * gain;
        const Vec2 line = perp(free.hit->normal);
        direction = line.dot(normal) < 0 ? Vec2(-line) : line;
        const bool wedged = plane && direction.dot(*plane) < -1e-9;
        if (wedged || direction.dot(normal) < leastGain) break;
        plane = free.hit->normal;
    }
    return length - left;
}

}  // namespace

void pushAside(SlideRun& run, const Vec2& from) {
    for (const MovingBody& other : run.probe.moving()) {
        if (run.out.floor && other.body == run.out.floor->shape.body) continue;
        const Vec2 seen = other.undoStep * run.position - from;
        const double length = std::sqrt(seen.dot(seen));
        if (!(length > 0)) continue;
        const FreePath path = run.probe.freePathAgainst(other, from, run.position);
        if (!path.hit) continue;
        const Vec2 normal = path.hit->normal;
        const double closing = -(other.undoStep.rotation.inverse() * seen).dot(normal) / length;
        const double needed = (length - path.length) * closing;
        if (!(needed > 0)) continue;
        run.recordHit(*path.hit, SlideEffect::PushedBy);
        // A fast body may be after the step where the mover passes now.
        run.probe.pass(other.body);
        moveAlongNormal(run, normal, needed);
        run.probe.pass(std::nullopt);
    }
}

void resolveOverlaps(SlideRun& run) {
    std::vector<OverlapHit> overlaps = run.probe.overlaps(run.position);
    for (int i = 0; i < 8 && !overlaps.empty(); ++i) {
        const auto deepest =
            std::max_element(overlaps.begin(), overlaps.end(),
                             [](const OverlapHit& a, const OverlapHit& b) { return a.depth < b.depth; });
        run.recordHit(deepest->hit, SlideEffect::PushedBy);
        const double went = moveAlongNormal(run, deepest->hit.normal, deepest->depth + run.settings.skin);
        overlaps = run.probe.overlaps(run.position);
        if (!(went > 0)) break;
    }
    run.out.crushed = !overlaps.empty();
}

namespace {

/// Two flush faces push each other at the middle of their common part.
Vec2 middleOf(const SlideRun& run, const CastHit& hit) {
    const Vec2 line = perp(hit.normal);
    Transform pose = std::as_const(run.world).body(hit.shape.body).pose();
    pose.position += run.world.wrap().shiftNear(pose.position, run.position);
    const FaceSpan theirs = faceSpan(run.world.shape(hit.shape).def().shape, pose, hit.normal, line);
    const FaceSpan ours = run.probe.faceSpanAt(run.position, -hit.normal, line);
    const double low = std::max(theirs.low, ours.low), high = std::min(theirs.high, ours.high);
    if (!(low <= high)) return hit.point;
    return hit.point + line * (0.5 * (low + high) - hit.point.dot(line));
}

}  // namespace

namespace {

/// The inverse effective mass of a body at a point, along a direction [1/kg]: found by a trial impulse, because the
/// body's rotation, or its motion along an axis, may be locked, so that its mass alone does not tell.
double inverseEffectiveMass(Body& body, const Vec2& at, const Vec2& direction) {
    const Vec2 velocity = body.velocity();
    const double turn = body.angularVelocity(), before = body.velocityAt(at).dot(direction);
    const double trial = body.mass();
    body.applyImpulse(direction * trial, at);
    const double gained = body.velocityAt(at).dot(direction) - before;
    body.setVelocity(velocity);
    body.setAngularVelocity(turn);
    return std::max(0.0, gained) / trial;
}

}  // namespace

SlidePush push(SlideRun& run, const CastHit& hit, const Vec2& velocity) {
    Body body = run.world.body(hit.shape.body);
    const Vec2 at = body.type() == BodyType::Dynamic ? middleOf(run, hit) : hit.point;
    const Vec2 surface = body.velocityAt(at);
    const bool again = std::find(run.pushed.begin(), run.pushed.end(), hit.shape.body) != run.pushed.end();
    const double closing = -(velocity - surface).dot(hit.normal);
    if (body.type() != BodyType::Dynamic || !(run.pushLeft > 0) || !(closing > 0) || again) return {0, surface};
    const double inverseMass = inverseEffectiveMass(body, at, -hit.normal);
    const double impulse = inverseMass > 0 ? std::min(run.pushLeft, closing / inverseMass) : run.pushLeft;
    // As a force over the whole step: static friction can resist it, which it could not for an instantaneous impulse.
    body.applyForce(-hit.normal * (impulse / run.dt), at);
    run.pushLeft -= impulse;
    run.pushed.push_back(hit.shape.body);
    return {impulse, surface - hit.normal * (impulse * inverseMass)};
}

}  // namespace plumb::detail
