// SPDX-License-Identifier: MIT
#include <plumb/dynamics/islands/driven.h>

#include <cmath>

#include <plumb/dynamics/joints/joint_store.h>

namespace plumb {

namespace {

/// A drive that moves a body at this share of sleepSpeed runs, even if it is slow for its target [-]. What presses
/// against a wall is slower: its jitter is below a hundredth.
constexpr double runningShare = 0.05;

}  // namespace

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
