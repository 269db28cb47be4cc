// SPDX-License-Identifier: MIT
// How are the numbers of a random scene drawn?
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>

#include <plumb/math/logarithm.h>
#include <plumb/math/random.h>
#include <plumb/math/trig.h>
#include <plumb/math/vec2.h>

namespace plumb::compare {

inline constexpr double fullTurn = 2 * std::numbers::pi;  ///< [rad]

/// Draws give the same bits on every machine. Write each draw as a statement of its own: the compiler may choose the
/// order in which it evaluates the arguments of a function.
class Draw {
public:
    explicit Draw(std::uint64_t seed) : random_(seed) {}

    double uniform(double low, double high) { return random_.uniform(low, high); }
    int integer(int low, int high) { return random_.integer(low, high); }
    bool chance(double share) { return random_.uniform(0, 1) < share; }
    /// A number of a size from low to high, positive or negative.
    double eitherWay(double low, double high) {
        const double size = uniform(low, high);
        return chance(0.5) ? size : -size;
    }
    /// A number whose logarithm is uniformly distributed; 0 < low <= high.
    double logUniform(double low, double high) {
        const double exponent = uniform(0, 1) * logarithm(high / low);
        return std::clamp(low * exponential(exponent), low, high);
    }
    /// A unit vector.
    Vec2 direction() {
        const SinCos turned = sinCos(uniform(0, fullTurn));
        return {turned.cos, turned.sin};
    }
    template <class T, std::size_t N>
    const T& of(const T (&list)[N]) {
        return list[static_cast<std::size_t>(integer(0, static_cast<int>(N) - 1))];
    }
    /// A seed for another generator.
    std::uint64_t seed() { return random_.bits(); }

private:
    Random random_;
};

}  // namespace plumb::compare
