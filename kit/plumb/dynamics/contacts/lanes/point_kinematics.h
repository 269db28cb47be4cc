// SPDX-License-Identifier: MIT
// How do two bodies move against each other at a point of a contact, and what does an impulse there change?
//
// For a contact point with normal n (from A to B), tangent t = perp(n), and anchors r: components along n and t, times
// rho, the inverse of the body's radius of gyration; w = omega / rho:
//   vn = n.(vB - vA) - rtB wB + rtA wA          speed at which it opens
//   vt = t.(vB - vA) + rnB wB - rnA wA          speed at which B's material slides along t
//   1/kn = mA (1 + rtA^2) + mB (1 + rtB^2)      effective inverse mass (mA, mB inverse masses), kt with rn
//   s = s0 + n.(dB - dA) + rotation terms       separation after the displacements dA, dB
// v velocity [m/s], s0 separation at the step's start [m]. The same code for one contact and for W side by side.
#pragma once
#include <plumb/dynamics/contacts/contact_batch.h>
#include <plumb/math/detail/wide_ops.h>
#include <plumb/math/detail/wide_rows.h>

namespace plumb {

/// The anchors of a point in W lanes, times rho, as in PointLanes.
template <int W>
struct LaneArms {
    using F = typename Wide<W>::Float;
    using M = typename Wide<W>::Mask;
    F normalA, tangentA, normalB, tangentB;

    [[gnu::always_inline]] static inline LaneArms of(const PointLanes& p, int lane) {
        return {loadLanes<W>(p.anchorNormalA + lane), loadLanes<W>(p.anchorTangentA + lane),
                loadLanes<W>(p.anchorNormalB + lane), loadLanes<W>(p.anchorTangentB + lane)};
    }
    void store(PointLanes& p, int lane) const {
        storeLanes(p.anchorNormalA + lane, normalA);
        storeLanes(p.anchorTangentA + lane, tangentA);
        storeLanes(p.anchorNormalB + lane, normalB);
        storeLanes(p.anchorTangentB + lane, tangentB);
    }
    void replace(M where, const LaneArms& by) {
        normalA = where ? by.normalA : normalA;
        tangentA = where ? by.tangentA : tangentA;
        normalB = where ? by.normalB : normalB;
        tangentB = where ? by.tangentB : tangentB;
    }
    F changeFrom(const LaneArms& other) const {
        return larger(larger(magnitude(normalA - other.normalA), magnitude(tangentA - other.tangentA)),
                      larger(magnitude(normalB - other.normalB), magnitude(tangentB - other.tangentB)));
    }

    /// For inverse masses of A and B.
    [[gnu::always_inline]] inline F normalInverse(F a, F b) const {
        return a * (tangentA * tangentA + 1.0F) + b * (tangentB * tangentB + 1.0F);
    }
    [[gnu::always_inline]] inline F tangentInverse(F a, F b) const {
        return a * (normalA * normalA + 1.0F) + b * (normalB * normalB + 1.0F);
    }
};

/// The two bodies of W contacts, and the normals. Of velocities, z is w = omega / rho, and w is the inverse mass; of
/// displacements, z and w are sin and cosMinus1. Always inlined: arguments of a call are passed through memory where
/// vectors are wide, and each lane has many.
template <int W>
struct BodyPair {
    using F = typename Wide<W>::Float;
    Rows<W> a, b;
    F nx, ny;

    [[gnu::always_inline]] static inline BodyPair of(const ContactBatch& batch, int lane, const float* rows) {
        return {loadRows<W>(rows, batch.bodyA + lane), loadRows<W>(rows, batch.bodyB + lane),
                loadLanes<W>(batch.normalX + lane), loadLanes<W>(batch.normalY + lane)};
    }
    /// Of velocities. Lanes of a batch share no body that moves, so that no store undoes another one. A wall may be in
    /// several: all of them store the row that they have loaded, because its inverse mass is 0.
    [[gnu::always_inline]] inline void store(const ContactBatch& batch, int lane, float* rows) const {
        storeRows<W>(rows, batch.bodyA + lane, a);
        storeRows<W>(rows, batch.bodyB + lane, b);
    }

    [[gnu::always_inline]] inline F normalSpeed(const LaneArms<W>& r) const {
        return (nx * (b.x - a.x) + ny * (b.y - a.y)) + (r.tangentA * a.z - r.tangentB * b.z);
    }
    [[gnu::always_inline]] inline F tangentSpeed(const LaneArms<W>& r) const {
        return (nx * (b.y - a.y) - ny * (b.x - a.x)) + (r.normalB * b.z - r.normalA * a.z);
    }

    /// An impulse at a point along the normal, on B, and the opposite one on A [N s]. One product with the inverse mass
    /// serves shift and spin, as w = omega / rho (see SolverVelocity). pushTangent is the same along perp(n).
    [[gnu::always_inline]] inline void pushNormal(const LaneArms<W>& r, F impulse) {
        const F ja = a.w * impulse, jb = b.w * impulse;
        a.x -= ja * nx;
        a.y -= ja * ny;
        a.z += ja * r.tangentA;
        b.x += jb * nx;
        b.y += jb * ny;
        b.z -= jb * r.tangentB;
    }
    [[gnu::always_inline]] inline void pushTangent(const LaneArms<W>& r, F impulse) {
        const F ja = a.w * impulse, jb = b.w * impulse;
        a.x += ja * ny;
        a.y -= ja * nx;
        a.z -= ja * r.normalA;
        b.x -= jb * ny;
        b.y += jb * nx;
        b.z += jb * r.normalB;
    }
    /// A torque impulse on B, and the opposite one on A [N m s].
    [[gnu::always_inline]] inline void twist(const ContactBatch& batch, int lane, F impulse) {
        a.z -= a.w * (loadLanes<W>(batch.rollInverseGyrationA + lane) * impulse);
        b.z += b.w * (loadLanes<W>(batch.rollInverseGyrationB + lane) * impulse);
    }

    /// Of displacements: s = s0 + n.(dB - dA) + (n.r)(c - 1) - (t.r) sin for B, minus the same for A. Here r reaches
    /// only to the shape without its rounding: while a disc rolls, its lowest point is always a different one, so only
    /// its centre's motion counts.
    [[gnu::always_inline]] inline F separation(const ContactBatch& batch, const PointLanes& p, int lane,
                                               const LaneArms<W>& r) const {
        const F shift = nx * (b.x - a.x) + ny * (b.y - a.y);
        const F innerA = r.normalA - loadLanes<W>(batch.roundA + lane);
        const F innerB = r.normalB + loadLanes<W>(batch.roundB + lane);
        const F turnA = innerA * a.w - r.tangentA * a.z;
        const F turnB = innerB * b.w - r.tangentB * b.z;
        return loadLanes<W>(p.startSeparation + lane) + (shift + (turnB - turnA));
    }
};

}  // namespace plumb
