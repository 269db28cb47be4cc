// SPDX-License-Identifier: MIT
#include <plumb/broad/box_probe.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <plumb/broad/detail/box_probe_wide.h>

namespace plumb {

#if defined(__GNUC__)
extern template struct WideBoxProbe<8>;
extern template struct WideBoxProbe<16>;
#endif

namespace {

/// Sixteen roundings of the largest float that comes in: those of the ray's ends, of boxes that are no farther away
/// than twice that, of their differences and the products with 1 / way make ten. What is farther lies clear of the ray.
constexpr double roundings = 0x1p-20;

template <int W>
struct Keys {
    static std::uint32_t ray(const BoxProbe& p, const BoxBlock& boxes, float limit, float* keys) {
        return WideBoxProbe<W>::rayKeys(rowOf(p), floatsOf(boxes), limit, keys);
    }
    static std::uint32_t point(const BoxProbe& p, const BoxBlock& boxes, float limit, float* keys) {
        return WideBoxProbe<W>::pointKeys(rowOf(p), floatsOf(boxes), limit, keys);
    }
    static const float* floatsOf(const BoxBlock& boxes) { return reinterpret_cast<const float*>(&boxes); }
    static BoxProbeRow rowOf(const BoxProbe& p) { return {p.fromX, p.fromY, p.perX, p.perY, p.growX, p.growY}; }
};

template <int W>
BoxProbe::Keys keysOf(bool ray) {
    return ray ? &Keys<W>::ray : &Keys<W>::point;
}

BoxProbe::Keys keysFor(int lanes, bool ray) {
    switch (std::min(lanes, machineLanes())) {
#if defined(__GNUC__)
        case 4: return keysOf<4>(ray);
        case 8: return keysOf<8>(ray);
        case 16: return keysOf<16>(ray);
#endif
        default: return keysOf<1>(ray);
    }
}

float rounded(double x) {
    constexpr double largest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(x, -largest, largest));
}

/// 1 / way, but neither so large nor so small that a distance times it would not be a number.
float perLength(double way) {
    constexpr double most = 0x1p100;
    return static_cast<float>(std::copysign(std::clamp(1 / std::fabs(way), 1 / most, most), way));
}

}  // namespace

BoxProbe rayProbe(const Vec2& from, const Vec2& to, const Vec2& halfSize, const Vec2& origin, int lanes) {
    const Vec2 start = from - origin, end = to - origin, way = to - from;
    const Vec2 reach = start.cwiseAbs().cwiseMax(end.cwiseAbs()) + halfSize;
    const double slack = roundings * reach.maxCoeff();
    return {rounded(start.x()),
            rounded(start.y()),
            perLength(way.x()),
            perLength(way.y()),
            rounded(halfSize.x() + slack),
            rounded(halfSize.y() + slack),
            keysFor(lanes, true)};
}

BoxProbe pointProbe(const Vec2& point, const Vec2& origin, int lanes) {
    const Vec2 place = point - origin;
    const float slack = rounded(roundings * place.cwiseAbs().maxCoeff());
    return {rounded(place.x()), rounded(place.y()), 0, 0, slack, slack, keysFor(lanes, false)};
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
        const double way = to[axis] - from[axis], far = std::max(std::fabs(from[axis]), std::fabs(to[axis]));
        const double lower = box.lower[axis] - from[axis] - fourRoundings * far;
        const double upper = box.upper[axis] - from[axis] + fourRoundings * far;
        if (way == 0) {
            if (!(lower <= 0 && upper >= 0)) return {1, 0};
            continue;
        }
        part.first = std::max(part.first, std::min(lower / way, upper / way));
        part.last = std::min(part.last, std::max(lower / way, upper / way));
    }
    return part;
}

}  // namespace plumb
