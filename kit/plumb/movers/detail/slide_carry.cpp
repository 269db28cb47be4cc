// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/slide_carry.h>

#include <cmath>
#include <utility>

namespace plumb::detail {

namespace {

/// In a world that wraps, of the places that a point stands for the one nearest to another.
Vec2 nearTo(const World& world, const Vec2& point, const Vec2& other) {
    return world.wrap().any() ? Vec2(point + world.wrap().shiftNear(point, other)) : point;
}

constexpr double rounding = 1e-14;

/// How large the numbers are that a place comes of [m].
double roundsOf(const World& world, const Vec2& position) {
    return position.cwiseAbs().maxCoeff() + world.wrap().width.value_or(0) + world.wrap().height.value_or(0);
}
/// From where a point of the world is now to where the step takes it, with the body that it is on.
Vec2 soon(const SlideRun& run, BodyId carrier, const Vec2& now) {
    const MovingThing* thing = run.probe.find(carrier);
    return thing == nullptr ? now : Vec2(thing->back.inverse() * now);
}

Vec2 notSoon(const SlideRun& run, BodyId carrier, const Vec2& later) {
    const MovingThing* thing = run.probe.find(carrier);
    return thing == nullptr ? later : Vec2(thing->back * later);
}

/// Through whatever is in the way, but not what carries it.
bool goAlong(SlideRun& run, Vec2 shift) {
    const Vec2 wanted = run.position + shift;
    for (int i = 0; i < run.settings.maxSlides; ++i) {
        const double length = std::sqrt(shift.dot(shift));
        if (!(length > 0)) break;
        const FreeWay way = run.probe.freeWay(run.position, shift);
        if (!way.hit) {
            run.position = run.position + shift;
            break;
        }
        run.note(*way.hit, SlideEffect::Slid);
        run.position += shift * (way.length / length);
        shift *= 1 - way.length / length;
        shift -= way.hit->normal * shift.dot(way.hit->normal);
    }
    return (run.position - wanted).cwiseAbs().maxCoeff() < 1e-9;
}

}  // namespace

SlideStart startOf(const World& world, BodyId body, const Slide& last) {
    const Vec2 position = world.body(body).position(), planned = nearTo(world, last.position, position);
    const bool asPlanned = (position - planned).cwiseAbs().maxCoeff() <= rounding * (1 + roundsOf(world, position));
    return {asPlanned ? planned : position, !asPlanned};
}

bool isFloorThere(const World& world, const Slide& last, const SlideMotion& motion, const SlideSettings& settings) {
    if (!last.isOnFloor || !last.floor || !world.contains(last.floor->shape.body)) return false;
    const BodyView body = world.body(last.floor->shape.body);
    const Vec2 now = body.pose() * last.anchor, velocity = body.velocityAt(now);
    const Vec2 off = world.wrap().way(last.anchorAfter, now);
    const double speeds =
        std::sqrt(velocity.dot(velocity)) + std::sqrt(last.platformVelocity.dot(last.platformVelocity));
    return std::sqrt(off.dot(off)) <= speeds * motion.dt + settings.skin;
}

bool carries(const World& world, const CastHit& floor, const SlideSettings& settings) {
    if (settings.motionMode == MotionMode::Floating) return false;
    if (settings.platformFloorLayers == ~std::uint64_t{0}) return true;
    if (!world.contains(floor.shape)) return false;
    return (world.shape(floor.shape).filter.category & settings.platformFloorLayers) != 0;
}

bool carry(SlideRun& run, const Slide& last, bool moved) {
    const BodyId carrier = last.floor->shape.body;
    const BodyView body = std::as_const(run.world).body(carrier);
    const Vec2 anchor = moved ? run.position : nearTo(run.world, body.pose() * last.anchor, run.position);
    run.carry = body.velocityAt(run.position);
    const Vec2 shift = soon(run, carrier, anchor) - run.position;
    const double none = 10 * rounding * (1 + roundsOf(run.world, run.position));
    run.probe.pass(carrier);
    const bool arrived = shift.cwiseAbs().maxCoeff() < none || goAlong(run, shift);
    const bool turns = body.angularVelocity() != 0 || body.type() == BodyType::Dynamic;
    if (turns)
        run.position += run.up() * run.probe.freeWay(run.position, run.up() * run.settings.floorSnapLength).length;
    run.probe.pass(std::nullopt);
    if (turns) settle(run, 2 * run.settings.floorSnapLength);
    return arrived;
}

Vec2 parting(const SlideRun& run) {
    if (run.settings.platformOnLeave == PlatformOnLeave::DoNothing) return {0, 0};
    const double rise = run.carry.dot(run.up());
    const bool upOnly = run.settings.platformOnLeave == PlatformOnLeave::AddUpwardVelocity;
    return upOnly && rise < 0 ? Vec2(run.carry - run.up() * rise) : run.carry;
}

void rememberPlace(SlideRun& run, const Slide& last, bool kept) {
    if (!run.out.floor) return;
    const BodyId carrier = run.out.floor->shape.body;
    const Vec2 now = notSoon(run, carrier, run.position);
    const bool same = kept && last.floor && last.floor->shape.body == carrier;
    const Transform pose = std::as_const(run.world).body(carrier).pose();
    run.out.anchor = same ? last.anchor : Vec2(pose.inverse() * nearTo(run.world, now, pose.position));
    run.out.anchorAfter = same ? soon(run, carrier, nearTo(run.world, pose * last.anchor, now)) : run.position;
}

bool isStill(const SlideRun& run, const Vec2& here, bool kept) {
    const bool onCrate =
        kept && run.out.floor && std::as_const(run.world).body(run.out.floor->shape.body).type() == BodyType::Dynamic;
    const double moved = (run.position - here).cwiseAbs().maxCoeff();
    return moved < (onCrate ? 0.1 * run.settings.skin : 1e-15 * (1 + here.cwiseAbs().maxCoeff()));
}

}  // namespace plumb::detail
