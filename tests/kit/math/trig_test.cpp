// SPDX-License-Identifier: MIT
#include <plumb/math/trig.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/random.h>
#include <plumb/math/rot.h>

#include "catch.h"
#include "kit/math/reference.h"
#include "numbers.h"

using namespace plumb;
using namespace plumb::test;

namespace {

double lastPlace(long double exact) {
    int exponent = 0;
    std::frexp(exact, &exponent);
    return std::ldexp(1.0, std::max(exponent - 53, -1074));
}

double ulps(double value, long double exact) {
    return static_cast<double>(std::fabs(value - exact)) / lastPlace(exact);
}

double distance(double value, long double exact) {
    return static_cast<double>(std::fabs(value - exact));
}

struct WorstErrors {
    double ulps = 0;
    double distance = 0;
    void hold(double value, long double exact) {
        ulps = std::max(ulps, ::ulps(value, exact));
        distance = std::max(distance, ::distance(value, exact));
    }
};

// Spread over magnitudes, and often next to a multiple of pi / 2, where the reduction is hardest.
double someAngle(Random& random, double range) {
    const double angle = random.uniform(-range, range) * std::exp2(random.integer(0, 1) * random.uniform(-40, 0));
    return random.integer(0, 3) > 0 ? angle : std::nearbyint(angle / (pi / 2)) * (pi / 2);
}

WorstErrors worstSinCos(double range, int count) {
    Random random(7);
    WorstErrors worst;
    for (int i = 0; i < count; ++i) {
        const double angle = someAngle(random, range);
        const SinCos result = sinCos(angle);
        worst.hold(result.sin, std::sin(static_cast<long double>(angle)));
        worst.hold(result.cos, std::cos(static_cast<long double>(angle)));
    }
    return worst;
}

}  // namespace

TEST_CASE("sine and cosine are within 1 ulp at a million angles up to 1e7 rad", "[math][trig]") {
    CHECK(worstSinCos(10, million / 2).ulps < 1 + own);
    CHECK(worstSinCos(1e7, million / 2).ulps < 1 + own);
}

