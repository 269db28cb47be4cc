// SPDX-License-Identifier: MIT
// How does a disc slide or roll along a chain, from vertex to vertex?
//
// The disc's centre moves on the chain's offset path: along each segment at a fixed distance, and around the vertices.
// On a segment, the acceleration along it is constant:
//   v'^2 = v^2 + 2 a s,  t = 2 s / (v + v')
//   v speed [m/s], a acceleration along the segment [m/s^2], s arc length [m], t time [s]
// At a vertex that turns towards the disc (concave), the impact takes the speed along the next segment's normal:
//   v' = v cos(turn)
// Around a vertex that turns away (convex), the centre moves on an arc without loss, by the same formulas with the
// mean acceleration along the arc.
// A disc that rolls has k = I / (m r^2) as inertia along the path. Its acceleration along the path is divided by 1 + k,
// and at a concave vertex its angular momentum about the new contact point stays:
//   v' = v (k + cos(turn)) / (1 + k)
// A disc that slides has k = 0.
// Source: impact without restitution, e.g. Brogliato, "Nonsmooth Mechanics", 3rd ed. 2016, ch. 4.
// Holds: no damping, no slip with friction, a chain that does not move. Exact, but for the time on an arc: its error is
// of third order in the arc's length. Test: "a ball keeps the energy that a bowl of 30 to 10,000 segments leaves it"
#pragma once
#include <optional>
#include <span>

#include <plumb/math/transform.h>
#include <plumb/space/detail/space.h>

namespace plumb {

/// The segments of a chain, as a disc on one of its sides sees them.
struct ChainSide {
    const Space* space = nullptr;
    std::span<const ProxyId> pieces;  ///< in order along the chain
    Transform pose;                   ///< of the chain's body
    double side = 1;                  ///< 1 for a disc on the left of the chain, -1 on the right [-]
    double offset = 0;                ///< distance of the disc's centre from the chain [m]
};

/// Where on the path is the disc's centre, and how fast is it?
struct ChainPlace {
    std::size_t edge = 0;   ///< index in ChainSide.pieces
    bool onArc = false;     ///< it goes around a vertex, towards the edge
    Vec2 position{0, 0};    ///< [m]
    Vec2 direction{1, 0};   ///< of the path, unit; along the chain, even if the disc moves backwards [-]
    double speed = 0;       ///< along the direction [m/s]
    double distance = 0;    ///< since the start, backwards negative [m]
    bool onCurve = false;   ///< a segment on the way has a vertex that turns
    std::size_t first = 0;  ///< lowest edge on the way
    std::size_t last = 0;   ///< highest edge on the way
};

/// The forces on the disc, and which impacts make it bounce.
struct ChainLaw {
    Vec2 acceleration{0, 0};  ///< [m/s^2]
    double inertia = 0;       ///< k of a disc that rolls, 0 for one that slides [-]
    double friction = 0;      ///< if it rolls [-]
    double restitution = 0;   ///< [-]
    double restingSpeed = 0;  ///< a slower bounce is none [m/s]
};

/// The place after a time [s]. Empty if the disc does something else: it leaves the chain, comes to its end or to a
/// corner, bounces, slips, or comes to rest.
std::optional<ChainPlace> slideAlong(const ChainSide& chain, const ChainPlace& from, const ChainLaw& law, double time);

/// A segment of a chain in the world.
struct ChainEdge {
    Vec2 start, end;
    Vec2 along;  ///< unit [-]
    double length = 0;
};
ChainEdge chainEdge(const ChainSide& chain, std::size_t edge);

}  // namespace plumb
