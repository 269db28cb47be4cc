// SPDX-License-Identifier: MIT
#include <compare/formula/oscillator.h>

#include <cmath>

namespace plumb::compare {
namespace {

/// e^(-b t) C and e^(-b t) S, computed together so that no factor overflows if it creeps.
struct Parts {
    double c, s;
};

Parts partsOf(double b, double square, double t) {
    if (square > 0) {
        const double w = std::sqrt(square);
        return {std::exp(-b * t) * std::cos(w * t), std::exp(-b * t) * std::sin(w * t) / w};
    }
    if (square == 0) return {std::exp(-b * t), std::exp(-b * t) * t};
    const double q = std::sqrt(-square);
    const double slow = std::exp((q - b) * t);
    const double gone = std::expm1(-2 * q * t);  // e^(-2 q t) - 1
    return {slow * (2 + gone) / 2, slow * -gone / (2 * q)};
}

}  // namespace

Displacement displacementAt(const Oscillator& o, double t) {
    const double b = o.damping / (2 * o.mass);
    const double square = o.stiffness / o.mass;  // w0^2
    const Parts parts = partsOf(b, square - b * b, t);
    return {o.offset * parts.c + (o.speed + b * o.offset) * parts.s,
            o.speed * parts.c - (square * o.offset + b * o.speed) * parts.s};
}

}  // namespace plumb::compare
