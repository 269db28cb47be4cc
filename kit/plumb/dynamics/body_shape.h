// SPDX-License-Identifier: MIT
// Which outline and properties does a shape of a body have, and how can it be changed?
#pragma once
#include <plumb/dynamics/id.h>
#include <plumb/space/shape_def.h>

namespace plumb {

struct WorldState;

/// A read-only view of one shape of a body. Valid as long as the world exists; each call
/// throws std::invalid_argument once the shape was removed.
class BodyShapeView {
public:
    ShapeId id() const;
    BodyId body() const;
    ShapeDef def() const;  ///< as given or last set; of a tile map, with the tiles as they are now
    bool sensor() const;
    const Material& material() const;  ///< valid until the next call that changes the world
    const Filter& filter() const;      ///< valid until the next call that changes the world
    std::uint64_t tag() const;

protected:
    friend class World;
    BodyShapeView(WorldState& world, ShapeId id) : world_(&world), id_(id) {}
    const ShapeId& known() const;  ///< its id; throws std::invalid_argument if it was removed
    WorldState* world_;
    ShapeId id_;
};

/// A view that can also change the shape, at any time between steps. Bodies that a change affects wake. The mass of the
/// body is updated, unless it was given. Each call throws std::invalid_argument, and changes nothing, on a value that
/// is not valid, or if a dynamic body would be left without mass.
class BodyShape : public BodyShapeView {
public:
    void set(const ShapeDef& def);  ///< replaces the whole definition
    void setMaterial(const Material& material);
    void setFilter(const Filter& filter);
    void setTag(std::uint64_t tag);

private:
    friend class World;
    using BodyShapeView::BodyShapeView;
};

}  // namespace plumb
