// SPDX-License-Identifier: MIT
// On which bodies does a field act, and where?
#pragma once
#include <optional>
#include <vector>

#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// The box around a field's region: outside of it the field does not act [m].
Aabb boxOf(const FieldDef& field);
/// The shift, by whole periods of the world, that brings a point to the image on which a field acts: into its region,
/// or else near its centre, or for a pool without a region into [0, width) and [0, height). Empty when the field does
/// not cover the point.
std::optional<Vec2> shiftInto(const FieldRecord& field, const FieldStores& view, const Vec2& point);
/// Does the field act on a body with the motion there?
bool actsOn(const FieldRecord& field, const FieldStores& view, BodyIndex body, const BodyMotion& there);
/// Does the body that carries the magnet exist, and is it enabled?
bool isCarried(const Magnet& magnet, const FieldStores& view);
bool isCarriedBy(const FieldLaw& law, BodyIndex body);
/// The magnet as an attractor in the world, when the bodies have the motions now.
Attractor attractorOf(const Magnet& magnet, const FieldStores& view, const std::vector<BodyMotion>& now);

/// Does any field depend on the positions of other bodies than the one on which it acts?
bool dependsOnOtherBodies(const FieldStore& fields);

/// The kind of effect that fields may have on a body during a step.
enum class FieldInfluence {
    None,
    Steady,  ///< the same wherever it is: uniform gravity, wind, and drag in proportion to the speed
    Varying,
};
FieldInfluence influenceOn(const FieldStores& view, BodyIndex body, const Vec2& from, const Vec2& to);

/// All bodies on which a field acts, asleep or awake, except the one that carries it.
StepList<BodyIndex> bodiesInfluencedBy(const FieldStores& view, const FieldRecord& field);
/// Before a step: notes which bodies mutual gravity and magnets attract. Returns those that may not sleep.
StepList<BodyIndex> gatherAttracted(FieldStore& fields, FieldIndex field, const BodyStore& bodies, const Space& space);

}  // namespace plumb
