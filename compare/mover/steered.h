// SPDX-License-Identifier: MIT
// Where are the bodies that steer after each step?
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <compare/scene/joint_geometry.h>
#include <compare/scene/scene.h>
#include <compare/scene/state.h>
#include <plumb/steering/avoid.h>
#include <plumb/steering/pursue.h>
#include <plumb/steering/wander.h>

namespace plumb::compare {

/// A body that steers, by its index in the scene, and where it goes.
struct SteeredAgent {
    std::size_t body = 0;
    Agent agent{};
};

/// The state of a body, by its index in the scene.
using StateOf = std::function<BodyState(std::size_t)>;

/// The agents of a scene's steered movers. They are the same in every engine: nothing stops or pushes them.
class SteeredAgents {
public:
    explicit SteeredAgents(const Scene& scene);

    bool empty() const { return agents_.empty(); }
    /// All decide from where bodies are before the step, then all move for dt [s]. stateOf is asked for the
    /// targets that do not steer; a target that steers is seen as the agent that it is.
    void step(const StateOf& stateOf, double dt);
    /// In the order of the scene's movers.
    std::span<const SteeredAgent> agents() const { return agents_; }

private:
    /// What an agent wants, and what it remembers from step to step.
    struct Mind {
        SteeredMotion motion;
        std::size_t target = noBody;                  // its body
        std::optional<std::size_t> targetAgent = {};  // the target among the agents, if it steers
        std::vector<RoundObstacle> obstacles{};       // with avoid
        double progress = 0;                          // along its path [m]
        WanderState wandering;
    };

    AgentState targetOf(const Mind& mind, const StateOf& stateOf) const;
    std::vector<AgentState> flockNow() const;
    Vec2 wanted(Mind& mind, const Agent& agent, std::span<const AgentState> flock, const StateOf& stateOf,
                double dt) const;

    std::vector<SteeredAgent> agents_;
    std::vector<Mind> minds_;  // of each agent
};

}  // namespace plumb::compare
