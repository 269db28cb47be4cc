// SPDX-License-Identifier: MIT
// What happens where two bodies meet, at a point or at both ends of a common face?
//
// One law for all that can meet: u' = u + K j, with u the speeds at which the points of B move against those of A,
// along the normal and along the tangent, j the impulses, K how the two bodies answer them. What answers is a body
// alone, one that nothing moves, or one that joints hold: MeetingBodies.
// - One point has a closed form, which treats slip and stick exactly: impact/impact.h.
// - Two points are solved together: what stops both, and the share e of these impulses once more (Poisson), so each
//   point that pushed parts at e times its approach. A box that lands flat has two equal points, and solving one after
//   the other would set it spinning; so the impulses are summed for each point, clamped in the sum, and corrected until
//   all conditions hold.
// e restitution [-]. Source: projected Gauss-Seidel, as in Catto, "Iterative dynamics with temporal coherence", GDC
// 2005. Test: "a ball at a vertical wall comes back alike, whoever solves the impact"
#pragma once
#include <span>

#include <plumb/impact/impact.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {

/// Of two bodies: impulses, or velocities, or changes of these; each along x, along y, turning.
struct OfBoth {
    Vec3 a{}, b{};
};

/// Two bodies that meet.
class MeetingBodies {
public:
    virtual ~MeetingBodies() = default;
    virtual OfBoth velocity() const = 0;
    /// By how much impulses would change their velocities.
    virtual OfBoth responseTo(const OfBoth& impulse) = 0;
    virtual void push(const OfBoth& impulse) = 0;
};

/// A body whose own mass alone answers. Inverse masses of 0: nothing moves it.
struct LooseBody {
    Vec3 velocity{};
    double inverseMass = 0, inverseInertia = 0;
};
class LooseBodies final : public MeetingBodies {
public:
    LooseBodies(const LooseBody& first, const LooseBody& second) : a(first), b(second) {}
    OfBoth velocity() const override { return {a.velocity, b.velocity}; }
    OfBoth responseTo(const OfBoth& impulse) override;
    void push(const OfBoth& impulse) override;

    LooseBody a, b;
};

/// Where they touch: from the centres of mass to the point [m].
struct MeetingPoint {
    Vec2 armA{0, 0}, armB{0, 0};
};

struct Meeting {
    double approachSpeed = 0;                      ///< of the fastest point [m/s]
    double normalImpulse = 0, tangentImpulse = 0;  ///< [N s]
    Vec2 onB{0, 0};                                ///< impulse [N s]
    /// Energy by friction, by what impulses do not move (belts, fixed bodies), and by the impulses along the normal
    /// [J].
    double friction = 0, drivers = 0, bounce = 0;

    void add(const Meeting& next);
};

/// Solves an impact at one or two points; normal: from A to B. resting: what approaches no faster than that over the
/// restitution does not bounce (see impact/detail/bounces.h); 0 if each bounce counts [m/s]. Nothing happens where
/// nothing approaches, or nothing can be moved, or an impulse would not be finite.
Meeting solveMeeting(std::span<const MeetingPoint> points, const Vec2& normal, const ImpactLaw& law, double resting,
                     MeetingBodies& bodies);

}  // namespace plumb
