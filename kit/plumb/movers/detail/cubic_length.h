// SPDX-License-Identifier: MIT
// How long is a cubic curve, and where is the point at a given arc length?
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
    /// The unit tangent; also where the derivative is zero: the limit from below at u = 1, else from above. (1, 0) for
    /// a curve that is a point.
    Vec2 tangent(double u) const;
    double size() const;  ///< the length of its control polygon, not less than its own [m]
};

/// The arc length of a cubic from u = 0 to nodes that are close enough for five-point Gauss quadrature between them. An
/// interval is halved until the quadrature of it and of its halves agree to 1e-12 of the size, times its part of u; the
/// sum of the halves is far more accurate, so the total error is less than 1e-12 of the size plus rounding, 1e-15 of it
/// per node. At a cusp, where |B'| has a kink, intervals get as small as 2^-40, and their length 2^-38 of the size.
class CubicLength {
public:
    explicit CubicLength(const Cubic& cubic);

    const Cubic& cubic() const { return cubic_; }
    double length() const { return nodes_.back().along; }
    /// u at an arc length, which is limited to 0 to length [m].
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
