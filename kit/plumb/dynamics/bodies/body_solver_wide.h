// SPDX-License-Identifier: MIT
// How do W bodies move at once?
//
// A body's displacement is counted from the step's start, not from the last sub-step: small numbers in floats, which
// are added to the place in double once, at the step's end (solver/solver.cpp). Rows are read and written by slots; W
// bodies of a list are different, or the slot 0 of the padding, which does not move.
#pragma once
#include <plumb/dynamics/bodies/body_solver.h>
#include <plumb/math/detail/wide_ops.h>
#include <plumb/math/detail/wide_rows.h>

namespace plumb {

template <int W>
struct BodyMover {
    using F = typename Wide<W>::Float;
    using Array = float[static_cast<std::size_t>(W)];

    /// The series are exact to float precision up to smallTurn: at 0.5 rad, the first term that is left out is 5e-9 of
    /// the sine and 3e-10 of cos a - 1. That one is a series of its own, because 1 - cos a loses all digits at small
    /// angles.
    static F sine(F a) {
        const F a2 = a * a;
        return a * (1.0f - a2 * (1.0f / 6 - a2 * (1.0f / 120 - a2 * (1.0f / 5040))));
    }
    static F cosineMinus1(F a) {
        const F a2 = a * a;
        return -a2 * (0.5f - a2 * (1.0f / 24 - a2 * (1.0f / 720 - a2 * (1.0f / 40320))));
    }

    /// One by one, as bodies that turn by more than half a radian in a step are few.
    static void correctFar(F angle, Rows<W>& d, F gyration) {
        Array angles, inverse, sines, cosines;
        storeLanes(angles, angle);
        storeLanes(inverse, gyration);
        storeLanes(sines, d.z);
        storeLanes(cosines, d.w);
        for (int i = 0; i < W; ++i) {
            if (angles[i] <= smallTurn && angles[i] >= -smallTurn) continue;
            const SinCosMinus1 t = turnedFar(angles[i]);
            sines[i] = t.sin * inverse[i];
            cosines[i] = t.cosMinus1 * inverse[i];
        }
        d.z = loadLanes<W>(static_cast<const float*>(sines));
        d.w = loadLanes<W>(static_cast<const float*>(cosines));
    }

    static bool anyFar(F angle) {
        Array angles;
        storeLanes(angles, magnitude(angle));
        bool far = false;
        for (int i = 0; i < W; ++i) far |= angles[i] > smallTurn;
        return far;
    }

    /// Lanes without a break at the first: so that compilers can vectorize the loop. The same in anyFar.
    static bool anyFast(F squared, F limit) {
        Array speeds, limits;
        storeLanes(speeds, squared);
        storeLanes(limits, limit);
        bool some = false;
        for (int i = 0; i < W; ++i) some |= speeds[i] > limits[i];
        return some;
    }

    /// Appends the fast ones of W bodies, with their displacement before they move: the search for walls needs the path
    /// of the sub-step (walls/wall_stops.h).
    static std::size_t addFast(const std::uint32_t* at, const SolverBodies& bodies, FastBody* fast) {
        std::size_t count = 0;
        for (int i = 0; i < W; ++i) {
            const SolverVelocity& v = bodies.velocity[at[i]];
            const SolverTurn& turn = bodies.turn[at[i]];
            if (!(v.x * v.x + v.y * v.y + v.w * v.w > turn.farSpeedSquared)) continue;
            const SolverDisplacement& d = bodies.displacement[at[i]];
            fast[count++] = {at[i], d.x, d.y, turn.angle};
        }
        return count;
    }

    /// One pass over the solved bodies in each sub-step: x += v h, angle += rho w h, and from the angle the sine and
    /// cosine by which contacts turn their anchors. They are stored over rho, as anchors are stored times rho: products
    /// need no further factor.
    static std::size_t move(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies, float h,
                            FastBody* fast) {
        std::size_t found = 0;
        for (const std::uint32_t* at = list; at != list + count; at += W) {
            const Rows<W> v = loadRows<W>(&bodies.velocity->x, at);
            Rows<W> d = loadRows<W>(&bodies.displacement->x, at);
            Rows<W> t = loadRows<W>(&bodies.turn->angle, at);
            if (anyFast(v.x * v.x + v.y * v.y + v.z * v.z, t.w)) found += addFast(at, bodies, fast + found);
            d.x += v.x * h;
            d.y += v.y * h;
            t.x += v.z * t.y * h;
            d.z = sine(t.x) * t.z;
            d.w = cosineMinus1(t.x) * t.z;
            if (anyFar(t.x)) correctFar(t.x, d, t.z);
            storeRows<W>(&bodies.displacement->x, at, d);
            storeRows<W>(&bodies.turn->angle, at, t);
        }
        return found;
    }
};

template <int W>
const BodySolver WideBodySolver<W>::code{BodyMover<W>::move};

}  // namespace plumb
