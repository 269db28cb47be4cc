// SPDX-License-Identifier: MIT
// What do the fields do to a body where it is?
#pragma once
#include <vector>

#include <plumb/dynamics/detail/world_state.h>

namespace plumb {

/// Before a step: whom mutual gravity and magnets draw. Wakes what is not to sleep: what the former draws, and the
/// latter that are awake.
void gatherDrawn(WorldState& world);
/// Does a field look at where other bodies are than the one that it acts on?
bool looksAround(const WorldState& world);

/// What fields may do to a body on its way through a step.
enum class Felt {
    Nothing,
    Steadily,  ///< the same wherever it is: uniform gravity, wind, and drag in proportion to the speed
    Somehow
};
Felt feltBy(const WorldState& world, BodyIndex body, const Vec2& from, const Vec2& to);

/// now: where each body is, by its slot: this one, and, where fields look around, all.
void pullOn(const WorldState& world, BodyIndex body, const std::vector<BodyMotion>& now, FieldPull& pull);

/// Of all fields that have one [J].
double fieldEnergyOf(const WorldState& world);
/// Of one body, if it were there, and all others where they are.
double fieldEnergyOf(const WorldState& world, BodyIndex body, const BodyMotion& there);

/// Before a field comes, changes or goes.
void wakeWhatFeels(WorldState& world, const FieldRecord& field);
/// Before a body that may carry magnets goes, and after one has come.
void wakeWhatItDraws(WorldState& world, BodyIndex body);

/// Around a field's region: beyond it the field does not act [m].
Aabb boxOf(const FieldDef& field);

}  // namespace plumb
