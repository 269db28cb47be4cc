// SPDX-License-Identifier: MIT
#include <compare/mover/steered.h>

#include <algorithm>
#include <array>

#include <plumb/steering/blend.h>
#include <plumb/steering/flock.h>
#include <plumb/steering/path.h>
#include <plumb/steering/seek.h>

namespace plumb::compare {
namespace {

/// The circles of all static bodies that are always there, but for the target's.
std::vector<RoundObstacle> discsBut(const Scene& scene, const std::string& target) {
    std::vector<RoundObstacle> discs;
    for (const SceneBody& body : scene.bodies) {
        if (body.def.type != BodyType::Static || !isAlwaysThere(body) || body.name == target) continue;
        for (const ShapeDef& shape : body.def.shapes)
            if (const auto* circle = std::get_if<Circle>(&shape.shape))
                discs.push_back({startPose(body.def) * circle->center, circle->radius});
    }
    return discs;
}

Agent agentOf(const BodyDef& body, const SteeredMotion& motion) {
    return {.position = body.position,
            .velocity = motion.velocity,
            .radius = discRadius(body).value_or(0),
            .maxSpeed = motion.maxSpeed,
            .maxAcceleration = motion.maxAcceleration};
}

/// For the behaviours that have a target.
Vec2 toTarget(const AgentState& target, const Agent& agent, Behaviour behaviour,
              std::span<const RoundObstacle> obstacles) {
    switch (behaviour) {
        case Behaviour::Flee: return flee(agent, target.position);
        case Behaviour::Arrive: return arrive(agent, target.position);
        case Behaviour::Pursue: return pursue(agent, target);
        case Behaviour::Evade: return evade(agent, target);
        case Behaviour::Avoid:
            return steerByPriority(agent, std::array{WeightedSteering{avoidObstacles(agent, obstacles)},
                                                     WeightedSteering{seek(agent, target.position)}});
        default: return seek(agent, target.position);
    }
}

Vec2 withFlock(const Agent& agent, std::span<const AgentState> flock) {
    return steerByWeight(agent,
                         std::array{WeightedSteering{separate(agent, flock)}, WeightedSteering{align(agent, flock)},
                                    WeightedSteering{cohere(agent, flock)}});
}

}  // namespace

SteeredAgents::SteeredAgents(const Scene& scene) {
    for (const SceneMover& mover : scene.movers) {
        const auto* motion = std::get_if<SteeredMotion>(&mover.motion);
        if (motion == nullptr) continue;
        const std::size_t body = bodyIndex(scene, mover.body);
        agents_.push_back({body, agentOf(scene.bodies[body].def, *motion)});
        Mind& mind = minds_.emplace_back(Mind{.motion = *motion, .wandering = {Random(motion->seed)}});
        if (needsTarget(motion->behaviour)) mind.target = bodyIndex(scene, motion->target);
        if (motion->behaviour == Behaviour::Avoid) mind.obstacles = discsBut(scene, motion->target);
    }
    for (Mind& mind : minds_) {
        const auto agent = std::ranges::find(agents_, mind.target, &SteeredAgent::body);
        if (agent != agents_.end()) mind.targetAgent = static_cast<std::size_t>(agent - agents_.begin());
    }
}

void SteeredAgents::step(const StateOf& stateOf, double dt) {
    const std::vector<AgentState> flock = flockNow();
    std::vector<Agent> after;
    for (std::size_t i = 0; i < agents_.size(); ++i) {
        const Agent& agent = agents_[i].agent;
        after.push_back(moved(agent, wanted(minds_[i], agent, flock, stateOf, dt), dt));
    }
    for (std::size_t i = 0; i < agents_.size(); ++i) agents_[i].agent = after[i];
}

Vec2 SteeredAgents::wanted(Mind& mind, const Agent& agent, std::span<const AgentState> flock, const StateOf& stateOf,
                           double dt) const {
    const SteeredMotion& motion = mind.motion;
    if (motion.behaviour == Behaviour::Flock) return withFlock(agent, flock);
    if (motion.behaviour == Behaviour::Wander) {
        const WanderStep step = wander(agent, mind.wandering, dt);
        mind.wandering = step.state;
        return step.acceleration;
    }
    if (motion.behaviour == Behaviour::Follow) {
        const PathStep step = followPath(agent, {motion.points, motion.closed}, mind.progress, motion.ahead);
        mind.progress = step.progress;
        return step.acceleration;
    }
    return toTarget(targetOf(mind, stateOf), agent, motion.behaviour, mind.obstacles);
}

AgentState SteeredAgents::targetOf(const Mind& mind, const StateOf& stateOf) const {
    if (mind.targetAgent) return {agents_[*mind.targetAgent].agent.position, agents_[*mind.targetAgent].agent.velocity};
    const BodyState state = stateOf(mind.target);
    return {state.position, state.velocity};
}

std::vector<AgentState> SteeredAgents::flockNow() const {
    std::vector<AgentState> flock;
    for (std::size_t i = 0; i < agents_.size(); ++i)
        if (minds_[i].motion.behaviour == Behaviour::Flock)
            flock.push_back({agents_[i].agent.position, agents_[i].agent.velocity});
    return flock;
}

}  // namespace plumb::compare
