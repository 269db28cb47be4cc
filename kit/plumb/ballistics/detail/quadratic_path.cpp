// SPDX-License-Identifier: MIT
#include <plumb/ballistics/detail/quadratic_path.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <plumb/math/trig.h>

namespace plumb::detail {
namespace {

/// Two nodes of Gauss quadrature, symmetric about the middle of the interval from -1 to 1.
struct GaussPair {
    double node, weight;
};
constexpr std::array<GaussPair, 4> eightPoints = {{{0.96028985649753623, 0.10122853629037626},
                                                   {0.79666647741362674, 0.22238103445337447},
                                                   {0.52553240991632899, 0.31370664587788729},
                                                   {0.18343464249564980, 0.36268378337836198}}};
constexpr std::array<GaussPair, 1> twoPoints = {{{0.57735026918962576, 1}}};

/// Integrals along the trajectory from the launch on.
struct Sums {
    double above = 0;   ///< height above the line
    double across = 0;  ///< x
    double time = 0;
    double aboveChange = 0, acrossChange = 0;  ///< derivatives of the first two with respect to W
};

/// e^z - 1 as the sum of an odd and an even part, for |z| <= 1/2; the next terms are below 1e-16 of the first.
struct SmallPower {
    double sinh, coshMinus1;
};
SmallPower smallPower(double z) {
    constexpr std::array<double, 5> odd = {1.0 / 6, 1.0 / 120, 1.0 / 5040, 1.0 / 362880, 1.0 / 39916800};
    constexpr std::array<double, 5> even = {1.0 / 24, 1.0 / 720, 1.0 / 40320, 1.0 / 3628800, 1.0 / 479001600};
    const double q = z * z;
    const double oddSum = odd[0] + q * (odd[1] + q * (odd[2] + q * (odd[3] + q * odd[4])));
    const double evenSum = even[0] + q * (even[1] + q * (even[2] + q * (even[3] + q * even[4])));
    return {z + z * q * oddSum, q * (0.5 + q * evenSum)};
}

/// The trajectory, parametrised by its bend: the decrease of the slope parameter since the launch, s0 - s.
class Path {
public:
    Path(double line, double steeper, double strength)
        : steeper_(steeper),
          strength_(strength),
          launch_(line + steeper),
          secant_(std::sqrt(1 + launch_ * launch_)),
          square_(1 + launch_ * launch_),
          power_(launch_ > 0 ? launch_ + secant_ : 1 / (secant_ - launch_)),
          inverse_(1 / power_) {}

    struct At {
        double steeper;                           ///< slope above that of the line: sinh s minus the line's slope
        double cosh;                              ///< of s
        double w;                                 ///< W
        double rate() const { return cosh / w; }  ///< derivative of x with respect to the bend
    };
    At at(double bend) const { return at(bend, exponentialMinus1(bend)); }

    void add(Sums& sums, double from, double to) const {
        if (std::fabs(to - from) < 1e-3 * to)
            addBy(twoPoints, sums, from, to);
        else
            addBy(eightPoints, sums, from, to);
    }

    /// A panel width over which W grows little, and that is not far beyond where the trajectory would cross without
    /// drag.
    double panelAt(double bend) const {
        const At now = at(bend);
        const double smooth = 0.5 / (strength_ * now.cosh * now.rate());
        return std::min({0.8, smooth, std::max(2.5 * steeper_ / secant_, bend)});
    }

    /// Does it fall vertically from here on, at the terminal speed, to rounding?
    bool fallsStraight(double bend) const {
        if (bend < 40) return false;
        const At now = at(bend);
        return now.steeper - steeper_ + launch_ < 0 && std::fabs(0.5 * strength_ * now.cosh * now.rate() - 1) < 1e-12;
    }

    Crossing crossingBelow(const Sums& sums) const {
        const double change = 2 * launch_ + strength_ * secant_;
        return {sums.across, 1 / square_ + change * sums.acrossChange,
                sums.time + sums.above * std::sqrt(0.5 * strength_)};
    }

