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
/// a sensor where it is under water. A GroundFriction with a lever of 0 takes that of a disc of the body's inertia. A
/// magnet whose carrier is disabled or gone draws nothing. Mutual gravity takes time as the square of the bodies: 50 ms
/// a step for a thousand.
using FieldLaw = std::variant<UniformGravity, MutualGravity, Drag, Attractor, Magnet, Pool, GroundFriction>;

/// What acts on bodies wherever they are, for as long as it is there. Where there are several, they add up. What
/// nothing touches goes by velocity Verlet in double at every sub-step, of second order: an orbit keeps its energy;
/// drag and friction never turn anything back, and a terminal speed is steady. Uniform gravity and linear drag that
/// fill the world are closed forms, exact to rounding. What a field does not reach goes as if it were not there, to
/// the last bit. What mutual gravity, or a magnet that is awake, draws does not fall asleep. A step of less than a
/// nanosecond feels nothing.
struct FieldDef {
    FieldLaw law = UniformGravity{};
    /// Only on what has its centre of mass here; in the world, with an area [m]
    std::optional<Shape> region = std::nullopt;
    Filter filter = {};  ///< only on what has a shape that collides with a shape of this
};

/// Throws std::invalid_argument naming the field, the value and what was wanted, as far as no world is needed to tell:
/// the body that carries a magnet is not looked at.
void validate(const FieldDef& def);

}  // namespace plumb
