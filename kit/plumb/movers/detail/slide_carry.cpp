// SPDX-License-Identifier: MIT
#include <plumb/movers/detail/slide_carry.h>

#include <cmath>
#include <utility>

namespace plumb::detail {

namespace {

/// In a world that wraps, the periodic image of a point that is nearest to another point.
Vec2 nearTo(const World& world, const Vec2& point, const Vec2& other) {
    return world.wrap().any() ? Vec2(point + world.wrap().shiftNear(point, other)) : point;
}

constexpr double rounding = 1e-14;

/// The magnitude of the numbers that a position is computed from [m].
double magnitudeOf(const World& world, const Vec2& position) {
    return position.cwiseAbs().maxCoeff() + world.wrap().width.value_or(0) + world.wrap().height.value_or(0);
}
/// Where the step takes a point of the world that is fixed to a body.
Vec2 afterStep(const SlideRun& run, BodyId carrier, const Vec2& now) {
    const MovingBody* other = run.probe.find(carrier);
    return other == nullptr ? now : Vec2(other->undoStep.inverse() * now);
}

Vec2 beforeStep(const SlideRun& run, BodyId carrier, const Vec2& later) {
    const MovingBody* other = run.probe.find(carrier);
    return other == nullptr ? later : Vec2(other->undoStep * later);
}

/// Moves and slides along obstacles, ignoring the carrier.
bool moveByCarrier(SlideRun& run, Vec2 shift) {
    const Vec2 wanted = run.position + shift;
    for (int i = 0; i < run.settings.maxSlides; ++i) {
        const double length = std::sqrt(shift.dot(shift));
        if (!(length > 0)) break;
        const FreePath path = run.probe.freePath(run.position, shift);
        if (!path.hit) {
            run.position = run.position + shift;
            break;
        }
        run.recordHit(*path.hit, SlideEffect::Slid);
        run.position += shift * (path.length / length);
        shift *= 1 - path.length / length;
        shift -= path.hit->normal * shift.dot(path.hit->normal);
    }
    return (run.position - wanted).cwiseAbs().maxCoeff() < 1e-9;
}

}  // namespace

SlideStart startOf(const World& world, BodyId body, const Slide& last) {
    const Vec2 position = world.body(body).position(), planned = nearTo(world, last.position, position);
    const bool asPlanned = (position - planned).cwiseAbs().maxCoeff() <= rounding * (1 + magnitudeOf(world, position));
    return {asPlanned ? planned : position, !asPlanned};
}

bool isFloorThere(const World& world, const Slide& last, const SlideMotion& motion, const SlideSettings& settings) {
    if (!last.isOnFloor || !last.floor || !world.contains(last.floor->shape.body)) return false;
    const BodyView body = world.body(last.floor->shape.body);
    const Vec2 now = body.pose() * last.anchor, velocity = body.velocityAt(now);
    const Vec2 off = world.wrap().shortest(last.anchorAfter, now);
    const double speeds =
        std::sqrt(velocity.dot(velocity)) + std::sqrt(last.platformVelocity.dot(last.platformVelocity));
    return std::sqrt(off.dot(off)) <= speeds * motion.dt + settings.skin;
}

bool carries(const World& world, const CastHit& floor, const SlideSettings& settings) {
    if (settings.motionMode == MotionMode::Floating) return false;
    if (settings.platformFloorLayers == ~std::uint64_t{0}) return true;
    if (!world.contains(floor.shape)) return false;
    return (world.shape(floor.shape).filter().category & settings.platformFloorLayers) != 0;
}

bool carry(SlideRun& run, const Slide& last, bool moved) {
    const BodyId carrier = last.floor->shape.body;
    const BodyView body = std::as_const(run.world).body(carrier);
    const Vec2 anchor = moved ? run.position : nearTo(run.world, body.pose() * last.anchor, run.position);
    run.carry = body.velocityAt(run.position);
    const Vec2 shift = afterStep(run, carrier, anchor) - run.position;
    const double none = 10 * rounding * (1 + magnitudeOf(run.world, run.position));
    run.probe.pass(carrier);
    const bool arrived = shift.cwiseAbs().maxCoeff() < none || moveByCarrier(run, shift);
    const bool turns = body.angularVelocity() != 0 || body.type() == BodyType::Dynamic;
    if (turns)
        run.position += run.up() * run.probe.freePath(run.position, run.up() * run.settings.floorSnapLength).length;
    run.probe.pass(std::nullopt);
    if (turns) snapToFloor(run, 2 * run.settings.floorSnapLength);
    return arrived;
}

Vec2 leaveVelocity(const SlideRun& run) {
    if (run.settings.platformOnLeave == PlatformOnLeave::DoNothing) return {0, 0};
    const double rise = run.carry.dot(run.up());
    const bool upOnly = run.settings.platformOnLeave == PlatformOnLeave::AddUpwardVelocity;
    return upOnly && rise < 0 ? Vec2(run.carry - run.up() * rise) : run.carry;
}

void storeAnchor(SlideRun& run, const Slide& last, bool kept) {
    if (!run.out.floor) return;
    const BodyId carrier = run.out.floor->shape.body;
    const Vec2 now = beforeStep(run, carrier, run.position);
    const bool same = kept && last.floor && last.floor->shape.body == carrier;
    const Transform pose = std::as_const(run.world).body(carrier).pose();
    run.out.anchor = same ? last.anchor : Vec2(pose.inverse() * nearTo(run.world, now, pose.position));
    run.out.anchorAfter = same ? afterStep(run, carrier, nearTo(run.world, pose * last.anchor, now)) : run.position;
}

bool isStill(const SlideRun& run, const Vec2& here, bool kept) {
    const bool onCrate =
        kept && run.out.floor && std::as_const(run.world).body(run.out.floor->shape.body).type() == BodyType::Dynamic;
    const double moved = (run.position - here).cwiseAbs().maxCoeff();
    return moved < (onCrate ? 0.1 * run.settings.skin : 1e-15 * (1 + here.cwiseAbs().maxCoeff()));
}

}  // namespace plumb::detail
