// SPDX-License-Identifier: MIT
// What carries a body that stands on it, and to which position?
#pragma once
#include <plumb/movers/detail/slide_run.h>

namespace plumb::detail {

struct SlideStart {
    Vec2 position;
    bool jumped;  ///< it is not where the last tick sent it
};

/// Its position in the world, without rounding errors that would accumulate.
SlideStart startOf(const World& world, BodyId body, const Slide& last);

/// Is the floor where its velocity, of this tick or of the last, took it?
bool isFloorThere(const World& world, const Slide& last, const SlideMotion& motion, const SlideSettings& settings);
/// Does its category carry bodies that stand on it?
bool carries(const World& world, const CastHit& floor, const SlideSettings& settings);
/// Moves the body with the floor to its place on it; false when it is blocked.
bool carry(SlideRun& run, const Slide& last, bool moved);
/// The velocity that a floor adds to a body that leaves it.
Vec2 leaveVelocity(const SlideRun& run);

/// Stores the place on the floor: the same one as before, if the body did not move by itself.
void storeAnchor(SlideRun& run, const Slide& last, bool kept);
/// The floor moves by rounding errors only, or as settling crates do: a body that followed in each tick would keep them
/// awake. Its place on the floor is kept, so that it follows when the motion has accumulated.
bool isStill(const SlideRun& run, const Vec2& here, bool kept);

}  // namespace plumb::detail
