// SPDX-License-Identifier: MIT
#include <compare/engine/plumb_movers.h>

#include <utility>

#include <compare/scene/joint_geometry.h>

namespace plumb::compare {

PlumbMovers::PlumbMovers(const Scene& scene, const PlumbWorld& made) : agents_(scene), bodies_(made.bodies) {
    PlacedMaps maps;
    for (const SceneMover& mover : scene.movers) {
        const std::size_t index = bodyIndex(scene, mover.body);
        const BodyId body = made.bodies[index];
        if (const auto* path = std::get_if<PathMotion>(&mover.motion))
            movers_.push_back(OnPath{pathMoverOf(*path), path->delay, body, scene.bodies[index].def.angle});
        if (const auto* swing = std::get_if<SwingMotion>(&mover.motion)) {
            const BodyDef& def = scene.bodies[index].def;
            movers_.push_back(Swinging{*swing, def.position, body, def.angle});
        }
        if (const auto* sliding = std::get_if<SlidingMotion>(&mover.motion)) movers_.push_back(Sliding{*sliding, body});
        if (const auto* grid = std::get_if<GridMotion>(&mover.motion))
            movers_.push_back(OnGrid{*grid, gridMoverOf(*grid), TurnList(*grid), maps.of(scene, *grid), body});
        if (const auto* platform = std::get_if<PlatformMotion>(&mover.motion))
            movers_.push_back(OnPlatforms{*platform, PlatformMover(body, profileOf(*platform))});
    }
}

void PlumbMovers::step(World& world, double dt) {
    if (!agents_.empty()) steer(world, dt);  // first, because other movers set velocities
    for (auto& mover : movers_) std::visit([&](auto& m) { step(world, m, dt); }, mover);
    ++tick_;
}

void PlumbMovers::steer(World& world, double dt) {
    const auto stateOf = [&](std::size_t index) -> BodyState {
        const BodyView body = std::as_const(world).body(bodies_[index]);
        return {body.position(), body.angle(), body.velocity(), body.angularVelocity()};
    };
    agents_.step(stateOf, dt);
    for (const SteeredAgent& one : agents_.agents()) {
        Body body = world.body(bodies_[one.body]);
        body.moveTo(one.agent.position, body.angle(), dt);
    }
}

void PlumbMovers::step(World& world, OnPath& mover, double dt) const {
    world.body(mover.body).moveTo(placeOn(mover.mover, mover.delay, tick_ + 1, dt), mover.angle, dt);
}

void PlumbMovers::step(World& world, Swinging& mover, double dt) const {
    world.body(mover.body).moveTo(placeOn(mover.motion, mover.start, tick_ + 1, dt), mover.angle, dt);
}

void PlumbMovers::step(World& world, Sliding& mover, double dt) const {
    const SlideSettings settings{.pushStrength = mover.motion.pushStrength};
    mover.last = moveAndSlide(world, mover.body, {.velocity = mover.motion.velocity, .dt = dt}, settings, mover.last);
}

void PlumbMovers::step(World& world, OnGrid& mover, double dt) const {
    mover.turns.ask(mover.mover);
    mover.mover.move(*mover.map.map, mover.motion.speed, dt);
    world.body(mover.body).moveTo(mover.map.pose * mover.mover.position(*mover.map.map), 0, dt);
}

void PlumbMovers::step(World& world, OnPlatforms& mover, double dt) const {
    const PlatformCue cue = cueAt(mover.motion, tick_ * dt);
    mover.mover.step(world, {.move = cue.move, .run = cue.run, .jump = cue.jump}, dt);
}

}  // namespace plumb::compare
