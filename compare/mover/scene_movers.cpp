// SPDX-License-Identifier: MIT
#include <compare/mover/scene_movers.h>

#include <algorithm>
#include <cmath>

#include <compare/scene/joint_geometry.h>

namespace plumb::compare {
namespace {

Vec2 velocityTo(const Vec2& target, const BodyState& now, double dt) {
    return (target - now.position) / dt;
}

/// The jump band for a speed along the floor.
JumpBand bandAt(const std::vector<JumpBand>& bands, double speed) {
    JumpBand found = bands.front();
    for (const JumpBand& band : bands)
        if (band.fromSpeed <= speed) found = band;
    return found;
}

/// The motion of the body's mover; null if it has none of this kind.
template <class Motion>
const Motion* motionOf(const Scene& scene, const SceneBody& body) {
    const auto mover = std::ranges::find(scene.movers, body.name, &SceneMover::body);
    return mover == scene.movers.end() ? nullptr : std::get_if<Motion>(&mover->motion);
}

const SlidingMotion* stoppedSlider(const Scene& scene, const SceneBody& body) {
    const auto* sliding = motionOf<SlidingMotion>(scene, body);
    return sliding != nullptr && sliding->standIn == StandIn::Stopped ? sliding : nullptr;
}

double towards(double value, double target, double most) {
    return std::clamp(target, value - most, value + most);
}

}  // namespace

SceneMovers::SceneMovers(const Scene& scene, Characters characters) : agents_(scene), gravity_(-scene.gravity.y()) {
    PlacedMaps maps;
    for (const SceneMover& mover : scene.movers) {
        const std::size_t body = bodyIndex(scene, mover.body);
        if (const auto* path = std::get_if<PathMotion>(&mover.motion))
            movers_.push_back({body, OnPath{pathMoverOf(*path), path->delay}});
        if (const auto* swing = std::get_if<SwingMotion>(&mover.motion))
            movers_.push_back({body, Swinging{*swing, scene.bodies[body].def.position}});
        if (const auto* sliding = std::get_if<SlidingMotion>(&mover.motion))
            movers_.push_back({body, Straight{sliding->velocity, isCharacter(scene, scene.bodies[body], characters)}});
        if (const auto* grid = std::get_if<GridMotion>(&mover.motion))
            movers_.push_back({body, OnGrid{*grid, gridMoverOf(*grid), TurnList(*grid), maps.of(scene, *grid)}});
        const auto* platform = std::get_if<PlatformMotion>(&mover.motion);
        if (platform != nullptr && !platform->cues.empty())
            movers_.push_back({body, OnPlatforms{*platform, profileOf(*platform), {}}});
    }
}

std::vector<MoverCommand> SceneMovers::commands(std::span<const BodyState> states, double dt) {
    std::vector<MoverCommand> result;
    for (Mover& mover : movers_) {
        result.push_back(std::visit([&](auto& m) { return command(m, states[mover.body], dt); }, mover.kind));
        result.back().body = mover.body;
    }
    agents_.step([&](std::size_t body) { return states[body]; }, dt);
    for (const SteeredAgent& one : agents_.agents())
        result.push_back({.body = one.body, .velocity = velocityTo(one.agent.position, states[one.body], dt)});
    ++tick_;
    return result;
}

MoverCommand SceneMovers::command(OnPath& mover, const BodyState& now, double dt) const {
    return {.velocity = velocityTo(placeOn(mover.mover, mover.delay, tick_ + 1, dt), now, dt)};
}

MoverCommand SceneMovers::command(Swinging& mover, const BodyState& now, double dt) const {
    return {.velocity = velocityTo(placeOn(mover.motion, mover.start, tick_ + 1, dt), now, dt)};
}

MoverCommand SceneMovers::command(Straight& mover, const BodyState&, double) const {
    return {.velocity = mover.velocity, .asCharacter = mover.isCharacter};
}

MoverCommand SceneMovers::command(OnGrid& mover, const BodyState& now, double dt) const {
    mover.turns.ask(mover.mover);
    mover.mover.move(*mover.map.map, mover.motion.speed, dt);
    return {.velocity = velocityTo(mover.map.pose * mover.mover.position(*mover.map.map), now, dt)};
}

MoverCommand SceneMovers::command(OnPlatforms& mover, const BodyState& now, double dt) const {
    const PlatformCue cue = cueAt(mover.motion, tick_ * dt);
    const HorizontalMotion& horizontal = mover.profile.horizontal;
    const double wanted = cue.move * (cue.run ? horizontal.runSpeed : horizontal.walkSpeed);
    const double gain = (cue.run ? horizontal.runAcceleration : horizontal.walkAcceleration) * dt;
    MoverCommand command{.velocity = {towards(now.velocity.x(), wanted, gain), now.velocity.y()}};
    if (cue.jump && !mover.jumpHeld) {
        mover.band = bandAt(mover.profile.vertical.jumps, std::fabs(now.velocity.x()));
        command.velocity.y() = mover.band.takeOffSpeed;
    }
    mover.jumpHeld = cue.jump;
    const bool rises = command.velocity.y() > 0;
    const double held = cue.jump ? mover.band.riseGravity : mover.band.releaseGravity;
    command.gravityScale = (rises ? held : mover.band.fallGravity) / gravity_;
    return command;
}

bool isCharacter(const Scene& scene, const SceneBody& body, Characters characters) {
    const SlidingMotion* sliding = stoppedSlider(scene, body);
    return characters == Characters::Capsules && sliding != nullptr && body.def.shapes.size() == 1 &&
           std::holds_alternative<Capsule>(body.def.shapes[0].shape);
}

SceneBody asMoved(const Scene& scene, const SceneBody& body, Characters characters) {
    const auto* runner = motionOf<PlatformMotion>(scene, body);
    const bool slides = stoppedSlider(scene, body) != nullptr && !isCharacter(scene, body, characters);
    if (runner == nullptr && !slides) return body;
    SceneBody moved = body;
    moved.def.type = BodyType::Dynamic;
    moved.def.fixedRotation = true;
    moved.def.canSleep = false;
    if (slides) moved.def.gravityScale = 0;
    if (slides || !runner->cues.empty())
        for (ShapeDef& shape : moved.def.shapes) shape.material.friction = 0;
    return moved;
}

}  // namespace plumb::compare
