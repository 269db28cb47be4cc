// SPDX-License-Identifier: MIT
// Which forces fill the world? The part of World that handles fields, and the view of one field.
#include <algorithm>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/edit/edits.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/dynamics/fields/field_solving.h>
#include <plumb/dynamics/fields/placed_outline.h>
#include <plumb/dynamics/world.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

FieldRecord recordOf(const FieldDef& def, std::uint32_t generation) {
    return {def, true, !(def.filter == Filter{}), generation, boxOf(def), {}};
}

/// Pushes one body by the impulse of an explosion on one of its shapes: at the shape's nearest point, in proportion to
/// its width as seen from there. Within the shape there is no nearest point; then it is pushed at the explosion's
/// middle, and away from there. Test: "a blast within a body pushes its centre of mass away"
void blast(WorldState& world, ShapeId id, const Shape& shape, Explosion explosion) {
    const BodyIndex body = id.body.index;
    const BodyRecord& record = world.bodies.record[body];
    BodyMotion& motion = world.bodies.motion[body];
    explosion.center = world.bodies.near(explosion.center, motion.center);
    const PlacedOutline outline = placedOutline(shape, record, motion);
    const Distance near = distance(Circle{1e-9, explosion.center}, {}, shape, world.bodies.pose(body));
    const Vec2 seen = near.pointB - explosion.center;
    const bool within = near.separation <= 0;
    const Vec2 direction = within ? Vec2(motion.center - explosion.center) : seen;
    const Blast hit = blastOn(explosion, {.nearest = within ? explosion.center : near.pointB,
                                          .centerOfMass = motion.center,
                                          .width = widthAcross(outline.corners, outline.radius, direction)});
    motion.velocity += hit.impulse * record.inverseMass;
    motion.angularVelocity += cross(Vec2(hit.point - motion.center), hit.impulse) * record.inverseInertia;
    wakeIsland(world, body);
}

}  // namespace

/// The first field brings the code of fields along: programs without fields are 29 KB smaller.
FieldId World::addField(const FieldDef& def) {
    validate(*state_, def);
    if (state_->fields.records.empty()) state_->fields.solver = std::make_unique<FieldSolving>();
    const FieldIndex field = state_->fields.acquire();
    FieldRecord& record = state_->fields.records[field];
    record = recordOf(def, record.generation);
    wakeInfluenced(*state_, record);
    return {field, record.generation, state_->bodies.world};
}

void World::remove(FieldId id) {
    requireField(*state_, id, "FieldId");
    wakeInfluenced(*state_, state_->fields.records[id.index]);
    state_->fields.release(id.index);
}

bool World::contains(FieldId id) const {
    return isKnown(*state_, id);
}

Field World::field(FieldId id) {
    requireField(*state_, id, "FieldId");
    return {*state_, id};
}

FieldView World::field(FieldId id) const {
    requireField(*state_, id, "FieldId");
    return {*state_, id};
}

FieldId FieldView::id() const {
    return id_;
}

std::uint32_t FieldView::index() const {
    requireField(*world_, id_, "FieldId");
    return id_.index;
}

FieldDef FieldView::def() const {
    return world_->fields.records[index()].def;
}

/// Both before and after: what the field has left falls, what it has reached is drawn.
void Field::set(const FieldDef& def) {
    validate(*world_, def);
    FieldRecord& record = world_->fields.records[index()];
    wakeInfluenced(*world_, record);
    record = recordOf(def, record.generation);
    wakeInfluenced(*world_, record);
}

std::vector<FieldId> World::fields() const {
    std::vector<FieldId> ids;
    const std::vector<FieldRecord>& records = state_->fields.records;
    for (FieldIndex field = 0; field < records.size(); ++field)
        if (records[field].alive) ids.push_back({field, records[field].generation, state_->bodies.world});
    return ids;
}

void World::explode(const Explosion& explosion, const Filter& filter) {
    requireFinite(explosion.center, "Explosion.center");
    // Checks the explosion, also where nobody is near.
    (void)blastOn(explosion, {});
    const double reach = explosion.radius + explosion.falloff;
    requireFinite(reach, "Explosion.radius + falloff");
    if (!(reach > 0)) return;
    for (const ShapeId& shape : overlapShape(Circle{reach, explosion.center}, {}, filter))
        if (state_->bodies.canMove(shape.body.index)) blast(*state_, shape, this->shape(shape).def().shape, explosion);
}

}  // namespace plumb
