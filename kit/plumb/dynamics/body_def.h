// SPDX-License-Identifier: MIT
// With which state and properties does a body start?
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <plumb/dynamics/lock.h>
#include <plumb/shapes/mass.h>
#include <plumb/space/shape_def.h>

namespace plumb {

enum class BodyType {
    Static,     ///< never moves
    Kinematic,  ///< moves at its velocity; nothing pushes it
    Dynamic,    ///< moves by forces and collisions
};

struct BodyDef {
    BodyType type = BodyType::Dynamic;
    Vec2 position{0, 0};         ///< of the body's origin [m]
    double angle = 0;            ///< [rad]
    Vec2 velocity{0, 0};         ///< of the centre of mass; zero for a static body [m/s]
    double angularVelocity = 0;  ///< zero for a static body [rad/s]
    double gravityScale = 1;     ///< [-]
    double linearDamping = 0;    ///< v decays as exp(-damping t), >= 0 [1/s]
    double angularDamping = 0;   ///< >= 0 [1/s]
    bool fixedRotation = false;  ///< true: it never turns
    Lock lockX = {};             ///< a dynamic body does not move along x, whatever pushes it
    Lock lockY = {};             ///< the same along y
    bool canSleep = true;
    bool awake = true;      ///< false: asleep until something touches it
    bool enabled = true;    ///< false: it stays where it is, and touches nothing
    std::uint64_t tag = 0;  ///< any number by which the user recognises the body
    std::optional<Mass> mass =
        std::nullopt;  ///< instead of the mass of the shapes and their densities; mass > 0, inertia > 0
    std::vector<ShapeDef> shapes =
        {};  ///< a dynamic body needs a mass: from a shape with area and density, or from mass
};

/// The mass of the body: def.mass, or else that of its shapes together.
Mass massOf(const BodyDef& def);

/// Throws std::invalid_argument that names the field, the value and what is allowed. field: the name of the def itself.
void validate(const BodyDef& def, const std::string& field);

}  // namespace plumb
