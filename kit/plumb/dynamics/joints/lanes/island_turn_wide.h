// SPDX-License-Identifier: MIT
// How far have W bodies turned?
#pragma once
#include <plumb/math/detail/wide_ops.h>
#include <plumb/math/trig.h>

namespace plumb {

/// sin and cos of an angle that a body has turned in a step, with a series that is exact to rounding up to farthest.
template <int W>
struct WideTurn {
    using D = typename Wide<W>::Double;
    static constexpr double farthest = 0.7;  ///< [rad]

    static D sine(D t) {
        const D t2 = t * t;
        const D tail = 1.0 - t2 * (1.0 / 110) * (1.0 - t2 * (1.0 / 156) * (1.0 - t2 * (1.0 / 210)));
        return t * (1.0 - t2 * (1.0 / 6) *
                              (1.0 - t2 * (1.0 / 20) * (1.0 - t2 * (1.0 / 42) * (1.0 - t2 * (1.0 / 72) * tail))));
    }
    static D cosine(D t) {
        const D t2 = t * t;
        const D tail = 1.0 - t2 * (1.0 / 90) * (1.0 - t2 * (1.0 / 132) * (1.0 - t2 * (1.0 / 182)));
        return 1.0 - t2 * 0.5 * (1.0 - t2 * (1.0 / 12) * (1.0 - t2 * (1.0 / 30) * (1.0 - t2 * (1.0 / 56) * tail)));
    }
    static void far(double* cosines, double* sines, const double* turns) {
        for (int l = 0; l < Wide<W>::doubles; ++l) {
            if (turns[l] <= farthest && turns[l] >= -farthest) continue;
            const SinCos t = sinCos(turns[l]);
            cosines[l] = t.cos;
            sines[l] = t.sin;
        }
    }
};

}  // namespace plumb
