// SPDX-License-Identifier: MIT
#include <plumb/broad/box_probe.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/broad/detail/box_probe_wide.h>
#include <plumb/math/detail/for_lanes.h>

namespace plumb {

#if defined(__GNUC__)
extern template struct WideBoxProbe<8>;
extern template struct WideBoxProbe<16>;
#endif

namespace {

/// Sixteen roundings of the largest float in the input: rounding the ray's ends, boxes up to twice as far away, their
/// differences, and the products with 1 / displacement makes ten. Boxes farther away are clear of the ray.
constexpr double relativeError = 0x1p-20;

template <int W>
struct Keys {
    static std::uint32_t ray(const BoxProbe& p, const BoxBlock& boxes, float limit, float* keys) {
        return WideBoxProbe<W>::rayKeys(rowOf(p), floatsOf(boxes), limit, keys);
    }
    static std::uint32_t point(const BoxProbe& p, const BoxBlock& boxes, float limit, float* keys) {
        return WideBoxProbe<W>::pointKeys(rowOf(p), floatsOf(boxes), limit, keys);
    }
    static const float* floatsOf(const BoxBlock& boxes) { return reinterpret_cast<const float*>(&boxes); }
    static BoxProbeRow rowOf(const BoxProbe& p) {
        return {p.fromX, p.fromY, p.inverseX, p.inverseY, p.marginX, p.marginY};
    }
};

template <int W>
BoxProbe::Keys keysOf(bool ray) {
    return ray ? &Keys<W>::ray : &Keys<W>::point;
}

BoxProbe::Keys keysFor(int lanes, bool ray) {
    return forLanes(lanes, [ray]<int W>() { return keysOf<W>(ray); });
}

float rounded(double x) {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(x, -largest, largest));
}

/// 1 / displacement, limited so that a distance times it is never NaN.
float inverseOf(double displacement) {
    constexpr double most = 0x1p100;
    return static_cast<float>(std::copysign(std::clamp(1 / std::fabs(displacement), 1 / most, most), displacement));
}

}  // namespace

BoxProbe rayProbe(const Vec2& from, const Vec2& to, const Vec2& halfSize, const Vec2& origin, int lanes) {
    const Vec2 start = from - origin, end = to - origin, displacement = to - from;
    const Vec2 farthest = start.cwiseAbs().cwiseMax(end.cwiseAbs()) + halfSize;
    const double slack = relativeError * farthest.maxCoeff();
    return {rounded(start.x()),
            rounded(start.y()),
            inverseOf(displacement.x()),
            inverseOf(displacement.y()),
            rounded(halfSize.x() + slack),
            rounded(halfSize.y() + slack),
            keysFor(lanes, true)};
}

BoxProbe pointProbe(const Vec2& point, const Vec2& origin, int lanes) {
    const Vec2 position = point - origin;
    const float slack = rounded(relativeError * position.cwiseAbs().maxCoeff());
    return {rounded(position.x()), rounded(position.y()), 0, 0, slack, slack, keysFor(lanes, false)};
}

float probeLimit(double limit) {
    constexpr double most = 0x1p60;
    if (!(limit < most)) return std::numeric_limits<float>::infinity();
    return static_cast<float>(limit + std::fabs(limit) * 0x1p-23);
}

RayPart clipRay(const Vec2& from, const Vec2& to, const Aabb& box) {
    constexpr double fourRoundings = 2 * std::numeric_limits<double>::epsilon();
    RayPart part;
    for (const int axis : {0, 1}) {
        const double displacement = to[axis] - from[axis], far = std::max(std::fabs(from[axis]), std::fabs(to[axis]));
        const double lower = box.lower[axis] - from[axis] - fourRoundings * far;
        const double upper = box.upper[axis] - from[axis] + fourRoundings * far;
        if (displacement == 0) {
            if (!(lower <= 0 && upper >= 0)) return {1, 0};
            continue;
        }
        part.first = std::max(part.first, std::min(lower / displacement, upper / displacement));
        part.last = std::min(part.last, std::max(lower / displacement, upper / displacement));
    }
    return part;
}

}  // namespace plumb