    Crossing crossingAt(double bend, const Sums& sums) const {
        const double change = 2 * launch_ + strength_ * secant_;  // derivative of W with respect to the launch slope
        const double across = 1 / square_ + change * sums.acrossChange;
        const double above = steeper_ / square_ + change * sums.aboveChange;
        return {sums.across, across - above / at(bend).steeper, sums.time};
    }

private:
    // All differences are sums of terms with one sign: no cancellation.
    At at(double bend, double more) const {
        const double grown = 1 + more;
        const double shrunk = 1 / grown;
        const double high = power_ * shrunk;                                                              // e^s
        const double low = grown * inverse_;                                                              // e^-s
        const double drop = 0.5 * more * (high + inverse_);                                               // of sinh s
        const double turn = 0.125 * more * (1 + shrunk) * (power_ * high + inverse_ * low) + 0.5 * bend;  // of f(s)
        return {steeper_ - drop, 0.5 * (high + low), square_ + strength_ * turn};
    }

    template <std::size_t Pairs>
    void addBy(const std::array<GaussPair, Pairs>& rule, Sums& sums, double from, double to) const {
        const double middle = 0.5 * (from + to);
        const double half = 0.5 * (to - from);
        const double more = exponentialMinus1(middle);
        for (const GaussPair& pair : rule) {
            const double z = half * pair.node;
            const SmallPower power = smallPower(z);
            for (const double side : {1.0, -1.0}) {
                const double further = side * power.sinh + power.coshMinus1;
                addPoint(sums, half * pair.weight, at(middle + side * z, more + (1 + more) * further));
            }
        }
    }

    static void addPoint(Sums& sums, double weight, const At& now) {
        const double inverse = 1 / now.w;
        const double across = weight * now.cosh * inverse;
        const double above = across * now.steeper;
        sums.above += above;
        sums.across += across;
        sums.time += across * std::sqrt(now.w);
        sums.aboveChange -= above * inverse;
        sums.acrossChange -= across * inverse;
    }

    double steeper_, strength_;
    double launch_, secant_, square_;  ///< sinh s0, cosh s0 and its square
    double power_, inverse_;           ///< e^s0, e^-s0
};

/// An interval of the bend in which the trajectory crosses the line, and the integrals up to both ends.
struct Bracket {
    double from = 0, to = 0;
    Sums before, after;
};

enum class Found { Crossing, StraightFall, Nothing };

Found bracketCrossing(const Path& path, Bracket& bracket) {
    constexpr int mostPanels = 1000;
    for (int panels = 0; panels < mostPanels; ++panels) {
        bracket.from = bracket.to;
        bracket.before = bracket.after;
        bracket.to += path.panelAt(bracket.from);
        path.add(bracket.after, bracket.from, bracket.to);
        if (!(bracket.after.above > 0)) return bracket.to > bracket.from ? Found::Crossing : Found::Nothing;
        if (path.fallsStraight(bracket.to)) return Found::StraightFall;
    }
    return Found::Nothing;
}

/// The first step back from the bracket's far end: to the crossing of the parabola through both ends, with the slope at
/// the far one.
double firstStep(const Path& path, const Bracket& bracket) {
    const Path::At end = path.at(bracket.to);
    const double width = bracket.to - bracket.from;
    const double slope = end.rate() * end.steeper;
    const double curve = (bracket.before.above - bracket.after.above + slope * width) / (width * width);
    const double root = std::sqrt(std::max(0.0, slope * slope - 4 * curve * bracket.after.above));
    return 2 * bracket.after.above / (slope - root);
}

}  // namespace

std::optional<Crossing> crossingOf(double line, double steeper, double strength) {
    const Path path(line, steeper, strength);
    Bracket bracket;
    const Found found = bracketCrossing(path, bracket);
    if (found == Found::Nothing) return std::nullopt;
    if (found == Found::StraightFall) return path.crossingBelow(bracket.after);
    Sums sums = bracket.after;
    double bend = bracket.to;
    double step = firstStep(path, bracket);
    for (int i = 0; i < 60; ++i) {
        double next = bend - step;
        if (!(next > bracket.from)) next = 0.5 * (bracket.from + bend);
        if (!(next <= bracket.to)) next = 0.5 * (bracket.to + bend);
        path.add(sums, bend, next);
        step = std::fabs(next - bend);
        bend = next;
        if (step <= 1e-7 * bend) break;  // Newton's method: the next step would be about the square of this
        const Path::At now = path.at(bend);
        step = sums.above / (now.rate() * now.steeper);
    }
    return path.crossingAt(bend, sums);
}

}  // namespace plumb::detail
