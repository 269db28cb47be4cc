// SPDX-License-Identifier: MIT
// What does the textbook say the bodies of a scene do? As data, so that it can be written in a file.
#pragma once
#include <string>
#include <variant>
#include <vector>

#include <compare/formula/flights.h>
#include <plumb/math/vec2.h>

namespace plumb::compare {

/// Flights joined at impacts, in the order of their starts. Each flight holds until the next one starts.
struct PiecewiseMotion {
    std::string body{};
    std::vector<Flight> flights{};
};

/// dv/dt = g - k v: x = x0 + (v0 - g/k) (1 - e^(-k t)) / k + g t / k.
struct DampedFlight {
    std::string body{};
    Vec2 position{0, 0};      ///< [m]
    Vec2 velocity{0, 0};      ///< [m/s]
    Vec2 acceleration{0, 0};  ///< g [m/s^2]
    double damping = 0;       ///< k, > 0 [1/s]
};

/// On which side of straight down does a pendulum swing? If it hits others at the bottom, they take over its motion.
enum class Side {
    Both,
    Left,   ///< the rest of the time it hangs still
    Right,  ///< the rest of the time it hangs still
};

/// A body that swings about a fixed point, released at rest: theta'' = -(g / L) sin theta, theta from straight down.
struct PendulumMotion {
    std::string body{};
    Vec2 pivot{0, 0};             ///< [m]
    double length = 1;            ///< from the pivot to the body's origin [m]
    double equivalentLength = 1;  ///< L = I_pivot / (m l): equal to length for a point mass [m]
    double gravity = 9.81;        ///< [m/s^2]
    double amplitude = 0.5;       ///< theta at t = 0; positive to the right [rad]
    double bodyAngle = 0;         ///< of the body at t = 0; it turns with theta if turns is true [rad]
    bool turns = true;            ///< false for a bob on a rod that lets the bob keep its angle
    double from = 0;              ///< not 0: when it passes straight down, on its way up to amplitude [s]
    Vec2 approach{0, 0};          ///< its velocity before that, on a straight way; 0: it hangs there until then [m/s]
    Side side = Side::Both;
};

/// A mass on a spring and a damper, about its place of rest: m x'' = -k x - c x', along a line.
struct OscillatorMotion {
    std::string body{};
    Vec2 rest{0, 0};       ///< where it comes to rest [m]
    Vec2 direction{0, 1};  ///< of x, a unit vector [-]
    double offset = 0;     ///< x at t = 0 [m]
    double speed = 0;      ///< x' at t = 0 [m/s]
    double mass = 1;       ///< m [kg]
    double stiffness = 1;  ///< k, > 0 [N/m]
    double damping = 0;    ///< c, >= 0 [N s/m]
};

/// A body that falls from rest in air, whose drag grows with the square of the speed:
/// x = x0 - (v_t^2 / g) ln cosh(g t / v_t), with the terminal speed v_t.
struct DragFall {
    std::string body{};
    Vec2 position{0, 0};       ///< x0 [m]
    double terminalSpeed = 1;  ///< > 0 [m/s]
    double gravity = 9.81;     ///< downward, > 0 [m/s^2]
};

/// An ellipse about a focus, for an attraction by the inverse square of the distance. With e = 1 the body falls
/// straight in, and the motion holds until it arrives.
struct KeplerMotion {
    std::string body{};
    Vec2 focus{0, 0};          ///< at t = 0 [m]
    Vec2 drift{0, 0};          ///< velocity of the focus [m/s]
    Vec2 nearEnd{1, 0};        ///< from the focus to the near end, a unit vector [-]
    double semiMajorAxis = 1;  ///< > 0 [m]
    double eccentricity = 0;   ///< 0 to 1 [-]
    double period = 1;         ///< > 0 [s]
    double since = 0;          ///< time since the near end at t = 0, counter-clockwise [s]
};

// The motions below hold names and the values that are not in the scene. Their numbers are computed from the bodies,
// joints and fields that they name, and give one of the motions above. So a value changed in the scene changes the
// truth.

/// A free body under gravity and drag that meets faces and other free bodies: flights, impacts, sliding, rolling and
/// rest of discs, and of blocks that do not turn.
struct FreeMotion {
    std::string body{};
    double shortestFlight = 1.0 / 30;  ///< a first flight off a face shorter than this counts as rest, > 0 [s]
};

/// On a hinge, or on parallel rods, released at rest; or pushed by what hits it at its lowest point.
struct SwingsMotion {
    std::string body{};
    std::string joint{};     ///< a hinge or a rod to a body that does not move
    Side side = Side::Both;  ///< in a row of equal discs, each swings on its own side and stops at the lowest point
    std::string after{};     ///< the body whose swing it takes over there; empty: its own swing
};

/// On a spring and damper, along their line.
struct SpringsMotion {
    std::string body{};
    std::string joint{};  ///< a distance joint with a spring, to a body that does not move
};

/// Up and down in water, upright.
struct FloatsMotion {
    std::string body{};
    std::string field{};  ///< a pool
};

/// About another body that attracts it by the inverse square of the distance.
struct OrbitsMotion {
    std::string body{};
    std::string field{};  ///< mutual gravity, or a magnet of power 2; between two bodies
};

/// On one end of a rope over two wheels.
struct HoistedMotion {
    std::string body{};
    std::string joint{};  ///< a pulley
};

/// Driven by one motor through gears.
struct GearedMotion {
    std::string body{};
    std::string joint{};  ///< its hinge or slide, to a body that does not move
};

/// A bullet that stays in a block on rods, or the block itself.
struct CaughtMotion {
    std::string body{};  ///< the bullet or the block
    std::string bullet{}, block{};
};

/// It stays where it starts, because joints hold it in balance.
struct RestsMotion {
    std::string body{};
};

using BodyMotion = std::variant<PiecewiseMotion, DampedFlight, PendulumMotion, OscillatorMotion, DragFall, KeplerMotion,
                                FreeMotion, SwingsMotion, SpringsMotion, FloatsMotion, OrbitsMotion, HoistedMotion,
                                GearedMotion, CaughtMotion, RestsMotion>;

struct ClosedForm {
    std::string formula{};             ///< in plain text, for the report
    std::string source{};              ///< where it comes from
    double until = 0;                  ///< holds from t = 0 to here; 0: to the scene's end [s]
    std::vector<BodyMotion> bodies{};  ///< those that have a closed form
};

}  // namespace plumb::compare
