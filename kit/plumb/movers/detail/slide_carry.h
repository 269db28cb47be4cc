// SPDX-License-Identifier: MIT
// What carries a body that stands, and where to?
#pragma once
#include <plumb/movers/detail/slide_run.h>

namespace plumb::detail {

struct SlideStart {
    Vec2 position;
    bool jumped;  ///< it is not where the last tick sent it
};

/// Where the world has it, but for a rounding that is not to add up.
SlideStart startOf(const World& world, BodyId body, const Slide& last);

/// Is what it stood on where its velocity, of this tick or of the last, took it?
bool isFloorThere(const World& world, const Slide& last, const SlideMotion& motion, const SlideSettings& settings);
/// Is it of a category that takes along who stands on it?
bool carries(const World& world, const CastHit& floor, const SlideSettings& settings);
/// Onto its place on what carries it; false when it cannot get there.
bool carry(SlideRun& run, const Slide& last, bool moved);
/// The velocity that what it stood on gives it on leaving.
Vec2 parting(const SlideRun& run);

/// The place on the floor: the one that it had, while it does not go anywhere by itself.
void rememberPlace(SlideRun& run, const Slide& last, bool kept);
/// What it stands on creeps by roundings, or as crates do that settle: it would wake them by following in each tick.
/// Its place on them is kept, so that it follows when that has added up.
bool isStill(const SlideRun& run, const Vec2& here, bool kept);

}  // namespace plumb::detail
