// SPDX-License-Identifier: MIT
#include <compare/parting/account.h>

#include <algorithm>
#include <cmath>

#include <compare/metric/mechanics.h>

namespace plumb::compare {
namespace {

constexpr double leastShare = 1e-5;  // part of the distance, in one step; less is rounding

/// One run's change of velocity in a step, and the contact that may have caused it.
struct Change {
    Vec2 velocity{0, 0};
    std::optional<Touch> touch{};
};

class Account {
public:
    Account(const Parted& parted, const JointStates& joints, const Touching& touching)
        : parted_(parted), touching_(touching) {
        isHeld_ = std::ranges::any_of(joints.joints(), [&](const JointGeometry& joint) {
            return joint.bodyA == parted.body || joint.bodyB == parted.body;
        });
        distance_ = parted.offset.norm();
        direction_ = parted.offset / distance_;
    }

    std::vector<Share> shares() {
        for (std::size_t tick = 0; tick < parted_.tick; ++tick) addStep(tick);
        forgetLateness();
        std::ranges::stable_sort(shares_, std::ranges::greater{}, &Share::length);
        return std::move(shares_);
    }

private:
    Vec2 apartAt(std::size_t tick) const {
        return parted_.scene.wrap.shortest(centerIn(parted_, parted_.b, tick), centerIn(parted_, parted_.a, tick));
    }

    const BodyState& stateOf(const Observation& run, std::size_t tick) const { return run.states[tick][parted_.body]; }

    Vec2 velocityApart(std::size_t tick) const {
        return stateOf(parted_.a, tick).velocity - stateOf(parted_.b, tick).velocity;
    }

    Change changeIn(const Observation& run, std::size_t tick) const {
        const Vec2 velocity = stateOf(run, tick + 1).velocity - stateOf(run, tick).velocity;
        return {velocity, touching_.nearest(parted_.body, run.states[tick], run.states[tick + 1], run.dt)};
    }

    void addStep(std::size_t tick) {
        const double dt = parted_.a.dt;
        const double left = static_cast<double>(parted_.tick - tick) * dt;
        const Vec2 changed = velocityApart(tick + 1) - velocityApart(tick);
        const Vec2 moved = apartAt(tick + 1) - apartAt(tick) - velocityApart(tick + 1) * dt;
        const double byVelocity = changed.dot(direction_) * left, byPlace = moved.dot(direction_);
        if (std::abs(byVelocity) + std::abs(byPlace) < leastShare * distance_) return;
        const Change a = changeIn(parted_.a, tick), b = changeIn(parted_.b, tick);
        const bool fromA = a.touch && (!b.touch || a.velocity.norm() >= b.velocity.norm());
        const std::optional<Touch>& touch = fromA ? a.touch : b.touch;
        if (!touch) {
            shareFor(isHeld_ ? Agent::Joints : Agent::Nothing, {}, byVelocity, tick);
            shareFor(Agent::Steps, {}, byPlace, tick);
            return;
        }
        const double normal = touch->normal.dot(direction_);
        const double across = changed.dot(touch->normal) * normal * left, pushed = moved.dot(touch->normal) * normal;
        shareFor(Agent::Across, touch, across + pushed, tick);
        shareFor(Agent::Along, touch, byVelocity - across, tick);
        shareFor(Agent::Steps, {}, byPlace - pushed, tick);
    }

    /// Who is late on the path is not off it: this part of what the steps did is no part of the distance.
    void forgetLateness() {
        const auto steps = std::ranges::find(shares_, Agent::Steps, &Share::agent);
        if (steps == shares_.end()) return;
        const double late = (apartAt(parted_.tick) - parted_.offset).dot(direction_);
        steps->length -= std::clamp(late, std::min(0.0, steps->length), std::max(0.0, steps->length));
    }

    void shareFor(Agent agent, const std::optional<Touch>& touch, double length, std::size_t tick) {
        const std::size_t other = touch ? touch->other : 0;
        const auto isIt = [&](const Share& share) { return share.agent == agent && share.other == other; };
        auto share = std::ranges::find_if(shares_, isIt);
        if (share == shares_.end()) share = shares_.insert(shares_.end(), {.agent = agent, .other = other});
        share->length += length;
        if (length <= share->largest) return;
        share->largest = length;
        share->tick = tick;
        if (touch) share->normal = touch->normal;
    }

    const Parted& parted_;
    const Touching& touching_;
    bool isHeld_ = false;
    double distance_ = 0;
    Vec2 direction_{1, 0};
    std::vector<Share> shares_;
};

}  // namespace

Vec2 centerIn(const Parted& parted, const Observation& run, std::size_t tick) {
    const BodyDef& def = parted.scene.bodies[parted.body].def;
    const BodyState& state = run.states[tick][parted.body];
    return def.type == BodyType::Dynamic ? centerOf(state, massOf(def)) : state.position;
}

std::vector<Share> sharesOf(const Parted& parted, const JointStates& joints, const Touching& touching) {
    return Account(parted, joints, touching).shares();
}

}  // namespace plumb::compare
