// SPDX-License-Identifier: MIT
#include <plumb/dynamics/bodies/body_solver.h>

#include <plumb/math/trig.h>

namespace plumb {

namespace {

/// A record as an array, so that compilers can use one vector operation.
struct Row {
    float field[4];
};

Row rowOf(const SolverVelocity& v) {
    return {{v.x, v.y, v.w, v.inverseMass}};
}
SolverVelocity speedOfRow(const Row& row) {
    return {row.field[0], row.field[1], row.field[2], row.field[3]};
}

}  // namespace

SinCosMinus1 turnedFar(float angle) {
    const SinCos sc = sinCos(static_cast<double>(angle));
    return {static_cast<float>(sc.sin), static_cast<float>(sc.cos - 1)};
}

void kickBodies(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies, bool first) {
    for (const std::uint32_t* body = list; body != list + count; ++body) {
        // All four fields alike, so that it is one vector operation: the inverse mass has keep 1 and gain 0.
        Row v = rowOf(bodies.velocity[*body]), warm = rowOf(bodies.warm[*body]);
        const Row before = rowOf(first ? bodies.velocity[*body] : bodies.before[*body]);
        const Row gain = rowOf(bodies.kick[*body].gain), keep = rowOf(bodies.kick[*body].keep);
        for (int i = 0; i < 4; ++i) {
            warm.field[i] += v.field[i] - before.field[i];  // 0 for the inverse mass
            v.field[i] = v.field[i] * keep.field[i] + gain.field[i] + warm.field[i];
        }
        bodies.warm[*body] = speedOfRow(warm);
        bodies.velocity[*body] = bodies.before[*body] = speedOfRow(v);
    }
}

void markBodies(const std::uint32_t* list, std::size_t count, const SolverBodies& bodies) {
    for (const std::uint32_t* body = list; body != list + count; ++body) bodies.before[*body] = bodies.velocity[*body];
}

}  // namespace plumb
