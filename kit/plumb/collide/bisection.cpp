// SPDX-License-Identifier: MIT
#include <plumb/collide/bisection.h>

#include <plumb/collide/detail/sweep_limits.h>
#include <plumb/collide/overlap.h>
#include <plumb/math/check.h>

namespace plumb {

std::optional<CollisionTime> bisectCollision(const std::function<bool(double)>& overlapping, int probes) {
    requireWithin(probes, 0, 52, "bisectCollision.probes");
    if (!overlapping(1)) return std::nullopt;
    if (overlapping(0)) return CollisionTime{};
    CollisionTime time{.apart = 0, .overlapping = 1, .error = 1};
    for (int i = 0; i < probes; ++i) {
        const double middle = 0.5 * (time.apart + time.overlapping);
        time.probes.push_back(middle);
        (overlapping(middle) ? time.overlapping : time.apart) = middle;
        time.error *= 0.5;
    }
    return time;
}

std::optional<CollisionTime> bisectCollision(const Shape& a, const Sweep& sweepA, const Shape& b, const Sweep& sweepB,
                                             int probes) {
    requireInRange(a, "bisectCollision.a");
    validate(sweepA, "bisectCollision.sweepA");
    requireInRange(b, "bisectCollision.b");
    validate(sweepB, "bisectCollision.sweepB");
    return bisectCollision(
        [&](double time) { return overlap(a, poseAt(sweepA, time), b, poseAt(sweepB, time)).has_value(); }, probes);
}

}  // namespace plumb
