// SPDX-License-Identifier: MIT
#include <plumb/dynamics/edit/field_edits.h>

#include <plumb/dynamics/edit/edits.h>
#include <plumb/dynamics/fields/field_phases.h>
#include <plumb/dynamics/fields/field_scope.h>

namespace plumb {

void wakeInfluenced(WorldState& world, const FieldRecord& field) {
    const FieldStores view{world.fields, world.bodies, world.space};
    std::vector<BodyIndex> influenced = view.fields.phases->bodiesInfluencedBy(view, field);
    if (const auto* magnet = std::get_if<Magnet>(&field.def.law))
        if (isCarried(*magnet, view)) influenced.push_back(magnet->body.index);
    for (const BodyIndex body : influenced) wakeIsland(world, body);
}

void wakeInfluencedByMagnetsOn(WorldState& world, BodyIndex body) {
    for (const FieldRecord& field : world.fields.records)
        if (field.alive && isCarriedBy(field.def.law, body)) wakeInfluenced(world, field);
}

}  // namespace plumb
