// SPDX-License-Identifier: MIT
// Which forces fill a world, or a region of it?
#pragma once
#include <optional>
#include <variant>

#include <plumb/dynamics/id.h>
#include <plumb/forces/attractor.h>
#include <plumb/forces/buoyancy.h>
#include <plumb/forces/drag.h>
#include <plumb/forces/explosion.h>
#include <plumb/forces/friction.h>
#include <plumb/forces/gravity.h>
#include <plumb/space/shape_def.h>

namespace plumb {

/// An attractor that a body carries. The body gets the reaction of its pull on the others.
struct Magnet {
    BodyId body = {};     ///< of any type
    Attractor pull = {};  ///< its centre in the body's frame
};

/// Water, with buoyancy and drag. Drag and flow act on the part below the surface: dv/dt = -(drag A / m) (v - flow),
/// and in the same way on turning. A that part's area [m^2], m the body's mass [kg]
struct Pool {
    Fluid fluid = {};
    double drag = 0;  ///< >= 0 [kg/(m^2 s)]
    Vec2 flow{0, 0};  ///< [m/s]
};

/// Each law acts on dynamic bodies, at their centres of mass. Only a pool acts on each of their shapes, except sensors,
/// at the part that is under water. A GroundFriction with a lever of 0 uses the lever of a disc with the body's moment
/// of inertia. A magnet whose carrier is disabled or removed attracts nothing. The time of mutual gravity grows as the
/// square of the number of bodies: 50 ms per step for a thousand.
using FieldLaw = std::variant<UniformGravity, MutualGravity, Drag, Attractor, Magnet, Pool, GroundFriction>;

/// A force that acts on bodies by their position, as long as the field exists. Several fields add up. A body that
/// nothing touches moves by velocity Verlet in double at every sub-step, which is of second order: an orbit keeps its
/// energy; drag and friction never reverse a velocity, and a terminal speed is steady. Uniform gravity and linear drag
/// that fill the world are closed forms, exact to rounding. A body that a field does not reach moves bitwise as if the
/// field did not exist. Bodies that mutual gravity, or an awake magnet, attracts do not fall asleep. In a step of less
/// than a nanosecond fields do not act.
struct FieldDef {
    FieldLaw law = UniformGravity{};
    /// acts only on bodies with their centre of mass in this shape; in world coordinates, with an area [m]
    std::optional<Shape> region = std::nullopt;
    Filter filter = {};  ///< acts only on bodies with a shape that collides with a shape of this filter
};

/// Throws std::invalid_argument that names the field, the value and what is allowed. Checks only what does not depend
/// on a world: not the body that carries a magnet.
void validate(const FieldDef& def);

}  // namespace plumb
