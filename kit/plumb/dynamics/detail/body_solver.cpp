// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/body_solver.h>

#include <algorithm>

#include <plumb/dynamics/detail/body_solver_wide.h>
#include <plumb/math/trig.h>

namespace plumb {

namespace {

SolverVelocity kicked(const SolverVelocity& v, const Kick& k, const SolverVelocity& warm) {
    return {v.x * k.keep.x + k.gain.x + warm.x, v.y * k.keep.y + k.gain.y + warm.y, v.w * k.keep.w + k.gain.w + warm.w,
            v.inverseMass};
}

SolverVelocity changed(const SolverVelocity& warm, const SolverVelocity& now, const SolverVelocity& before) {
    return {warm.x + (now.x - before.x), warm.y + (now.y - before.y), warm.w + (now.w - before.w), 0};
}

}  // namespace

template struct WideBodySolver<1>;
#if defined(__GNUC__)
extern template struct WideBodySolver<4>;
extern template struct WideBodySolver<8>;
extern template struct WideBodySolver<16>;
#endif

const BodySolver& bodySolver(int lanes) {
#if defined(__GNUC__)
    const int wanted = std::min(lanes, machineLanes());
    if (wanted >= 16) return WideBodySolver<16>::solver;
    if (wanted >= 8) return WideBodySolver<8>::solver;
    if (wanted >= 4) return WideBodySolver<4>::solver;
#endif
    return WideBodySolver<1>::solver;
}

SinCosMinus1 turnedFar(float angle) {
    const SinCos sc = sinCos(static_cast<double>(angle));
    return {static_cast<float>(sc.sin), static_cast<float>(sc.cos - 1)};
}

void kickBodies(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies, bool first) {
    for (const std::uint32_t* body = list; body != list + count; ++body) {
        SolverVelocity& v = bodies.velocity[*body];
        SolverVelocity& warm = bodies.warm[*body];
        if (!first) warm = changed(warm, v, bodies.before[*body]);
        v = kicked(v, bodies.kick[*body], warm);
        bodies.before[*body] = v;
    }
}

void markBodies(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies) {
    for (const std::uint32_t* body = list; body != list + count; ++body) bodies.before[*body] = bodies.velocity[*body];
}

}  // namespace plumb
