// SPDX-License-Identifier: MIT
// Which outlines do bodies have? The part of World that handles shapes, and the view of one shape.
#include <algorithm>
#include <array>

#include <plumb/dynamics/edit/body_shapes.h>
#include <plumb/dynamics/edit/shape_pieces.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/dynamics/world.h>
#include <plumb/math/check.h>
#include <plumb/space/detail/shape_radii.h>

namespace plumb {

namespace {

/// Does the body's mass follow its shapes? Then an edit of a shape may leave it without mass, and must be refused.
bool weighsByShapes(const BodyRecord& record) {
    return record.type == BodyType::Dynamic && !record.massGiven;
}

/// Checks the mass that a body would have with def as one of its shapes.
void requireMassWith(const WorldState& world, ShapeId id, const ShapeDef& def, const char* field) {
    if (!weighsByShapes(world.bodies.record[id.body.index])) return;
    const std::array<Mass, 2> parts{massOfShapesWithout(world, id.body.index, id.number),
                                    massOf(def.shape, def.material.density)};
    requireMass(combine(parts), std::string(field) + ", for the body's",
                "a dynamic body needs a shape with area and density, or a mass of its own");
}

/// Checks the thickness that a dynamic body would have with def as one of its shapes.
void requireThicknessWith(const WorldState& world, ShapeId id, const ShapeDef& def, const char* field) {
    if (!world.bodies.isDynamic(id.body.index)) return;
    const bool thick = std::ranges::any_of(world.bodies.links[id.body.index].proxies, [&](ProxyId proxy) {
        const Proxy& other = world.space[proxy];
        return other.number != id.number && !other.def.sensor && inradiusOf(other.def.shape) >= leastHalfThickness;
    });
    if (!thick) requireThickness(std::span(&def, 1), std::string(field) + ".shape");
}

/// May the pieces and contacts of a stay, if a becomes b? Material, filter and tag may differ: alterShape changes
/// these.
bool meetsAlike(const ShapeDef& a, const ShapeDef& b) {
    return a.shape == b.shape && a.sensor == b.sensor && a.oneWay == b.oneWay && a.rule == b.rule;
}

/// A definition with all of a shape's properties, but not always its outline.
const ShapeDef& propertiesOf(const WorldState& world, ShapeId id) {
    const auto tiles = world.tiles.find({id.body.index, id.number});
    if (tiles != world.tiles.end()) return tiles->second.def;
    return world.space[piecesOf(world, id.body.index, id.number).front()].def;
}

void requireTiles(const WorldState& world, ShapeId id, const char* field) {
    requireShape(world, id, field);
    if (!world.tiles.contains({id.body.index, id.number})) refuse(field, "the shape is not a tile map");
}

}  // namespace

/// The number is used up only after all checks, so a refused shape leaves no gap.
ShapeId World::add(BodyId id, const ShapeDef& shape) {
    requireBody(*state_, id, "BodyId");
    requireShape(shape, "ShapeDef");
    requireFit(*state_, shape.shape, state_->bodies.pose(id.index), "ShapeDef.shape");
    const ShapeId added{id, state_->bodies.record[id.index].shapesMade};
    requireThicknessWith(*state_, added, shape, "ShapeDef");
    requireMassWith(*state_, added, shape, "ShapeDef");
    ++state_->bodies.record[id.index].shapesMade;
    addShape(*state_, id.index, shape, added.number);
    updateMassFromShapes(*state_, id.index);
    if (!shape.sensor) wakeTouching(*state_, id.index, added.number);
    return added;
}

/// Checked and woken first: afterwards neither the pieces nor what touched them can be asked.
void World::remove(ShapeId id) {
    requireShape(*state_, id, "ShapeId");
    const BodyIndex body = id.body.index;
    if (weighsByShapes(state_->bodies.record[body]))
        requireMass(massOfShapesWithout(*state_, body, id.number), "World.remove: ShapeId, for the other shapes'",
                    "a dynamic body needs a shape with area and density, or a mass of its own");
    if (!state_->space[piecesOf(*state_, body, id.number).front()].def.sensor) wakeTouching(*state_, body, id.number);
    removeShape(*state_, body, id.number);
    updateMassFromShapes(*state_, body);
}

bool World::contains(ShapeId id) const {
    return isKnown(*state_, id);
}

BodyShape World::shape(ShapeId id) {
    requireShape(*state_, id, "ShapeId");
    return {*state_, id};
}

BodyShapeView World::shape(ShapeId id) const {
    requireShape(*state_, id, "ShapeId");
    return {*state_, id};
}

std::vector<ShapeId> World::shapes() const {
    std::vector<ShapeId> ids;
    for (const BodyId id : bodies())
        for (const ShapeId& shape : body(id).shapes()) ids.push_back(shape);
    return ids;
}

ShapeId BodyShapeView::id() const {
    return id_;
}

BodyId BodyShapeView::body() const {
    return id_.body;
}

const ShapeId& BodyShapeView::known() const {
    requireShape(*world_, id_, "ShapeId");
    return id_;
}

ShapeDef BodyShapeView::def() const {
    const ShapeId& id = known();
    return shapeOf(*world_, piecesOf(*world_, id.body.index, id.number));
}

bool BodyShapeView::sensor() const {
    return propertiesOf(*world_, known()).sensor;
}

const Material& BodyShapeView::material() const {
    return propertiesOf(*world_, known()).material;
}

const Filter& BodyShapeView::filter() const {
    return propertiesOf(*world_, known()).filter;
}

std::uint64_t BodyShapeView::tag() const {
    return propertiesOf(*world_, known()).tag;
}

/// All is checked before anything changes. A change of properties keeps the pieces and their contacts with their
/// impulses; a new outline replaces the shape under the same number, so its id stays right. What touches it wakes
/// before, while its contacts still tell who that is.
void BodyShape::set(const ShapeDef& def) {
    const ShapeId id = known();
    requireShape(def, "ShapeDef");
    requireFit(*world_, def.shape, world_->bodies.pose(id.body.index), "ShapeDef.shape");
    requireThicknessWith(*world_, id, def, "ShapeDef");
    requireMassWith(*world_, id, def, "ShapeDef");
    const ShapeDef before = this->def();
    const BodyIndex body = id.body.index;
    const bool alike = meetsAlike(before, def);
    const bool same = alike && before.material == def.material && before.filter == def.filter;
    if (!same && !(before.sensor && def.sensor)) wakeTouching(*world_, body, id.number);
    if (alike) {
        alterShape(*world_, body, def, id.number);
    } else {
        removeShape(*world_, body, id.number);
        addShape(*world_, body, def, id.number);
    }
    updateMassFromShapes(*world_, body);
}

void BodyShape::setMaterial(const Material& material) {
    ShapeDef changed = def();
    changed.material = material;
    set(changed);
}

void BodyShape::setFilter(const Filter& filter) {
    ShapeDef changed = def();
    changed.filter = filter;
    set(changed);
}

void BodyShape::setTag(std::uint64_t tag) {
    ShapeDef changed = def();
    changed.tag = tag;
    set(changed);
}

const TileMap& World::tiles(ShapeId id) const {
    requireTiles(*state_, id, "World.tiles: ShapeId");
    return state_->tiles.at({id.body.index, id.number}).map();
}

void World::setTile(ShapeId id, Cell cell, const Tile& tile) {
    requireTiles(*state_, id, "World.setTile: ShapeId");
    editTile(*state_, id.body.index, id.number, cell, tile);
}

}  // namespace plumb
