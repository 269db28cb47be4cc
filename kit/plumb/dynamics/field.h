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

/// An attractor that a body carries, and that pulls on it as it pulls on the others.
struct Magnet {
    BodyId body = {};     ///< of any type
    Attractor pull = {};  ///< its centre in the body's frame
};

/// Water: it bears what is in it, and holds it back. Its drag and its flow act on the part below the surface:
/// dv/dt = -(drag A / m) (v - flow), and turning likewise. A that part's area [m^2], m the body's mass [kg]
struct Pool {
    Fluid fluid = {};
    double drag = 0;  ///< >= 0 [kg/(m^2 s)]
    Vec2 flow{0, 0};  ///< [m/s]
};

/// Each acts on dynamic bodies, at their centres of mass, but for a pool, which bears every shape of theirs that is not
/// a sensor where it is under water. A GroundFriction with a lever of 0 takes that of a disc of the body's inertia.
using FieldLaw = std::variant<UniformGravity, MutualGravity, Drag, Attractor, Magnet, Pool, GroundFriction>;

/// What acts on bodies wherever they are, at every sub-step, for as long as it is there. Where there are several, they
/// add up. What nothing touches goes by velocity Verlet in double: of second order, an orbit keeps its energy; drag and
/// damping, whose strength is that at mid-way, and friction act with it exactly, and so never turn anything back.
/// What mutual gravity, or a magnet that is awake, draws does not fall asleep.
struct FieldDef {
    FieldLaw law = UniformGravity{};
    /// Only on what has its centre of mass here; in the world, with an area [m]
    std::optional<Shape> region = std::nullopt;
    Filter filter = {};  ///< only on what has a shape that collides with a shape of this
};

}  // namespace plumb
