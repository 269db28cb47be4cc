// SPDX-License-Identifier: MIT
#include <plumb/steering/flock.h>

#include <plumb/math/check.h>
#include <plumb/math/detail/length.h>
#include <plumb/math/trig.h>
#include <plumb/steering/seek.h>

namespace plumb {
namespace {

/// Decides which agents are neighbours.
class NeighborTest {
public:
    NeighborTest(const Agent& agent, const Neighborhood& neighborhood) : agent_(agent), radius_(neighborhood.radius) {
        validate(agent);
        requirePositive(neighborhood.radius, "Neighborhood", ".radius");
        requireWithin(neighborhood.view, 0, std::numbers::pi, "Neighborhood", ".view");
        leastCosine_ = sinCos(neighborhood.view).cos;
        all_ = neighborhood.view == std::numbers::pi;
        heading_ = headingOf(agent);
    }

    bool accepts(const AgentState& other) const {
        validate(other);
        const Vec2 d = other.position - agent_.position;
        const double distance = d.norm();
        if (!(distance > 0) || distance >= radius_) return false;
        return all_ || d.dot(heading_) >= leastCosine_ * distance;
    }

private:
    const Agent& agent_;
    double radius_;
    double leastCosine_ = -1;
    bool all_ = true;
    Vec2 heading_{1, 0};
};

}  // namespace

Vec2 separate(const Agent& agent, std::span<const AgentState> others, const Neighborhood& neighborhood) {
    const NeighborTest test(agent, neighborhood);
    Vec2 push(0, 0);
    for (const AgentState& other : others) {
        if (!test.accepts(other)) continue;
        const Vec2 away = agent.position - other.position;
        const double distance = away.norm();
        push += (1 - distance / neighborhood.radius) / distance * away;
    }
    return detail::limited(agent.maxAcceleration * push, agent.maxAcceleration);
}

Vec2 align(const Agent& agent, std::span<const AgentState> others, const Neighborhood& neighborhood) {
    const NeighborTest test(agent, neighborhood);
    Vec2 sum(0, 0);
    int count = 0;
    for (const AgentState& other : others)
        if (test.accepts(other)) sum += other.velocity, ++count;
    return count > 0 ? steerTo(agent, sum / count) : Vec2(0, 0);
}

Vec2 cohere(const Agent& agent, std::span<const AgentState> others, const Neighborhood& neighborhood) {
    const NeighborTest test(agent, neighborhood);
    Vec2 offset(0, 0), velocity(0, 0);
    int count = 0;
    for (const AgentState& other : others) {
        if (!test.accepts(other)) continue;
        offset += other.position - agent.position;
        velocity += other.velocity;
        ++count;
    }
    if (count == 0) return {0, 0};
    const Vec2 approach = offset / count * (agent.maxSpeed / slowingDistanceOf(agent));
    const Vec2 wanted = velocity / count + detail::limited(approach, agent.maxSpeed);
    return steerTo(agent, detail::limited(wanted, agent.maxSpeed));
}

}  // namespace plumb
