// SPDX-License-Identifier: MIT
// With which masses do contacts see the bodies of a batch, and how do joints answer to their impulses?
#include <algorithm>
#include <cmath>

#include <plumb/dynamics/joints/joint_batch.h>
#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

bool JointBatch::isHeavy(const BodyStore& bodies, std::size_t lane) const {
    constexpr double heavy = 30;
    double mass = 0, lightest = unlimited;
    for (const BodyIndex body : islands_[lane]->bodies) {
        mass += bodies.record[body].mass;
        if (bodies.links[body].solverContacts > 0) lightest = std::min(lightest, bodies.record[body].mass);
    }
    return islands_[lane]->held.empty() ? mass > heavy * lightest : lightest < unlimited;
}

void JointBatch::findContactBodies(const BodyStore& bodies, bool first, std::vector<ContactBody>& found) {
    if (!first && !layout_->someFree) return;
    Lanes heavy{};
    for (std::size_t lane = 0; lane < width_; ++lane) heavy[lane] = isHeavy(bodies, lane) ? 1 : 0;
    if (heavy == Lanes{}) return;
    active_ = borne_;
    kernel_->respond(view_);
    for (std::size_t lane = 0; lane < width_; ++lane)
        if (heavy[lane] != 0) addContactBodies(found, bodies, lane);
}

void JointBatch::addContactBodies(std::vector<ContactBody>& found, const BodyStore& bodies, std::size_t lane) {
    constexpr double share = 0.25, least = 1e-6;
    const auto linear = [&](std::size_t n) {
        return body(n, BodyField::Response, lane) * body(n, BodyField::OwnMass, lane);
    };
    const auto turning = [&](std::size_t n) {
        return body(n, BodyField::TurnResponse, lane) * body(n, BodyField::Inertia, lane);
    };
    const auto isHeld = [&](std::size_t n) {
        return bodies.links[islands_[lane]->bodies[n]].solverContacts > 0 && std::min(linear(n), turning(n)) < share;
    };
    double count = 0;
    for (std::size_t n = 0; n < layout_->moved; ++n) count += isHeld(n) ? 1 : 0;
    count = std::max(1.0, count);
    for (std::size_t n = 0; n < layout_->moved; ++n) {
        double mass = body(n, BodyField::OwnMass, lane), inertia = body(n, BodyField::Inertia, lane);
        if (isHeld(n)) {
            mass /= std::clamp(count * linear(n), least, 1.0);
            inertia /= std::clamp(count * turning(n), least, 1.0);
        }
        if (mass == body(n, BodyField::ContactMass, lane) && inertia == body(n, BodyField::ContactInertia, lane))
            continue;
        body(n, BodyField::ContactMass, lane) = mass;
        body(n, BodyField::ContactInertia, lane) = inertia;
        found.push_back({islands_[lane]->bodies[n], mass, inertia});
    }
}

}  // namespace plumb
