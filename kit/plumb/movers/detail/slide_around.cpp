// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/movers/detail/slide_run.h>

namespace plumb::detail {

bool stepOver(SlideRun& run, const CastHit& wall, const Vec2& along, double& length, double height, bool toFloor) {
    if (!(height > 0)) return false;
    const double skin = run.settings.skin;
    const double lift = run.probe.freeWay(run.position, run.up() * (height + skin)).length;
    const Vec2 above = run.position + run.up() * lift;
    // A little over the edge, however short the way: it would never get on it otherwise.
    const double wanted = std::max(length, 2 * skin);
    const double on = run.probe.freeWay(above, along * wanted).length;
    if (!(on > skin)) return false;
    const Vec2 over = above + along * on;
    const FreeWay down = run.probe.freeWay(over, run.up() * -lift);
    const double gain = lift - down.length;
    if (!(gain > 0) || !down.hit || !run.isFloor(down.hit->normal) || gain > height + skin) return false;
    run.note(wall, toFloor ? SlideEffect::Stepped : SlideEffect::Nudged);
    run.position = over - run.up() * down.length;
    run.along.setZero();
    length = std::max(0.0, length - on);
    if (toFloor) run.out.floorNormal = down.hit->normal;
    return true;
}

bool nudgeAside(SlideRun& run, const CastHit& ceiling, double rise, double side) {
    for (const double to : {side, -side}) {
        const Vec2 along = run.right() * to;
        const double aside = run.probe.freeWay(run.position, along * run.settings.cornerCorrection).length;
        if (!(aside > 0)) continue;
        const Vec2 beside = run.position + along * aside;
        const Vec2 lift = run.up() * rise;
        if (run.probe.freeWay(beside, lift).hit) continue;
        const double back = run.probe.freeWay(beside + lift, along * -aside).length;
        run.note(ceiling, SlideEffect::Nudged);
        run.position += along * (aside - back);
        return true;
    }
    return false;
}

namespace {

/// A way that is turned aside gains no less along the push than this: 6 degrees from straight against it are a
/// dead end [-].
constexpr double leastGain = 0.1;

/// Goes on by a length along a normal, and slides along what it meets, up floors too, until it has come as far along
/// that normal. Gives how far it came.
double shove(SlideRun& run, const Vec2& normal, double length) {
    Vec2 way = normal;
    double left = length;
    std::optional<Vec2> plane;
    for (int i = 0; i < run.settings.maxSlides && left > 0; ++i) {
        const double gain = way.dot(normal);
        const FreeWay free = run.probe.freeWay(run.position, way * (left / gain));
        run.position += way * free.length;
        if (!free.hit) return length;
        left -= free.length * gain;
        const Vec2 line = perp(free.hit->normal);
        way = line.dot(normal) < 0 ? Vec2(-line) : line;
        const bool wedged = plane && way.dot(*plane) < -1e-9;
        if (wedged || way.dot(normal) < leastGain) break;
        plane = free.hit->normal;
    }
    return length - left;
}

}  // namespace

void pushAside(SlideRun& run, const Vec2& from) {
    for (const MovingThing& thing : run.probe.moving()) {
        if (run.out.floor && thing.body == run.out.floor->shape.body) continue;
        const Vec2 seen = thing.back * run.position - from;
        const double length = std::sqrt(seen.dot(seen));
        if (!(length > 0)) continue;
        const FreeWay way = run.probe.freeWayAgainst(thing, from, run.position);
        if (!way.hit) continue;
        const Vec2 normal = way.hit->normal;
        const double closing = -(thing.back.rotation.inverse() * seen).dot(normal) / length;
        const double needed = (length - way.length) * closing;
        if (!(needed > 0)) continue;
        run.note(*way.hit, SlideEffect::PushedBy);
        // Where it is fast, its place after the step lies on the way.
        run.probe.pass(thing.body);
        shove(run, normal, needed);
        run.probe.pass(std::nullopt);
    }
}

void partOverlaps(SlideRun& run) {
    std::vector<Overlapped> overlaps = run.probe.overlaps(run.position);
    for (int i = 0; i < 8 && !overlaps.empty(); ++i) {
        const auto deepest =
            std::max_element(overlaps.begin(), overlaps.end(),
                             [](const Overlapped& a, const Overlapped& b) { return a.depth < b.depth; });
        run.note(deepest->hit, SlideEffect::PushedBy);
        const double went = shove(run, deepest->hit.normal, deepest->depth + run.settings.skin);
        overlaps = run.probe.overlaps(run.position);
        if (!(went > 0)) break;
    }
    run.out.crushed = !overlaps.empty();
}

namespace {

/// Two faces that lie flush push each other in the middle of what they share.
Vec2 middleOf(const SlideRun& run, const CastHit& hit) {
    const Vec2 line = perp(hit.normal);
    Transform pose = std::as_const(run.world).body(hit.shape.body).pose();
    pose.position += run.world.wrap().shiftNear(pose.position, run.position);
    const FaceSpan theirs = faceSpan(run.world.shape(hit.shape).shape, pose, hit.normal, line);
    const FaceSpan ours = run.probe.faceSpanAt(run.position, -hit.normal, line);
    const double low = std::max(theirs.low, ours.low), high = std::min(theirs.high, ours.high);
    if (!(low <= high)) return hit.point;
    return hit.point + line * (0.5 * (low + high) - hit.point.dot(line));
}

}  // namespace

namespace {

/// What an impulse at a point gives that point along it, for each newton second; it may be held from turning, or along
/// an axis, and then no mass tells.
double yieldOf(Body& body, const Vec2& at, const Vec2& way) {
    const Vec2 velocity = body.velocity();
    const double turn = body.angularVelocity(), before = body.velocityAt(at).dot(way);
    const double trial = body.mass();
    body.applyImpulse(way * trial, at);
    const double gained = body.velocityAt(at).dot(way) - before;
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
    const double yield = yieldOf(body, at, -hit.normal);
    const double impulse = yield > 0 ? std::min(run.pushLeft, closing / yield) : run.pushLeft;
    // Over the whole of the step: friction that is stronger holds it, as it would not hold a blow.
    body.applyForce(-hit.normal * (impulse / run.dt), at);
    run.pushLeft -= impulse;
    run.pushed.push_back(hit.shape.body);
    return {impulse, surface - hit.normal * (impulse * yield)};
}

}  // namespace plumb::detail
