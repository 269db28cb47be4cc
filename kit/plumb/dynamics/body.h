// SPDX-License-Identifier: MIT
// Where is a body, and how does it move?
#pragma once
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
};

/// What presses on a body.
struct Contact {
    BodyId bodyA, bodyB;
    Vec2 normal{0, 1};                 ///< from A to B [-]
    std::vector<ContactPoint> points;  ///< one or two
};

/// A view of one body of a world; valid while the body and its world are, and gets what is true when it is asked.
/// Setters throw std::invalid_argument on a value that is not finite, and wake the body.
class Body {
public:
    BodyType type() const;
    Vec2 position() const;           ///< of the body's origin [m]
    double angle() const;            ///< counted on through whole turns [rad]
    Transform pose() const;          ///< local to world
    Vec2 centerOfMass() const;       ///< in the world [m]
    Vec2 velocity() const;           ///< of the centre of mass [m/s]
    double angularVelocity() const;  ///< [rad/s]
    double mass() const;             ///< 0 unless dynamic [kg]
    double inertia() const;          ///< about the centre of mass; 0 unless dynamic [kg m^2]
    bool awake() const;
    bool quarantined() const;

    /// What touches the body, with the forces of the last step.
    std::vector<Contact> contacts() const;

    void setVelocity(const Vec2& velocity);                  ///< [m/s]
    void setAngularVelocity(double angularVelocity);         ///< [rad/s]
    void setPose(const Vec2& position, double angle);        ///< a jump, no motion in between [m, rad]
    void applyForce(const Vec2& force);                      ///< at the centre of mass, over the next step [N]
    void applyForce(const Vec2& force, const Vec2& at);      ///< at a point of the world, over the next step [N, m]
    void applyTorque(double torque);                         ///< over the next step [N m]
    void applyImpulse(const Vec2& impulse);                  ///< at the centre of mass, now [N s]
    void applyImpulse(const Vec2& impulse, const Vec2& at);  ///< at a point of the world, now [N s, m]

private:
    friend class World;
    Body(WorldState& world, std::uint32_t index) : world_(&world), index_(index) {}
    WorldState* world_;
    std::uint32_t index_;
};

}  // namespace plumb
