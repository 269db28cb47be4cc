// SPDX-License-Identifier: MIT
#include <plumb/movers/move_and_slide.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/math/check.h>
#include <plumb/math/trig.h>
#include <plumb/movers/detail/slide_run.h>

namespace plumb {

namespace {

using detail::MovingThing;
using detail::SlideRun;

constexpr double halfTurnQuarter = 1.5707963267948966;  // pi / 2

void require(const World& world, BodyId body, const SlideMotion& motion) {
    const BodyView view = world.body(body);
    if (view.type() != BodyType::Kinematic) refuse("moveAndSlide: body", "is not kinematic");
    requireFinite(motion.velocity, "SlideMotion", ".velocity");
    requirePositive(motion.dt, "SlideMotion", ".dt");
    requireFinite(Vec2(motion.velocity * motion.dt), "SlideMotion.velocity, times dt");
    if (motion.displacement) requireFinite(*motion.displacement, "SlideMotion", ".displacement");
}

/// In a world that wraps, of the places that a point stands for the one nearest to another.
Vec2 nearTo(const World& world, const Vec2& point, const Vec2& other) {
    return world.wrap().any() ? Vec2(point + world.wrap().shiftNear(point, other)) : point;
}

constexpr double rounding = 1e-14;

/// How large the numbers are that a place comes of [m].
double roundsOf(const World& world, const Vec2& position) {
    return position.cwiseAbs().maxCoeff() + world.wrap().width.value_or(0) + world.wrap().height.value_or(0);
}

SlideSettings withUnitUp(SlideSettings settings) {
    settings.up /= std::sqrt(settings.up.dot(settings.up));
    return settings;
}

struct Start {
    Vec2 position;
    bool jumped;  ///< it is not where the last tick sent it
};

/// Where the world has it, but for a rounding that is not to add up.
Start startOf(const World& world, BodyId body, const Slide& last) {
    const Vec2 position = world.body(body).position(), planned = nearTo(world, last.position, position);
    const bool asPlanned = (position - planned).cwiseAbs().maxCoeff() <= rounding * (1 + roundsOf(world, position));
    return {asPlanned ? planned : position, !asPlanned};
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
        const detail::FreeWay way = run.probe.freeWay(run.position, shift);
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

/// Is what it stood on where its velocity, of this tick or of the last, took it?
bool isFloorThere(const World& world, const Slide& last, const SlideMotion& motion, const SlideSettings& settings) {
    if (!last.isOnFloor || !last.floor || !world.contains(last.floor->shape.body)) return false;
    const BodyView body = world.body(last.floor->shape.body);
    const Vec2 now = body.pose() * last.anchor, velocity = body.velocityAt(now);
    const Vec2 off = world.wrap().way(last.anchorAfter, now);
    const double speeds =
        std::sqrt(velocity.dot(velocity)) + std::sqrt(last.platformVelocity.dot(last.platformVelocity));
    return std::sqrt(off.dot(off)) <= speeds * motion.dt + settings.skin;
}

/// Onto its place on what carries it; false when it cannot get there.
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
    if (turns) detail::settle(run, 2 * run.settings.floorSnapLength);
    return arrived;
}

/// What it stood on gives it on leaving.
Vec2 parting(const SlideRun& run) {
    if (run.settings.platformOnLeave == PlatformOnLeave::DoNothing) return {0, 0};
    const double rise = run.carry.dot(run.up());
    const bool upOnly = run.settings.platformOnLeave == PlatformOnLeave::AddUpwardVelocity;
    return upOnly && rise < 0 ? Vec2(run.carry - run.up() * rise) : run.carry;
}

/// Along the floor, or through the air. Gives how far it wanted to go along the floor.
double goItsOwnWay(SlideRun& run, const Vec2& wanted, bool grounded) {
    if (!grounded) {
        detail::fly(run, wanted);
        return 0;
    }
    const double level = wanted.dot(run.right());
    const bool slips = !run.settings.floorStopOnSlope && run.out.floorNormal.dot(run.up()) < 1 - 1e-12;
    if (slips) {
        const Vec2 along = run.alongFloor(run.out.floorNormal, 1);
        const double way = wanted.dot(along);
        detail::walk(run, std::fabs(way), way < 0 ? -1 : 1);
        return way;
    }
    detail::walk(run, std::fabs(level), level < 0 ? -1 : 1);
    return level;
}

/// Is it on a floor at the end, and on which?
void findFloor(SlideRun& run, bool grounded, double level) {
    const bool rises = run.velocity.dot(run.up()) > 0;
    const bool landed = run.out.isOnFloor && !grounded;
    if (rises || !(grounded || landed)) {
        run.out.isOnFloor = false;
        run.out.floor.reset();
        return;
    }
    const bool wedged = landed && run.out.floorNormal == run.up() && run.along.isZero(0);
    const double reach = run.settings.floorSnapLength + run.settings.stepHeight;
    run.out.isOnFloor = false;
    if (detail::settle(run, reach, std::fabs(level)) || wedged) {
        run.out.isOnFloor = true;
        return;
    }
    run.out.floor.reset();
}

/// The velocity that is left, against the floor or the world.
void finishVelocity(SlideRun& run, bool grounded) {
    run.out.platformVelocity = run.carry;
    if (run.out.isOnFloor) {
        const Vec2 ground = std::as_const(run.world).body(run.out.floor->shape.body).velocityAt(run.position);
        // Who lands runs on as fast as before, seen from what it landed on.
        if (!grounded && run.settings.platformOnLeave != PlatformOnLeave::DoNothing) run.velocity += run.carry - ground;
        run.out.platformVelocity = ground;
        run.out.velocity = run.right() * run.velocity.dot(run.right());
        run.out.floorAngle =
            arcTangent(std::fabs(cross(run.out.floorNormal, run.up())), run.out.floorNormal.dot(run.up()));
    } else {
        run.out.velocity = run.velocity + parting(run);
    }
}

void pressDown(SlideRun& run) {
    if (!run.out.isOnFloor || !(run.settings.weight > 0)) return;
    Body body = run.world.body(run.out.floor->shape.body);
    if (body.type() != BodyType::Dynamic) return;
    body.applyForce(run.up() * -run.settings.weight, run.position);
}

/// The place on the floor: the one that it had, while it does not go anywhere by itself.
void rememberPlace(SlideRun& run, const Slide& last, bool kept) {
    if (!run.out.floor) return;
    const BodyId carrier = run.out.floor->shape.body;
    const Vec2 now = notSoon(run, carrier, run.position);
    const bool same = kept && last.floor && last.floor->shape.body == carrier;
    const Transform pose = std::as_const(run.world).body(carrier).pose();
    run.out.anchor = same ? last.anchor : Vec2(pose.inverse() * nearTo(run.world, now, pose.position));
    run.out.anchorAfter = same ? soon(run, carrier, nearTo(run.world, pose * last.anchor, now)) : run.position;
}

/// What it stands on creeps by roundings, or as crates do that settle: it would wake them by following in each tick.
/// Its place on them is kept, so that it follows when that has added up.
bool isStill(const SlideRun& run, const Vec2& here, bool kept) {
    const bool onCrate =
        kept && run.out.floor && std::as_const(run.world).body(run.out.floor->shape.body).type() == BodyType::Dynamic;
    const double moved = (run.position - here).cwiseAbs().maxCoeff();
    return moved < (onCrate ? 0.1 * run.settings.skin : 1e-15 * (1 + here.cwiseAbs().maxCoeff()));
}

}  // namespace

void validate(const SlideSettings& settings, const std::string& field) {
    requireFinite(settings.up, field, ".up");
    if (!(settings.up.cwiseAbs().maxCoeff() > 0)) refuse(field + ".up", "(0, 0) is no direction");
    requireWithin(settings.maxFloorAngle, 0, halfTurnQuarter - 0.01, field, ".maxFloorAngle");
    requireNotNegative(settings.floorSnapLength, field, ".floorSnapLength");
    requireNotNegative(settings.stepHeight, field, ".stepHeight");
    requireNotNegative(settings.cornerCorrection, field, ".cornerCorrection");
    requireNotNegative(settings.ledgeNudge, field, ".ledgeNudge");
    requireNotNegative(settings.pushStrength, field, ".pushStrength");
    requireNotNegative(settings.weight, field, ".weight");
    requirePositive(settings.skin, field, ".skin");
    requireWithin(settings.maxSlides, 1, 1000, field, ".maxSlides");
    requireNotNegative(settings.reach, field, ".reach");
}

Slide moveAndSlide(World& world, BodyId body, const SlideMotion& motion, const SlideSettings& asked,
                   const Slide& last) {
    require(world, body, motion);
    validate(asked, "SlideSettings");
    const SlideSettings settings = withUnitUp(asked);
    const Vec2 here = world.body(body).position();
    const auto [start, jumped] = startOf(world, body, last);
    const Vec2 wanted = motion.displacement ? *motion.displacement : Vec2(motion.velocity * motion.dt);
    SlideRun run{world,           settings, {world, body, settings, motion.dt}, motion.dt, start,
                 motion.velocity, {0, 0},   settings.pushStrength * motion.dt,  {}};
    const bool rides = isFloorThere(world, last, motion, settings);
    if (last.isOnFloor && last.floor && !world.contains(last.floor->shape.body)) run.carry = last.platformVelocity;
    const bool rises = motion.velocity.dot(settings.up) > 0;
    run.out.dropping = motion.dropThrough || last.dropping;
    run.probe.findMoving(settings.reach + wanted.cwiseAbs().maxCoeff(),
                         rides ? std::optional(last.floor->shape.body) : std::nullopt);
    run.probe.passOneWays(run.out.dropping);

    const bool grounded = last.isOnFloor && !rises && !motion.dropThrough;
    run.out.floorNormal = last.isOnFloor ? last.floorNormal : settings.up;
    if (rides) run.out.floor = last.floor;
    const bool arrived = rides && carry(run, last, jumped);
    detail::pushAside(run, start);
    detail::partOverlaps(run);
    const bool hindered = !run.out.hits.empty();
    const double level = goItsOwnWay(run, wanted, grounded);
    findFloor(run, grounded, level);
    finishVelocity(run, grounded);
    pressDown(run);
    // Not who took off, even if it is on the floor again.
    const bool kept = grounded && arrived && !jumped && level == 0 && !hindered;
    rememberPlace(run, last, kept);
    if (isStill(run, here, kept)) run.position = here;
    // Who stands did not drop, or is through.
    run.out.dropping &= !run.out.isOnFloor && (motion.dropThrough || run.probe.isInOneWay(run.position));
    run.out.position = run.position;
    run.out.displacement = run.position - here;
    // Told anew, a velocity wakes what is near.
    const Vec2 velocity = run.out.displacement / motion.dt;
    Body moved = world.body(body);
    if (moved.velocity() != velocity) moved.setVelocity(velocity);
    if (moved.angularVelocity() != 0) moved.setAngularVelocity(0);
    return std::move(run.out);
}

}  // namespace plumb
