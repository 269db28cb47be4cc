// SPDX-License-Identifier: MIT
// Which properties of a free body matter, and how does it move until the next event?
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <compare/closed_form/free/obstacles.h>
#include <compare/scene/closed_form.h>
#include <plumb/shapes/mass.h>

namespace plumb::compare {

/// The state of one body in the calculation. Its flight is that of its centre of mass.
struct FreeBody {
    const SceneBody* scene = nullptr;
    std::size_t index = 0;             ///< in the scene
    double inverseMass = 1;            ///< [1/kg]
    double inverseInertia = 1;         ///< 0 if it never turns [1/(kg m^2)]
    Vec2 center{0, 0};                 ///< centre of mass, from the body's origin, in its frame [m]
    Vec2 gravity{0, 0};                ///< its acceleration when nothing touches it [m/s^2]
    std::optional<double> radius{};    ///< of a single disc about its centre of mass; empty: another shape [m]
    std::vector<Vec2> hull{};          ///< of another shape: its corners at its angle, from the centre of mass [m]
    double skin = 0;                   ///< the radius of its corners [m]
    double reach = 0;                  ///< of its farthest point from the centre of mass [m]
    Surface surface{};                 ///< its solid shape; the first if there are several
    bool simple = true;                ///< it has only one solid shape
    double shortestFlight = 0;         ///< [s]
    Obstacles obstacles{};             ///< those that it may meet
    Flight flight{};                   ///< the present one
    const Face* face = nullptr;        ///< the face that it lies, slides or rolls on
    std::optional<double> slipEnds{};  ///< when it stops slipping on the face [s]
    double pressedAt = 0;              ///< where the face presses, along the face from the centre of mass [m]
    std::vector<Flight> flights{};     ///< the flights so far
};

/// The flight of the centre of mass from a time on.
Flight flightAt(const Flight& flight, double time);

/// The values for two surfaces, mixed as the engines mix them.
struct PairLaw {
    double friction = 0, restitution = 0;  ///< [-]
    double belts = 0;                      ///< how fast the belt of one carries the other along its face [m/s]
};
PairLaw lawOf(const ShapeDef& a, const ShapeDef& b);

/// Throws Unsupported: "closedForm.bodies.block: <why>, and no formula is known here".
[[noreturn]] void notKnown(const std::string& body, const std::string& why);

/// The slip of a body on its face: the velocity of its surface along the face, relative to the face [m/s].
double slipOf(const FreeBody& body, const Flight& now);

/// Sets the acceleration of a body from now on, in flight or on a face. By Coulomb's law it slides, with
/// a = g (sin t - mu cos t) on an incline, or rolls, or sticks.
///   N = -m g.n;  sliding F = -mu N sign(s);  rolling F = -m g.t / (1 + m r^2 / I);  sticking F = -m g.t
///   a = g + (N n + F t) / m,  turning at F r / I
/// n normal and t tangent of the face, s slip [m/s], m mass [kg], r radius [m], I inertia [kg m^2], mu friction [-]
/// Source: textbook; Coulomb. Tests: follows_test.cpp. Holds while N > 0, and while a block's pressure stays under it:
/// x = -h F / N within its base, h height of its centre [m]. Throws Unsupported if it does not: the block tips over.
void setAcceleration(FreeBody& body);

/// n from A to B at the point where the two meet, with radii to there. a is null for a body that does not give way.
///   j = -(1 + e) vn / (1/mA + 1/mB), across it f = -s / (1/mA + 1/mB + rA^2/IA + rB^2/IB), at most mu j
/// Source: Newton's law of impact, Coulomb's of friction; Routh 1905. Tests: follows_test.cpp
void collide(FreeBody& b, FreeBody* a, const Vec2& velocityA, const Vec2& normal, const PairLaw& law);

/// A body at its start, with the obstacles that it may meet. Throws Unsupported if a joint or a lock holds it, if a
/// field acts on it that is not uniform, or if there is no formula here for its shapes.
FreeBody freeBodyOf(const Scene& scene, const FreeMotion& motion);

/// The effect of the air on a body: dv/dt = -(linear v) / m - (quadratic |v| v) / m, v relative to the wind.
struct Air {
    double linear = 0;     ///< [kg/s]
    double quadratic = 0;  ///< [kg/m]
    Vec2 wind{0, 0};       ///< [m/s]
};
Air airAt(const Scene& scene, const BodyDef& def);

/// True if the filter of a field lets it act on a body, everywhere. Throws Unsupported for a field that acts in a
/// region.
bool actsOn(const SceneField& field, const SceneBody& body);

}  // namespace plumb::compare
