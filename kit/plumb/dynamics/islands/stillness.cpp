// SPDX-License-Identifier: MIT
#include <plumb/dynamics/islands/stillness.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/islands/neighbours.h>

namespace plumb {

namespace {

/// The number of parts of a watch, each with its mean speed [-]. More parts are shorter, and jitter shows more. Five
/// are 0.1 s each with the default sleepTime: whole numbers of steps at 30, 60 and 120 Hz.
constexpr double partsOfWatch = 5;
/// A mean speed that has risen by less than this share of sleepSpeed has not risen [-].
constexpr double leastGain = 1e-3;
/// Places are exact to this share of a body's size: less is no motion [-].
constexpr double noise = 5e-6;
/// Of the speed that a body has gained, it must lose all but this share to count as still [-].
constexpr double shareKept = 0.1;
/// A drive that moves a body at this share of sleepSpeed runs, even if it is slow for its target [-]. What presses
/// against a wall is slower: its jitter is below a hundredth.
constexpr double runningShare = 0.05;

/// Does no body that can move touch the body, and is none joined to it?
bool isAlone(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints, BodyIndex body) {
    return !anyNeighbour(bodies, contacts, joints, body, [](BodyIndex) { return true; });
}

/// Does the body hang from joints alone, without springs or damping?
bool swings(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints, BodyIndex body) {
    const BodyRecord& record = bodies.record[body];
    for (const JointIndex joint : bodies.links[body].joints)
        if (joints.hasSpring(joint)) return false;
    return !bodies.links[body].joints.empty() && bodies.links[body].solverContacts == 0 && record.linearDamping == 0 &&
           record.angularDamping == 0 && isAlone(bodies, contacts, joints, body);
}

/// Of the body's farthest point, not of its centre: a long plank that turns slowly moves fast at its ends.
bool isSlow(const BodyStore& bodies, const SolverSettings& settings, BodyIndex body) {
    const BodyRecord& record = bodies.record[body];
    const BodyMotion& motion = bodies.motion[body];
    const double speed = motion.velocity.norm() + std::fabs(motion.angularVelocity) * record.boundingRadius;
    // A body without contacts or joints drifts on, however slowly; only a body that the solver moves may be stopped.
    if (!bodies.isMovedBy(body, MovedBy::Solver)) return speed == 0;
    // A body that position correction pushes has no velocity from that, but it moves.
    const SolverDisplacement& moved = bodies.displacement[body];
    const double shift = static_cast<double>(std::sqrt(moved.x * moved.x + moved.y * moved.y));
    return std::max(speed, shift / bodies.lastStep) < settings.sleepSpeed;
}

/// Begins a part of the watch.
void startPart(StillWatch& watch, const BodyMotion& motion) {
    watch.center = motion.center;
    watch.angle = motion.angle;
    watch.time = 0;
}

/// Goes on with the watch of a slow body. Returns whether its mean speed has risen, and it has not lost it again.
/// alone(): in a heap, bodies push each other about, and none speeds up by itself. Asked at the end of a part.
template <class Alone>
bool hasGained(StillWatch& watch, const BodyMotion& motion, double radius, const SolverSettings& settings, double dt,
               const Alone& alone) {
    watch.time += dt;
    // Half a step less, so that rounding of the sum does not make a part one step longer.
    if (watch.time + 0.5 * dt < settings.sleepTime / partsOfWatch) return watch.gained > 0;
    const double turned = std::fabs(motion.angle - watch.angle) * radius;
    const double speed = ((motion.center - watch.center).norm() + turned) / watch.time;
    // From the lowest mean speed on, a rise by gain counts; it is forgotten when the body has lost nine tenths of it,
    // as at the end of a damped swing.
    watch.least = std::min(watch.least, speed);
    const double gain = leastGain * settings.sleepSpeed + noise * radius / watch.time;
    if (speed > watch.least + gain) watch.gained = std::max(watch.gained, speed);
    if (watch.gained > 0 && !alone()) watch.gained = 0;
    if (speed < shareKept * watch.gained) {
        watch.gained = 0;
        watch.least = speed;
    }
    startPart(watch, motion);
    return watch.gained > 0;
}

}  // namespace

bool countStillness(BodyStore& bodies, const ContactStore& contacts, const JointStore& joints,
                    const SolverSettings& settings, double dt) {
    // One look shows no rest, however long the step: a stone at the top of its way is still, too. To see that a body
    // gains speed takes three.
    const double counted = std::min(dt, 0.25 * settings.sleepTime);
    bool anyReady = false;
    for (const BodyIndex body : bodies.awake) {
        BodyRecord& record = bodies.record[body];
        if (record.type != BodyType::Dynamic) continue;
        if (!record.canSleep || !isSlow(bodies, settings, body)) {
            record.stillTime = 0;
            continue;
        }
        StillWatch& watch = bodies.watch[body];
        if (record.stillTime == 0) {
            watch = {};
            startPart(watch, bodies.motion[body]);
            record.stillTime = counted;
            const double speed = bodies.motion[body].velocity.norm();
            if (speed > 0.5 * settings.sleepSpeed && swings(bodies, contacts, joints, body)) watch.gained = speed;
        } else {
            const auto alone = [&] { return isAlone(bodies, contacts, joints, body); };
            const bool gained = hasGained(watch, bodies.motion[body], record.boundingRadius, settings, dt, alone);
            record.stillTime = gained ? counted : record.stillTime + counted;
        }
        anyReady = anyReady || record.stillTime >= settings.sleepTime;
    }
    return anyReady;
}

bool isCarried(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints, BodyIndex body) {
    const auto carries = [&bodies](BodyIndex other) {
        return bodies.record[other].type == BodyType::Kinematic && bodies.record[other].awake;
    };
    bool carried = anyContact(bodies, contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = contacts[index];
        return contact.touching && carries(otherOf(contact, body));
    });
    for (const JointIndex joint : bodies.links[body].joints)
        forEachBody(joints, joint, [&](BodyIndex end) { carried = carried || carries(end); });
    return carried;
}

bool isDriven(const BodyStore& bodies, const ContactStore& contacts, const JointStore& joints,
              const SolverSettings& settings, BodyIndex body) {
    const double enough = runningShare * settings.sleepSpeed;
    const BodyMotion& motion = bodies.motion[body];
    const double speed =
        motion.velocity.norm() + std::fabs(motion.angularVelocity) * bodies.record[body].boundingRadius;
    bool driven = anyContact(bodies, contacts, body, [&](ContactIndex index) {
        const ContactRecord& contact = contacts[index];
        const bool belt = contact.touching && contact.friction > 0;
        return belt && follows(speed, std::fabs(static_cast<double>(contact.surfaceSpeed)), enough);
    });
    for (const JointIndex joint : bodies.links[body].joints)
        driven = driven || isMotorRunning(joints, bodies, joint, enough);
    return driven;
}

}  // namespace plumb