TEST_CASE("sine and cosine are within 1e-16 up to 3.5e13 rad, and in proportion beyond", "[math][trig]") {
    // A last place below 1 is 1.1e-16.
    CHECK(worstSinCos(1e9, 200'000).distance < 1e-16 + own * 1.1e-16);
    CHECK(worstSinCos(3.5e13, 200'000).distance < 1e-16 + own * 1.1e-16);
    for (const double range : {1e14, 3e15}) CHECK(worstSinCos(range, 100'000).distance < 4e-17 * range);
}

TEST_CASE("sine and cosine keep their identities at 100,000 angles", "[math][trig]") {
    Random random(11);
    double squares = 0;
    double doubled = 0;
    bool odd = true;
    for (int i = 0; i < 100'000; ++i) {
        const double angle = someAngle(random, 1e5);
        const SinCos r = sinCos(angle);
        const SinCos negative = sinCos(-angle);
        const SinCos twice = sinCos(2 * angle);
        odd = odd && negative.sin == -r.sin && negative.cos == r.cos;
        squares = std::max(squares, std::fabs(r.sin * r.sin + r.cos * r.cos - 1));
        doubled = std::max(doubled, std::fabs(twice.sin - 2 * r.sin * r.cos));
    }
    CHECK(odd);
    // Each function is off by 1e-16 at most, which counts 2 (|sin| + |cos|) <= 2.9 times; then the sum's own roundings.
    CHECK(squares < 2.9e-16 + 3 * 1.2e-16);
    CHECK(doubled < 1e-16 + 2.9e-16 + 2 * 1.2e-16);
}

TEST_CASE("sine and cosine at the edges of quadrants, at 0 and at values that are no angle", "[math][trig]") {
    CHECK(sinCos(0).sin == 0);
    CHECK(sinCos(0).cos == 1);
    CHECK(sinCos(1e-300).sin == 1e-300);
    CHECK(sinCos(5e-324).sin == 5e-324);
    // pi as a double falls short of pi by this much: sin x = pi - x.
    CHECK(sinCos(pi).sin == 1.2246467991473532e-16);
    CHECK(sinCos(pi).cos == -1);
    CHECK(sinCos(pi / 2).cos == 6.123233995736766e-17);
    CHECK(sinCos(pi / 2).sin == 1);
    for (int quarter = -40; quarter <= 40; ++quarter)
        for (const double step : {-1e-9, 0.0, 1e-9}) {
            const double angle = quarter * (pi / 4) + step;
            CHECK(ulps(sinCos(angle).sin, std::sin(static_cast<long double>(angle))) < 1 + own);
            CHECK(ulps(sinCos(angle).cos, std::cos(static_cast<long double>(angle))) < 1 + own);
        }
    for (const double bad : {infinity, -infinity, test::nan}) {
        CHECK(std::isnan(sinCos(bad).sin));
        CHECK(std::isnan(sinCos(bad).cos));
    }
    for (const double huge : {1e22, 1.7e308}) {
        const SinCos r = sinCos(huge);
        CHECK(std::fabs(r.sin * r.sin + r.cos * r.cos - 1) < 1e-15);
    }
}

TEST_CASE("arc tangents of a million vectors are within 1.5 ulp and 4e-16 rad", "[math][trig]") {
    Random random(13);
    WorstErrors worst;
    for (int i = 0; i < million; ++i) {
        const int kind = random.integer(0, 3);
        const double x = random.uniform(-1, 1) * (kind == 1 ? std::exp2(random.uniform(-1000, 1000)) : 1);
        const double y = random.uniform(-1, 1) * (kind == 2 ? std::exp2(random.uniform(-1000, 1000)) : 1);
        worst.hold(arcTangent(y, x), std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
    }
    CHECK(worst.ulps < 1.5 + own);
    CHECK(worst.distance < 4e-16 + own * 4.4e-16);
}

TEST_CASE("arc tangents along the axes, the diagonals, and of vectors that have no direction", "[math][trig]") {
    CHECK(arcTangent(0, 1) == 0);
    CHECK(arcTangent(1, 0) == pi / 2);
    CHECK(arcTangent(0, -1) == pi);
    CHECK(arcTangent(-0.0, -1) == pi);
    CHECK(arcTangent(-1, 0) == -pi / 2);
    CHECK(arcTangent(-5e-324, -1) == -pi);
    CHECK(arcTangent(0, 0) == 0);
    CHECK(arcTangent(-0.0, -0.0) == 0);
    for (const double size : {5e-324, 1e-310, 1e-300, 1.0, 1e300, 1.7e308}) {
        CHECK(arcTangent(size, size) == pi / 4);
        CHECK(arcTangent(size, -size) == 3 * pi / 4);
        CHECK(arcTangent(-size, size) == -pi / 4);
        CHECK(arcTangent(-size, -size) == -3 * pi / 4);
    }
    CHECK(arcTangent(1.7e308, 5e-324) == pi / 2);
    CHECK(arcTangent(5e-324, 1.7e308) == 0);
    // The ratio of two denormals is not quite 3: they hold 43 bits.
    CHECK(std::fabs(arcTangent(3e-310, 1e-310) - std::atan(3.0)) < 0x1p-43);
    for (const double bad : {infinity, -infinity, test::nan}) {
        CHECK(std::isnan(arcTangent(bad, 1)));
        CHECK(std::isnan(arcTangent(1, bad)));
    }
}

TEST_CASE("a rotation gives back the angle it was made from at 100,000 angles", "[math][trig]") {
    Random random(17);
    double worst = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double angle = random.uniform(-pi, pi);
        worst = std::max(worst, std::fabs(Rot::fromAngle(angle).angle() - angle));
    }
    // 1e-16 each of sine and cosine turn the vector by at most 1.5e-16; the arc tangent adds 4e-16.
    CHECK(worst < 5.5e-16);
}

TEST_CASE("a million exponentials are within 1 ulp, and 1.5 with 1 taken off", "[math][trig]") {
    Random random(19);
    WorstErrors plain;
    WorstErrors less;
    for (int i = 0; i < million; ++i) {
        const int kind = random.integer(0, 2);
        const double x = kind == 0   ? random.uniform(-708, 709)
                         : kind == 1 ? random.uniform(-2, 2)
                                     : random.uniform(-1, 1) * std::exp2(random.uniform(-60, 0));
        plain.hold(exponential(x), std::exp(static_cast<long double>(x)));
        less.hold(exponentialMinus1(x), std::expm1(static_cast<long double>(x)));
    }
    CHECK(plain.ulps < 1 + own);
    CHECK(less.ulps < 1.5 + own);
}

TEST_CASE("exponentials at 0, at the ends of the range and at values that are no number", "[math][trig]") {
    CHECK(exponential(0) == 1);
    CHECK(exponential(-0.0) == 1);
    CHECK(exponentialMinus1(0) == 0);
    CHECK(exponentialMinus1(1e-300) == 1e-300);
    CHECK(exponentialMinus1(-5e-324) == -5e-324);
    // The largest double is e^709.78..., the smallest 2^-1074 = e^-744.4...; half of that rounds to 0.
    CHECK(std::isfinite(exponential(709.78)));
    CHECK(std::isfinite(exponentialMinus1(709.78)));
    CHECK(exponential(709.79) == infinity);
    CHECK(exponentialMinus1(709.79) == infinity);
    CHECK(exponential(-744.5) == 5e-324);
    CHECK(exponential(-745.2) == 0);
    for (const double huge : {1e3, 1e300, infinity}) {
        CHECK(exponential(huge) == infinity);
        CHECK(exponentialMinus1(huge) == infinity);
        CHECK(exponential(-huge) == 0);
        CHECK(exponentialMinus1(-huge) == -1);
    }
    CHECK(std::isnan(exponential(test::nan)));
    CHECK(std::isnan(exponentialMinus1(test::nan)));
}
