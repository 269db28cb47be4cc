// SPDX-License-Identifier: MIT
// Which closed forms, and which laws of steering, does JavaScript have?
#pragma once
#include <plumb/ballistics/apex.h>
#include <plumb/ballistics/beam.h>
#include <plumb/ballistics/fixed_angle.h>
#include <plumb/ballistics/fixed_speed.h>
#include <plumb/ballistics/fixed_time.h>
#include <plumb/ballistics/least_speed.h>
#include <plumb/ballistics/linear_drag_aim.h>
#include <plumb/ballistics/moving_target.h>
#include <plumb/ballistics/obstacle.h>
#include <plumb/ballistics/quadratic_drag_aim.h>
#include <plumb/ballistics/quadratic_drag_flight.h>
#include <plumb/ballistics/range.h>
#include <plumb/impact/bounce.h>
#include <plumb/impact/discs.h>
#include <plumb/impact/particles.h>
#include <plumb/impact/rolling.h>
#include <plumb/kinematics/circular.h>
#include <plumb/kinematics/constant_acceleration.h>
#include <plumb/kinematics/linear_drag.h>
#include <plumb/kinematics/oscillation.h>
#include <plumb/kinematics/pendulum.h>
#include <plumb/steering/avoid.h>
#include <plumb/steering/blend.h>
#include <plumb/steering/flock.h>
#include <plumb/steering/path.h>
#include <plumb/steering/pursue.h>
#include <plumb/steering/seek.h>
#include <plumb/steering/wander.h>
#include <web/module/call.h>

namespace plumb::web {

void listBallisticsCalls(auto&& list) {
    list("", "aim", "problem", fn<&aim>);
    list("", "aimAtAngle", "problem", fn<&aimAtAngle>);
    list("", "aimAtMoving", "problem", fn<&aimAtMoving>);
    list("", "aimBeam", "problem", fn<&aimBeam>);
    list("", "aimByApex", "problem", fn<&aimByApex>);
    list("", "aimInTime", "problem", fn<&aimInTime>);
    list("", "aimOver", "problem", fn<&aimOver>);
    list("", "aimSlowest", "problem", fn<&aimSlowest>);
    list("", "aimSlowestOver", "problem", fn<&aimSlowestOver>);
    list("", "aimThroughLinearDrag", "problem", fn<&aimThroughLinearDrag>);
    list("", "aimThroughLinearDragInTime", "problem", fn<&aimThroughLinearDragInTime>);
    list("", "aimThroughQuadraticDrag", "problem", fn<&aimThroughQuadraticDrag>);
    list("", "apexOf", "launch", fn<&apexOf>);
    list("", "landingOf", "launch", fn<&landingOf>);
    list("", "greatestRange", "problem", fn<&greatestRange>);
    list("", "linearDragApex", "velocity, drag", fn<&linearDragApex>);
    list("", "linearDragLanding", "velocity, height, drag", fn<&linearDragLanding>);
    list("", "quadraticDragApex", "velocity, drag", fn<&quadraticDragApex>);
    list("", "quadraticDragFlight", "velocity, time, drag", fn<&quadraticDragFlight>);
    list("", "quadraticDragLanding", "velocity, height, drag", fn<&quadraticDragLanding>);
    list("", "shootUp", "speed, drag", fn<&shootUp>);
    list("", "fallFor", "time, drag", fn<&fallFor>);
}

void listKinematicsCalls(auto&& list) {
    list("", "solveMotion", "known, times = notNegative",
         fn<[](const KnownMotion& known, MotionTimes times) { return solveMotion(known, times); }>);
    list("", "solvePlaneMotion", "known", fn<[](const KnownPlaneMotion& known) { return solveMotion(known); }>);
    list("", "moveAccelerated", "from, acceleration, time", fn<&moveAccelerated>);
    list("", "moveWithDrag", "from, law, time", fn<&moveWithDrag>);
    list("", "circularAt", "motion, time", fn<&circularAt>);
    list("", "harmonicAt", "motion, time", fn<&harmonicAt>);
    list("", "oscillatorOf", "mass, stiffness, damping", fn<&oscillatorOf>);
    list("", "dampedPeriod", "oscillator", fn<&dampedPeriod>);
    list("", "oscillate", "from, rest, oscillator, time",
         fn<[](const AxisMotion& from, double rest, const Oscillator& oscillator, double time) {
             return oscillate(from, rest, oscillator, time);
         }>);
    list("", "pendulumPeriod", "pendulum, amplitude = 0", fn<&pendulumPeriod>);
    list("", "springOf", "frequency, dampingRatio, mass", fn<&springOf>);
    list("", "bouncesToRest", "ball", fn<&bouncesToRest>);
    list("", "bounceTime", "ball, n", fn<&bounceTime>);
    list("", "bounceHeight", "ball, n", fn<&bounceHeight>);
    list("", "collideDiscs", "a, b, law", fn<&collideDiscs>);
    list("", "collideWithWall", "disc, wall, law", fn<&collideWithWall>);
    list("", "collideParticles", "a, b, normal, law?", fn<&collideParticles>);
    list("", "bounceOffWall", "velocity, normal, law?", fn<&bounceOffWall>);
    list("", "collideInLine", "a, b, restitution = 1", fn<&collideInLine>);
    list("", "slideToRoll", "disc", fn<&slideToRoll>);
    list("", "rollDown", "incline", fn<&rollDown>);
    list("", "frictionToRoll", "angle, inertiaRatio", fn<&frictionToRoll>);
}

void listSteeringCalls(auto&& list) {
    list("", "seek", "agent, target", fn<&seek>);
    list("", "flee", "agent, threat", fn<&flee>);
    list("", "arrive", "agent, target, slowingDistance?", fn<&arrive>);
    list("", "slowingDistanceOf", "agent", fn<&slowingDistanceOf>);
    list("", "pursue", "agent, quarry, mostAhead = 5", fn<&pursue>);
    list("", "evade", "agent, pursuer, mostAhead = 5", fn<&evade>);
    list("", "wander", "agent, state, dt, settings?", fn<&wander>);
    list("", "followPath", "agent, path, progress, ahead", fn<&followPath>);
    list("", "lengthOf", "path", fn<[](const Path& path) { return lengthOf(path); }>);
    list("", "pointOn", "path, along", fn<&pointOn>);
    list("", "avoidObstacles", "agent, obstacles, clearance = 0.2", fn<&avoidObstacles>);
    list("", "avoidWalls", "agent, walls, clearance = 0.2", fn<&avoidWalls>);
    list("", "separate", "agent, others, neighborhood?", fn<&separate>);
    list("", "align", "agent, others, neighborhood?", fn<&align>);
    list("", "cohere", "agent, others, neighborhood?", fn<&cohere>);
    list("", "steerByWeight", "agent, requests", fn<&steerByWeight>);
    list("", "steerByBudget", "agent, requests", fn<&steerByBudget>);
    list("", "steerByPriority", "agent, requests", fn<&steerByPriority>);
    list("", "steerTo", "agent, wantedVelocity", fn<&steerTo>);
    list("", "headingOf", "agent", fn<&headingOf>);
    list("", "moved", "agent, acceleration, dt", fn<&moved>);
}

}  // namespace plumb::web
