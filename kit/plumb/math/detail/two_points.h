// SPDX-License-Identifier: MIT
// Which impulses act at the two points of a contact, solved together?
//
// Along the normal: a point's speed v changes with the impulses L of both, and no point may pull:
//   v_i + K_ii (L_i - old_i) + K_ij (L_j - old_j) + bias_i + e_i K_ii L_i = 0 where L_i > 0; >= 0 where L_i = 0
//   K_ij = mA (1 + a_i a_j) + mB (1 + b_i b_j)
// m inverse masses, a and b the tangential parts of the anchors on A and B times rho (see contact_solver.h), old the
// impulses so far, e softness, share = 1 / (1 + e). Four cases, of which one holds: both push, one of them, none.
// Solved one after the other, the two would turn a plank that falls flat, and a mirror would change the result.
// Along the tangent both points lie on one line: they get one impulse, limited by the sum of their limits, and share
// it as those. Source: Cottle, Pang, Stone, "The linear complementarity problem", 1992; Catto, "Iterative dynamics",
// GDC 2005. Test: "a plank that falls flat stays flat"
#pragma once
#include <plumb/math/detail/wide_ops.h>

namespace plumb {

/// The same code for one contact and for several: F is a float, a double, or a vector of them.
template <class F>
struct TwoPoints {
    /// A number of each point.
    struct Each {
        F at[2];
    };

    /// By how much less the points are coupled here than they are [-]. So points that cannot be told from each other,
    /// as those of a body that cannot turn, share their impulse. The next pass removes the error.
    static constexpr float loose = 1e-5F;

    Each mass;   ///< 1 / K_ii; 0: there is no such point
    F coupling;  ///< K_01
    F freedom;   ///< 1 - K_01^2 / (K_00 K_11), near 0 for points that are close together; 1 for one point

    [[gnu::always_inline]] static inline TwoPoints of(const Each& mass, F inverseMassA, F inverseMassB, const Each& a,
                                                      const Each& b) {
        // K_00 K_11 - K_01^2, multiplied out: the difference of the two products would be all rounding where the points
        // are close together.
        const F da = a.at[0] - a.at[1], db = b.at[0] - b.at[1], across = a.at[0] * b.at[1] - a.at[1] * b.at[0];
        const F apart = (inverseMassA + inverseMassB) * (inverseMassA * (da * da) + inverseMassB * (db * db)) +
                        inverseMassA * inverseMassB * (across * across);
        const F coupling =
            (inverseMassA + inverseMassB) + (inverseMassA * (a.at[0] * a.at[1]) + inverseMassB * (b.at[0] * b.at[1]));
        const F product = mass.at[0] * mass.at[1], freedom = product > F{} ? product * apart : F{} + 1.0F;
        return {mass, coupling * (1 - loose), freedom + (2 * loose) * (1.0F - freedom)};
    }

    /// The impulses after which the points have no speed that pushes them together. speed: with the bias.
    [[gnu::always_inline]] inline Each normals(const Each& old, const Each& speed, const Each& share) const {
        const F m0 = share.at[0] * mass.at[0], m1 = share.at[1] * mass.at[1];
        // The impulse of each point if the other one's were 0.
        const F alone0 = share.at[0] * old.at[0] + m0 * (coupling * old.at[1] - speed.at[0]);
        const F alone1 = share.at[1] * old.at[1] + m1 * (coupling * old.at[0] - speed.at[1]);
        const F both = share.at[0] * share.at[1], least = F{} + 1e-30F;
        const F inverse = (F{} + 1.0F) / larger((F{} + 1.0F - both) + both * freedom, least);
        // As if both pushed. One pass after the other is exact from there, in each of the four cases; and of points
        // that are close together, this first guess is mostly rounding.
        const F guess = larger(alone0 - m0 * (coupling * alone1), F{}) * inverse;
        const F second = larger(alone1 - m1 * (coupling * guess), F{});
        return {{larger(alone0 - m0 * (coupling * second), F{}), second}};
    }

    /// The impulses after which the points do not slide. limit: mu times the point's normal impulse, 0 where that is
    /// negative [N s]. solved: impulses that count for the limits in addition [N s].
    [[gnu::always_inline]] static inline Each tangents(const Each& tangentMass, const Each& old, const Each& solved,
                                                       const Each& speed, const Each& limit) {
        const F limit0 = larger(limit.at[0], F{}), limit1 = larger(limit.at[1], F{}), room = limit0 + limit1;
        const F part = (F{} + 1.0F) / larger(room, F{} + 1e-30F), part0 = limit0 * part, part1 = limit1 * part;
        const F slow =
            (part0 * tangentMass.at[0] + part1 * tangentMass.at[1]) * (part0 * speed.at[0] + part1 * speed.at[1]);
        const F sum = (solved.at[0] + old.at[0]) + (solved.at[1] + old.at[1]);
        const F now = larger(smaller(sum - slow, room), -room);
        // A contact without points keeps its zeros.
        const auto acts = tangentMass.at[0] + tangentMass.at[1] > F{};
        return {{acts ? part0 * now - solved.at[0] : old.at[0], acts ? part1 * now - solved.at[1] : old.at[1]}};
    }
};

}  // namespace plumb
