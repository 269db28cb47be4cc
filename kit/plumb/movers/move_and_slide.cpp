// SPDX-License-Identifier: MIT
#include <plumb/movers/move_and_slide.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <plumb/math/check.h>
#include <plumb/math/trig.h>
#include <plumb/movers/detail/slide_carry.h>
#include <plumb/movers/detail/slide_probe.h>
#include <plumb/movers/detail/slide_run.h>

namespace plumb {

namespace {

using detail::SlideRun;

constexpr double halfTurnQuarter = 1.5707963267948966;  // pi / 2

void require(const World& world, BodyId body, const SlideMotion& motion) {
    const BodyView view = world.body(body);
    if (view.type() != BodyType::Kinematic) refuse("moveAndSlide: body", "is not kinematic: set its type to Kinematic");
    requireFinite(motion.velocity, "SlideMotion", ".velocity");
    requirePositive(motion.dt, "SlideMotion", ".dt");
    requireFinite(Vec2(motion.velocity * motion.dt), "SlideMotion.velocity, times dt");
    if (motion.displacement) requireFinite(*motion.displacement, "SlideMotion", ".displacement");
}

SlideSettings withUnitUp(SlideSettings settings) {
    settings.up /= std::sqrt(settings.up.dot(settings.up));
    return settings;
}

/// Passes the one-way floor it stands on, and, until it is inside of that, the floors level with it along its motion.
void drop(SlideRun& run, const SlideMotion& motion, const Slide& last, const Vec2& wanted) {
    run.out.hasEntered = last.hasEntered && !motion.dropThrough;
    if (!motion.dropThrough && last.dropping.empty()) return;
    for (const OneWayFloor& floor : last.dropping) run.probe.passFloor(floor);
    if (motion.dropThrough && last.floor && last.floor->oneWay)
        run.probe.passFloor({last.floor->shape, last.floor->tile});
    if (!run.out.hasEntered) run.probe.passFloorsUnder(run.position, run.right() * wanted.dot(run.right()));
    run.out.dropping = run.probe.passedFloors();
}

/// The drop ends when it stands on a floor, or has been inside of a passed floor and is out again.
void endDrop(SlideRun& run) {
    if (run.out.dropping.empty()) return;
    const bool isIn = run.probe.isInPassedFloor(run.position);
    if (run.out.isOnFloor || (run.out.hasEntered && !isIn)) run.out.dropping.clear();
    run.out.hasEntered = !run.out.dropping.empty() && (run.out.hasEntered || isIn);
}

/// Moves along the floor, or through the air. Returns the wanted distance along the floor.
double moveSelf(SlideRun& run, const Vec2& wanted, bool grounded) {
    if (!grounded) {
        detail::fly(run, wanted);
        return 0;
    }
    const double horizontal = wanted.dot(run.right());
    const bool slips = !run.settings.floorStopOnSlope && run.out.floorNormal.dot(run.up()) < 1 - 1e-12;
    if (slips) {
        const Vec2 along = run.alongFloor(run.out.floorNormal, 1);
        const double distance = wanted.dot(along);
        detail::walk(run, std::fabs(distance), distance < 0 ? -1 : 1);
        return distance;
    }
    detail::walk(run, std::fabs(horizontal), horizontal < 0 ? -1 : 1);
    return horizontal;
}

/// Is it on a floor at the end, and on which?
void findFloor(SlideRun& run, bool grounded, double horizontal) {
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
    if (detail::snapToFloor(run, reach, std::fabs(horizontal)) || wedged) {
        run.out.isOnFloor = true;
        return;
    }
    run.out.floor.reset();
}

/// The remaining velocity, relative to the floor or to the world.
void finishVelocity(SlideRun& run, bool grounded) {
    run.out.platformVelocity = run.carry;
    if (run.out.isOnFloor) {
        const BodyView body = std::as_const(run.world).body(run.out.floor->shape.body);
        const bool goes = detail::carries(run.world, *run.out.floor, run.settings);
        const Vec2 ground = goes ? body.velocityAt(run.position) : Vec2(0, 0);
        // After landing it keeps its speed, converted to the floor's frame.
        if (!grounded && run.settings.platformOnLeave != PlatformOnLeave::DoNothing) run.velocity += run.carry - ground;
        run.out.platformVelocity = ground;
        run.out.velocity = run.right() * run.velocity.dot(run.right());
        run.out.floorAngle =
            arcTangent(std::fabs(cross(run.out.floorNormal, run.up())), run.out.floorNormal.dot(run.up()));
    } else {
        run.out.velocity = run.velocity + detail::leaveVelocity(run);
    }
}

void applyWeight(SlideRun& run) {
    if (!run.out.isOnFloor || !(run.settings.weight > 0)) return;
    Body body = run.world.body(run.out.floor->shape.body);
    if (body.type() != BodyType::Dynamic) return;
    body.applyForce(run.up() * -run.settings.weight, run.position);
}

/// A map that is touched without having been hit in this tick is known from the tick in which it was hit.
void findHazards(SlideRun& run, const Slide& last) {
    for (const TileTouch& touch : last.hazards) run.probe.addHitMap(touch.shape);
    run.waypoints.push_back(run.position);
    if (!run.probe.hitMaps().empty()) run.out.hazards = detail::hazardsOn(run.probe, run.waypoints);
}

}  // namespace

void validate(const SlideSettings& settings, const std::string& field) {
    requireFinite(settings.up, field, ".up");
    if (!(settings.up.cwiseAbs().maxCoeff() > 0)) refuse(field + ".up", "(0, 0) is no direction");
    requireWithin(settings.maxFloorAngle, 0, halfTurnQuarter - 0.01, field, ".maxFloorAngle");
    requireNotNegative(settings.floorSnapLength, field, ".floorSnapLength");
    requireWithin(settings.wallMinSlideAngle, 0, halfTurnQuarter, field, ".wallMinSlideAngle");
    requireNotNegative(settings.stepHeight, field, ".stepHeight");
    requireNotNegative(settings.cornerCorrection, field, ".cornerCorrection");
    requireNotNegative(settings.ledgeNudge, field, ".ledgeNudge");
    requireNotNegative(settings.pushStrength, field, ".pushStrength");
    requireNotNegative(settings.weight, field, ".weight");
    requirePositive(settings.skin, field, ".skin");
    requireWithin(settings.maxSlides, 1, 1000, field, ".maxSlides");
    requireNotNegative(settings.reach, field, ".reach");
}

Slide moveAndSlide(World& world, BodyId body, const SlideMotion& motion, const SlideSettings& given,
                   const Slide& last) {
    require(world, body, motion);
    validate(given, "SlideSettings");
    const SlideSettings settings = withUnitUp(given);
    const Vec2 here = world.body(body).position();
    const auto [start, jumped] = detail::startOf(world, body, last);
    const Vec2 wanted = motion.displacement ? *motion.displacement : Vec2(motion.velocity * motion.dt);
    SlideRun run{world,
                 settings,
                 {world, body, settings, motion.dt},
                 motion.dt,
                 start,
                 motion.velocity,
                 {0, 0},
                 settings.pushStrength * motion.dt,
                 detail::leastFloorRise(settings, start),
                 {}};
    const bool rides =
        detail::isFloorThere(world, last, motion, settings) && detail::carries(world, *last.floor, settings);
    if (last.isOnFloor && last.floor && !world.contains(last.floor->shape.body)) run.carry = last.platformVelocity;
    const bool rises = motion.velocity.dot(settings.up) > 0;
    run.probe.findMoving(settings.reach + wanted.cwiseAbs().maxCoeff(),
                         rides ? std::optional(last.floor->shape.body) : std::nullopt, motion.later);

    const bool grounded = last.isOnFloor && !rises && !motion.dropThrough && !run.floats();
    run.out.floorNormal = last.isOnFloor ? last.floorNormal : settings.up;
    if (rides) run.out.floor = last.floor;
    const bool arrived = rides && detail::carry(run, last, jumped);
    drop(run, motion, last, wanted);
    detail::pushAside(run, start);
    detail::resolveOverlaps(run);
    const bool hindered = !run.out.hits.empty();
    run.waypoints.push_back(run.position);
    const double horizontal = moveSelf(run, wanted, grounded);
    findFloor(run, grounded, horizontal);
    finishVelocity(run, grounded);
    applyWeight(run);
    // Not after a jump, even if it is on the floor again.
    const bool kept = grounded && arrived && !jumped && horizontal == 0 && !hindered;
    detail::storeAnchor(run, last, kept);
    if (detail::isStill(run, here, kept)) run.position = here;
    findHazards(run, last);
    endDrop(run);
    run.out.position = run.position;
    run.out.displacement = run.position - here;
    // Setting a velocity again would wake the bodies nearby.
    const Vec2 velocity = run.out.displacement / motion.dt;
    Body moved = world.body(body);
    if (moved.velocity() != velocity) moved.setVelocity(velocity);
    if (moved.angularVelocity() != 0) moved.setAngularVelocity(0);
    return std::move(run.out);
}

}  // namespace plumb
