// SPDX-License-Identifier: MIT
// How does a set of bodies move on from one tick to the next?
#pragma once
#include <optional>
#include <span>
#include <vector>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/body.h>
#include <plumb/dynamics/body_def.h>
#include <plumb/dynamics/counts.h>
#include <plumb/dynamics/events.h>
#include <plumb/dynamics/field.h>
#include <plumb/dynamics/id.h>
#include <plumb/dynamics/joint.h>
#include <plumb/dynamics/joint_def.h>
#include <plumb/dynamics/ledger.h>
#include <plumb/dynamics/query.h>
#include <plumb/dynamics/step_profile.h>
#include <plumb/dynamics/world_def.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// Bodies, their contacts, joints and fields. A world may wrap around: then any place may be given, and stands for all
/// those that are whole rounds away; the nearest is meant where there is a choice, as for anchors; and what is told is
/// in [0, width) and [0, height). A copy goes on as the original would have, to the last bit, and knows its
/// things by the same ids; what was moved from can only be assigned to or destroyed. Every call that takes a def or an
/// id throws std::invalid_argument when it is not one the world can take, and then changes nothing.
class World {
public:
    explicit World(const WorldDef& def = {});
    World(const World& other);
    World(World&&) noexcept;
    World& operator=(const World& other);
    World& operator=(World&&) noexcept;
    ~World();

    BodyId add(const BodyDef& def);
    ShapeId add(BodyId body, const ShapeDef& shape);  ///< mass follows, unless it was given
    JointId join(const JointDef& def);
    void remove(BodyId body);    ///< with its shapes and joints
    void remove(ShapeId shape);  ///< mass follows, unless it was given
    void remove(JointId joint);  ///< with the gears that it drives

    // Forces that fill the world or a region of it. Whatever feels one wakes when it comes, changes or goes.
    FieldId addField(const FieldDef& def);
    void set(FieldId field, const FieldDef& def);  ///< in its place
    void remove(FieldId field);
    bool contains(FieldId field) const;
    FieldDef field(FieldId field) const;
    std::vector<FieldId> fields() const;  ///< in the order of their slots
    /// Pushes dynamic bodies, now: each shape that is no sensor and collides with a shape of the filter, by its width
    /// as the explosion sees it, at its nearest point.
    void explode(const Explosion& explosion, const Filter& filter = {});

    /// Moves the world on by dt [s], finite and not negative. Never throws for another reason.
    void step(double dt);

    bool contains(BodyId body) const;
    bool contains(ShapeId shape) const;
    bool contains(JointId joint) const;
    Body body(BodyId body);
    BodyView body(BodyId body) const;
    Joint joint(JointId joint);
    JointView joint(JointId joint) const;
    ShapeDef shape(ShapeId shape) const;
    void set(ShapeId shape, const ShapeDef& def);  ///< in its place; mass follows, unless it was given
    /// The map of a shape that is one; valid until the next call that changes the world. It wraps where it lies
    /// straight around a world that does, as wide or as high as that, and nowhere else.
    const TileMap& tiles(ShapeId shape) const;
    /// Changes a tile of such a map. What lies on it, or in line with it within 16 tiles, wakes; the rest sleeps on.
    void setTile(ShapeId shape, Cell cell, const Tile& tile);

    std::vector<BodyId> bodies() const;  ///< in the order of their slots
    std::vector<JointId> joints() const;
    const Wrap& wrap() const;  ///< as WorldDef has it
    Vec2 gravity() const;
    void setGravity(const Vec2& gravity);  ///< wakes every body [m/s^2]

    // What is where, now. Each looks at the shapes that collide with a shape of the filter; sensors are left out.
    /// The first shape on the way from one point to another.
    std::optional<CastHit> castRay(const Vec2& from, const Vec2& to, const Filter& filter = {}) const;
    /// All of them, in the order in which the ray comes to them.
    std::vector<CastHit> castRayAll(const Vec2& from, const Vec2& to, const Filter& filter = {}) const;
    /// The first shape that a shape meets as it is shifted, without turning.
    std::optional<CastHit> castShape(const Shape& shape, const Transform& pose, const Vec2& shift,
                                     const Filter& filter = {}) const;
    std::vector<CastHit> castShapeAll(const Shape& shape, const Transform& pose, const Vec2& shift,
                                      const Filter& filter = {}) const;
    /// The same, of a chain each of its pieces, but nothing of one body, where one is named.
    std::vector<CastHit> castShapePieces(const Shape& shape, const Transform& pose, const Vec2& shift,
                                         const Filter& filter = {}, BodyId ignored = {}) const;
    // Shapes that overlap or touch, in the order of their bodies' slots and their numbers.
    std::vector<ShapeId> overlapBox(const Aabb& box, const Filter& filter = {}) const;
    std::vector<ShapeId> overlapShape(const Shape& shape, const Transform& pose, const Filter& filter = {}) const;
    std::vector<ShapeId> overlapPoint(const Vec2& point, const Filter& filter = {}) const;
    /// The shape nearest to a point, of those no farther than within, >= 0, may be infinite [m].
    std::optional<Nearest> nearest(const Vec2& point, double within, const Filter& filter = {}) const;
    Distance distance(ShapeId a, ShapeId b) const;

    // What happened in the last step; valid until the next call that changes the world.
    std::span<const ContactBegin> contactBegins() const;
    std::span<const ContactEnd> contactEnds() const;
    std::span<const ContactHit> contactHits() const;
    std::span<const SensorBegin> sensorBegins() const;
    std::span<const SensorEnd> sensorEnds() const;
    std::span<const JointBroke> jointBreaks() const;
    std::span<const Quarantined> quarantines() const;
    std::vector<BodyMoved> moves() const;  ///< in the order of their slots; without those removed since
    StepProfile profile() const;

    /// Up to now. Throws std::invalid_argument unless WorldDef.ledger was set.
    Ledger ledger() const;

    void reserve(const Capacity& capacity);
    WorldCounts counts() const;  ///< takes a look at all there is

private:
    WorldState* state_;  ///< owned, null once moved from; no unique_ptr, for <memory> is slow to compile
};

}  // namespace plumb
