// SPDX-License-Identifier: MIT
// How long is a cubic curve, and where is the point a given way along it?
#pragma once
#include <array>
#include <vector>

#include <plumb/math/vec2.h>

namespace plumb {

/// B(u) = (1-u)^3 p0 + 3 (1-u)^2 u p1 + 3 (1-u) u^2 p2 + u^3 p3, u from 0 to 1.
struct Cubic {
    std::array<Vec2, 4> points;

    Vec2 at(double u) const;
    Vec2 derivative(double u) const;
    /// The unit vector along it; also where it stands still, from the side it comes from at u = 1, else where it goes
    /// to. (1, 0) for a curve that is a point.
    Vec2 tangent(double u) const;
    double size() const;  ///< the length of its polygon of points, not less than its own [m]
};

/// The length of a cubic from u = 0 to nodes that lie close enough for Gauss's rule of five points to give the rest.
/// An interval is halved until the rule on it and on its halves agree to 1e-12 of the size, times its part of u; the
/// halves' sum is off by far less, so all together by less than 1e-12 of the size and rounding, 1e-15 of it a node.
/// At a cusp, where |B'| has a kink, intervals get as small as 2^-40, and their length 2^-38 of the size.
class CubicLength {
public:
    explicit CubicLength(const Cubic& cubic);

    const Cubic& cubic() const { return cubic_; }
    double length() const { return nodes_.back().along; }
    /// u at a way along, cut to 0 to length [m].
    double parameterAt(double along) const;

private:
    struct Node {
        double u, along;
    };
    double measure(double from, double to) const;
    void divide(double from, double to, double whole, int depth);

    Cubic cubic_;
    std::vector<Node> nodes_;
};

}  // namespace plumb
