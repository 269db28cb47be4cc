// SPDX-License-Identifier: MIT
// Where does a moved body end up, with obstacles, pushes, floors and moving bodies?
#pragma once
#include <plumb/movers/slide.h>

namespace plumb {

/// Gives a kinematic body the velocity with which the next World::step(motion.dt) takes it as far as it can go; call it
/// before each step. It stops at a skin's distance from obstacles, slides along them, follows floors up, over and down,
/// and pushes dynamic bodies by at most pushStrength dt, no faster than it moves itself: m a = pushStrength - friction.
/// Kinematic bodies are hit where the coming step takes them: they carry bodies that stand on them, and push others. A
/// body on another's floor keeps its place on it to rounding, because the place is stored in the other's frame; a floor
/// that was moved elsewhere, farther than its velocity explains, does not carry. A body whose floor was removed leaves
/// with the floor's velocity.
/// For movers that stand on movers, call it for the carrier before the rider: the rider uses the velocity given in this
/// tick. List the movers that are updated later, or a mover that has turned around is still expected to continue: its
/// velocity is that of the tick before.
/// One-way shapes are solid from their open side only, unless overlapped. One-way tiles of a map whose tops join end to
/// end, horizontally, are one floor; after dropping through one floor, the body lands on the next. The body's own
/// sensors hit nothing.
/// last is the result of the tick before, or Slide{} at first, or after a teleport.
/// Throws std::invalid_argument for a stale id, a body that is not kinematic, or values out of range.
/// Tests: [movers], "a crate under a push F and friction mu m g gains (F - mu m g) / m a second"
Slide moveAndSlide(World& world, BodyId body, const SlideMotion& motion, const SlideSettings& settings = {},
                   const Slide& last = {});

/// Throws std::invalid_argument with the field, the value and what was expected; field is the name of the structure.
void validate(const SlideSettings& settings, const std::string& field);

}  // namespace plumb
