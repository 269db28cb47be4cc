// SPDX-License-Identifier: MIT
// How does a set of bodies move on from one tick to the next?
#pragma once
#include <concepts>
#include <optional>
#include <span>
#include <vector>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/body.h>
#include <plumb/dynamics/body_def.h>
#include <plumb/dynamics/body_shape.h>
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
#include <plumb/math/overload.h>
#include <plumb/shapes/aabb.h>

namespace plumb {

/// Bodies, their contacts, joints and fields. A world may wrap around (be periodic). Then any position may be given; it
/// stands for all its images, which are whole periods away. Where there is a choice, as for anchors, the nearest image
/// is used. Returned positions are in [0, width) and [0, height). A copy continues bitwise as the original would, and
/// its objects have the same ids. A moved-from world can only be assigned to or destroyed. Every call that takes a def
/// or an id throws std::invalid_argument if it is not valid in this world, and then changes nothing.
class World {
public:
    explicit World(const WorldDef& def = {});
    explicit World(detail::EmptyBraces) : World() {}
    template <std::same_as<Vec2> Gravity>
    explicit World(const Gravity&) {
        static_assert(detail::never<Gravity>, "name the gravity: write World({.gravity = {0, -9.81}})");
    }
    World(const World& other);
    World(World&&) noexcept;
    World& operator=(const World& other);
    World& operator=(World&&) noexcept;
    ~World();

    BodyId add(const BodyDef& def);  // no match? add(BodyDef{...}) makes the compiler name the member
    template <std::same_as<ShapeDef> Def>
    BodyId add(const Def&) {
        static_assert(detail::never<Def>, "a shape belongs to a body: write add({.shapes = {circle(0.5)}})");
        return {};
    }
    template <detail::AlternativeOf<JointDef> Def>
    BodyId add(const Def&) {
        static_assert(detail::never<Def>, "a joint joins bodies: write join(RevoluteJointDef{...})");
        return {};
    }
    ShapeId add(BodyId body, const ShapeDef& shape);  ///< updates the mass, unless it was given
    JointId join(const JointDef& def);
    JointId join(const detail::JointOfNoKind&) = delete;  // name it: join(RevoluteJointDef{.bodyA = a, .bodyB = b})
    void remove(BodyId body);                             ///< with its shapes and joints
    void remove(ShapeId shape);                           ///< updates the mass, unless it was given
    void remove(JointId joint);                           ///< with the gears that it drives

    /// Forces that fill the world or a region of it. Adding, changing or removing a field wakes the bodies on which it
    /// acts.
    FieldId addField(const FieldDef& def);
    template <detail::AlternativeOf<FieldLaw> Law>
    FieldId addField(const Law&) {
        static_assert(detail::never<Law>, "name the law: write addField({.law = Drag{...}})");
        return {};
    }
    void remove(FieldId field);
    /// Pushes dynamic bodies at once: each shape that is not a sensor and collides with a shape of the filter. The
    /// impulse is proportional to the shape's width as seen from the explosion, and acts at its nearest point.
    void explode(const Explosion& explosion, const Filter& filter = {});

    /// Moves the world forward by dt, at most 1 [s]. Throws std::invalid_argument only if dt is negative, longer or not
    /// finite.
    void step(double dt);

    bool contains(BodyId body) const;
    bool contains(ShapeId shape) const;
    bool contains(JointId joint) const;
    bool contains(FieldId field) const;

    // Views, through which objects are read and changed. Those of a world that is const can only be read.
    Body body(BodyId body);
    BodyView body(BodyId body) const;
    BodyShape shape(ShapeId shape);
    BodyShapeView shape(ShapeId shape) const;
    Joint joint(JointId joint);
    JointView joint(JointId joint) const;
    Field field(FieldId field);
    FieldView field(FieldId field) const;
    std::vector<BodyId> bodies() const;   ///< in the order of their slots
    std::vector<ShapeId> shapes() const;  ///< in the order of their bodies' slots and their numbers
    std::vector<JointId> joints() const;  ///< in the order of their slots
    std::vector<FieldId> fields() const;  ///< in the order of their slots

    /// The map of a shape that is a tile map; valid until the next call that changes the world. The map wraps if it
    /// lies unrotated in a world that wraps and is as wide or as high as the world; otherwise it has ends.
    const TileMap& tiles(ShapeId shape) const;
    /// Changes a tile of such a map. Bodies that lie on it, or in line with it within 16 tiles, wake; others stay
    /// asleep.
    void setTile(ShapeId shape, Cell cell, const Tile& tile);

    const Wrap& wrap() const;  ///< as given in WorldDef
    Vec2 gravity() const;
    void setGravity(const Vec2& gravity);  ///< wakes every body [m/s^2]

    // Queries of the present state. Each considers only shapes that collide with a shape of the filter, and no sensors.
    // Casts leave out the shapes of the ignored body, if given: for example, of the body from whose inside a ray
    // starts.
    /// The first shape on the way from one point to another.
    std::optional<CastHit> castRay(const Vec2& from, const Vec2& to, const Filter& filter = {},
                                   BodyId ignored = {}) const;
    /// All shapes on the way, in the order in which the ray meets them.
    std::vector<CastHit> castRayAll(const Vec2& from, const Vec2& to, const Filter& filter = {},
                                    BodyId ignored = {}) const;
    /// The first shape that a shape meets when it is shifted without turning.
    std::optional<CastHit> castShape(const Shape& shape, const Transform& pose, const Vec2& shift,
                                     const Filter& filter = {}, BodyId ignored = {}) const;
    std::vector<CastHit> castShapeAll(const Shape& shape, const Transform& pose, const Vec2& shift,
                                      const Filter& filter = {}, BodyId ignored = {}) const;
    /// Same as castShapeAll, but with a hit for each piece of a chain.
    std::vector<CastHit> castShapePieces(const Shape& shape, const Transform& pose, const Vec2& shift,
                                         const Filter& filter = {}, BodyId ignored = {}) const;
    // Shapes that overlap or touch, in the order of their bodies' slots and their numbers.
    std::vector<ShapeId> overlapBox(const Aabb& box, const Filter& filter = {}) const;
    std::vector<ShapeId> overlapShape(const Shape& shape, const Transform& pose, const Filter& filter = {}) const;
    std::vector<ShapeId> overlapPoint(const Vec2& point, const Filter& filter = {}) const;
    /// The shape nearest to a point, at a distance of at most within, >= 0, may be infinite [m].
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
    std::vector<BodyMoved> moves() const;  ///< in the order of their slots; without bodies removed since the step
    StepProfile profile() const;

    /// The ledger up to now. Throws std::invalid_argument unless WorldDef.ledger was set.
    Ledger ledger() const;

    void reserve(const Capacity& capacity);
    WorldCounts counts() const;  ///< takes time: it goes through all objects

private:
    WorldState* state_ = nullptr;  ///< owned; null once moved from (a std::unique_ptr would double this header)
};

}  // namespace plumb
