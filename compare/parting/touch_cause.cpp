// SPDX-License-Identifier: MIT
#include <compare/parting/touch_cause.h>

#include <algorithm>
#include <cmath>

namespace plumb::compare {
namespace {

constexpr std::size_t steps = 2;      // over which a hit is seen: engines may see it a step apart
constexpr double leastBounce = 0.05;  // two coefficients of restitution that differ by more are told [-]
constexpr double suddenSpeed = 0.05;  // what changes a speed by more in a step than gravity could is sudden [m/s]
constexpr double timesGravity = 1.5;  // likewise, in steps of gravity

/// A run around a touch.
struct Seen {
    double approach = 0, leaving = 0;  ///< towards the other along the normal, before, and away from it after [m/s]
    double across = 0, along = 0;      ///< the change of the body's speed along the normal and along the surface [m/s]
    double before = 0, after = 0;      ///< the body's speed [m/s]
    double alongBefore = 0, alongAfter = 0;  ///< its speed along the surface [m/s]
    Vec2 from{0, 0}, to{0, 0};               ///< its centre, before and after [m]
};

class TouchCause {
public:
    TouchCause(const Parted& parted, const Share& share, const Touching& touching)
        : parted_(parted), share_(share), touching_(touching), a_(seenIn(parted.a)), b_(seenIn(parted.b)) {}

    Difference kind() const {
        const double window = static_cast<double>(steps + 2) * parted_.a.dt;
        const double sudden = timesGravity * parted_.scene.gravity.norm() * window + suddenSpeed;
        if (share_.agent == Agent::Along) {
            const double most = std::max(std::abs(a_.along), std::abs(b_.along));
            if (most < sudden) return Difference::Sliding;
            const double across = std::max(std::abs(a_.across), std::abs(b_.across));
            return across < most / 2 ? Difference::Snag : Difference::Hit;
        }
        if (std::max(std::abs(a_.across), std::abs(b_.across)) < sudden) return Difference::Pressing;
        if (isPassed(a_, b_) || isPassed(b_, a_)) return Difference::Passed;
        const bool isHit = a_.approach > suddenSpeed && b_.approach > suddenSpeed;
        return isHit && std::abs(bounceOf(a_) - bounceOf(b_)) > leastBounce ? Difference::Bounce : Difference::Hit;
    }

    void add(Parting& parting) const {
        parting.quantity = kind();
        parting.at = nameOf(parted_.body) + ", " + nameOf(share_.other);
        parting.when = static_cast<double>(share_.tick) * parted_.a.dt;
        const auto [a, b] = values(parting.quantity);
        parting.valueA = a;
        parting.valueB = b;
    }

private:
    const std::string& nameOf(std::size_t body) const { return parted_.scene.bodies[body].name; }

    Seen seenIn(const Observation& run) const {
        const std::size_t before = share_.tick > 0 ? share_.tick - 1 : 0;
        const std::size_t last = std::min(parted_.a.states.size(), parted_.b.states.size()) - 1;
        const std::size_t after = std::min(share_.tick + steps, last);
        const auto& own = run.states;
        const Vec2 velocity = own[before][parted_.body].velocity, then = own[after][parted_.body].velocity;
        const Vec2 along = perp(share_.normal);
        const auto relative = [&](std::size_t tick) {
            return (own[tick][parted_.body].velocity - own[tick][share_.other].velocity).dot(share_.normal);
        };
        const Vec2 fell = parted_.scene.gravity * (static_cast<double>(after - before) * run.dt);
        Seen seen{.approach = relative(before), .leaving = -relative(after)};
        seen.across = (then - velocity - fell).dot(share_.normal);
        seen.along = (then - velocity - fell).dot(along);
        seen.before = velocity.norm();
        seen.after = then.norm();
        seen.alongBefore = velocity.dot(along);
        seen.alongAfter = then.dot(along);
        seen.from = centerIn(parted_, run, before);
        seen.to = centerIn(parted_, run, after);
        return seen;
    }

    static double bounceOf(const Seen& seen) { return seen.approach > 0 ? seen.leaving / seen.approach : 0; }

    /// The first is not turned back by what turns the second back, and comes out of it on the other side or is in it.
    bool isPassed(const Seen& through, const Seen& back) const {
        if (std::abs(through.across) > std::abs(back.across) / 2) return false;
        const Observation& run = &through == &a_ ? parted_.a : parted_.b;
        const std::vector<BodyState>& states = run.states[share_.tick];
        return touching_.isCrossed(share_.other, parted_.body, states, through.from, through.to) &&
               !touching_.isCrossed(share_.other, parted_.body, states, back.from, back.to);
    }

    std::pair<double, double> values(Difference quantity) const {
        switch (quantity) {
            case Difference::Bounce: return {bounceOf(a_), bounceOf(b_)};
            case Difference::Snag:
                return {std::abs(a_.alongBefore) - std::abs(a_.alongAfter),
                        std::abs(b_.alongBefore) - std::abs(b_.alongAfter)};
            case Difference::Hit: return {a_.after, b_.after};
            case Difference::Passed: return {isPassed(a_, b_) ? 1 : 0, isPassed(b_, a_) ? 1 : 0};
            default: break;
        }
        const auto speed = [&](const Observation& run) {
            return run.states[parted_.tick][parted_.body].velocity.norm();
        };
        return {speed(parted_.a), speed(parted_.b)};
    }

    const Parted& parted_;
    const Share& share_;
    const Touching& touching_;
    Seen a_, b_;
};

}  // namespace

void addTouchCause(const Parted& parted, const Share& share, const Touching& touching, Parting& parting) {
    TouchCause(parted, share, touching).add(parting);
}

}  // namespace plumb::compare
