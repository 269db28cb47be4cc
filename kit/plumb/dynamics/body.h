// SPDX-License-Identifier: MIT
// Where is a body, and how does it move?
#pragma once
#include <optional>
#include <vector>

#include <plumb/dynamics/body_def.h>
#include <plumb/dynamics/id.h>
#include <plumb/math/transform.h>

namespace plumb {

struct WorldState;

struct ContactPoint {
    Vec2 position{0, 0};       ///< in the world [m]
    double separation = 0;     ///< negative when the shapes overlap [m]
    double normalForce = 0;    ///< mean over the last step, >= 0 [N]
    double frictionForce = 0;  ///< mean over the last step, along the normal turned a quarter turn left, on B [N]
    std::optional<Cell> tile = std::nullopt;  ///< the touched cell, if one of the two shapes is a tile map
};

/// A contact of a body with another.
struct Contact {
    ShapeId shapeA, shapeB;
    Vec2 normal{0, 1};                 ///< from A to B [-]
    std::vector<ContactPoint> points;  ///< one or two
};

/// A read-only view of one body of a world, valid as long as the world exists; each call returns the present value, and
/// throws std::invalid_argument once the body was removed.
class BodyView {
public:
    BodyId id() const;
    BodyType type() const;
    Vec2 position() const;                     ///< of the body's origin [m]
    double angle() const;                      ///< counts whole turns too [rad]
    Transform pose() const;                    ///< local to world
    Vec2 centerOfMass() const;                 ///< in the world [m]
    Vec2 velocity() const;                     ///< of the centre of mass [m/s]
    double angularVelocity() const;            ///< [rad/s]
    Vec2 velocityAt(const Vec2& point) const;  ///< of a point of the world that moves with the body [m/s]
    double mass() const;                       ///< 0 unless dynamic [kg]
    double inertia() const;                    ///< about the centre of mass; 0 unless dynamic [kg m^2]
    double gravityScale() const;               ///< [-]
    double linearDamping() const;              ///< [1/s]
    double angularDamping() const;             ///< [1/s]
    bool awake() const;
    bool enabled() const;
    bool quarantined() const;
    std::uint64_t tag() const;

    std::vector<ShapeId> shapes() const;  ///< in the order in which they were added
    std::vector<JointId> joints() const;
    /// The contacts of the body, with the forces of the last step.
    std::vector<Contact> contacts() const;

protected:
    friend class World;
    BodyView(WorldState& world, BodyId id) : world_(&world), id_(id) {}
    std::uint32_t index() const;  ///< the slot; throws std::invalid_argument if it was removed
    WorldState* world_;
    BodyId id_;
};

/// A view that can also change the body, at any time between steps. Sleeping bodies that a change affects wake. Each
/// call throws std::invalid_argument, and changes nothing, on a value that is not finite or that the body cannot have.
class Body : public BodyView {
public:
    void setVelocity(const Vec2& velocity);            ///< [m/s]
    void setAngularVelocity(double angularVelocity);   ///< [rad/s]
    void setPose(const Vec2& position, double angle);  ///< a jump, no motion in between [m, rad]
    /// Gives a kinematic body the velocity that moves it there in a step of dt. It keeps this velocity until it gets
    /// another.
    void moveTo(const Vec2& position, double angle, double dt);  ///< [m, rad, s]
    // Pushes act on dynamic bodies alone, and are refused for others.
    void applyForce(const Vec2& force);                      ///< at the centre of mass, over the next step [N]
    void applyForce(const Vec2& force, const Vec2& at);      ///< at a point of the world, over the next step [N, m]
    void applyTorque(double torque);                         ///< over the next step [N m]
    void applyImpulse(const Vec2& impulse);                  ///< at the centre of mass, now [N s]
    void applyImpulse(const Vec2& impulse, const Vec2& at);  ///< at a point of the world, now [N s, m]
    void applyAngularImpulse(double impulse);                ///< now [N m s]

    // A change of type or mass keeps the body's position and the velocity of each of its points.
    void setType(BodyType type);             ///< a static body loses its velocity; a dynamic one needs a mass
    void setMass(const Mass& mass);          ///< of a dynamic body, instead of what its shapes give
    void setMassFromShapes();                ///< of a dynamic body
    void setGravityScale(double scale);      ///< [-]
    void setLinearDamping(double damping);   ///< >= 0 [1/s]
    void setAngularDamping(double damping);  ///< >= 0 [1/s]
    void setFixedRotation(bool fixed);
    void setLocks(bool lockX, bool lockY);  ///< as BodyDef.lockX and lockY, at its present position
    void setCanSleep(bool canSleep);
    void wake();
    void sleep();                   ///< with all bodies that touch it or are joined to it, until something wakes them
    void setEnabled(bool enabled);  ///< false: it stays where it is, and touches nothing; true: it moves on
    void setTag(std::uint64_t tag);

private:
    friend class World;
    using BodyView::BodyView;
};

}  // namespace plumb
