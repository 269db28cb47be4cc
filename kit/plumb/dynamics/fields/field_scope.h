// SPDX-License-Identifier: MIT
// On which bodies does a field act, and where?
#pragma once
#include <optional>
#include <vector>

#include <plumb/dynamics/fields/field_store.h>

namespace plumb {

/// Around a field's region: beyond it the field does not act [m].
Aabb boxOf(const FieldDef& field);
/// By how many rounds of the world a point is to be shifted to where a field sees it: into its region, or else near its
/// centre, or to where a pool without a region has its depth. Empty when the field does not cover it.
std::optional<Vec2> shiftInto(const FieldRecord& field, const FieldView& view, const Vec2& point);
/// Does it act on a body that is there?
bool actsOn(const FieldRecord& field, const FieldView& view, BodyIndex body, const BodyMotion& there);
/// Is the body there that carries the magnet?
bool isCarried(const Magnet& magnet, const FieldView& view);
bool isCarriedBy(const FieldLaw& law, BodyIndex body);
/// Where a magnet is when bodies are there.
Attractor attractorOf(const Magnet& magnet, const FieldView& view, const std::vector<BodyMotion>& now);

/// Does a field look at where other bodies are than the one that it acts on?
bool looksAround(const FieldStore& fields);

/// What fields may do to a body on its way through a step.
enum class FieldInfluence {
    None,
    Steady,  ///< the same wherever it is: uniform gravity, wind, and drag in proportion to the speed
    Varying,
};
FieldInfluence influenceOn(const FieldView& view, BodyIndex body, const Vec2& from, const Vec2& to);

/// The bodies that a field acts on, asleep or awake, without the one that carries it.
std::vector<BodyIndex> bodiesInfluencedBy(const FieldView& view, const FieldRecord& field);
/// Before a step: notes which bodies mutual gravity and magnets attract. Returns those that may not sleep.
std::vector<BodyIndex> gatherAttracted(FieldStore& fields, FieldIndex field, const BodyStore& bodies,
                                       const Space& space);

}  // namespace plumb
