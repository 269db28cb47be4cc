// SPDX-License-Identifier: MIT
// How are a ray or a point tested against a block of boxes, W at a time?
#pragma once
#include <plumb/broad/box_block.h>
#include <plumb/math/detail/wide_ops.h>

namespace plumb {

/// BoxProbe as plain memory: see math/detail/wide.h for what may be in a file for W lanes.
struct BoxProbeRow {
    float fromX, fromY, inverseX, inverseY, marginX, marginY;
};

template <int W>
struct WideBoxProbe {
    static std::uint32_t rayKeys(const BoxProbeRow& ray, const float* boxes, float limit, float* keys);
    static std::uint32_t pointKeys(const BoxProbeRow& point, const float* boxes, float limit, float* keys);

private:
    using Float = typename Wide<W>::Float;
    static constexpr std::uint32_t width = 16;
    static constexpr std::uint32_t lowerX = 0, lowerY = width, upperX = 2 * width, upperY = 3 * width;
};

/// Slab test: the ray is within [min, max] of (lower - from) / displacement and (upper - from) / displacement in x and
/// in y at once. A hole is NaN, and fails the comparison with itself.
template <int W>
std::uint32_t WideBoxProbe<W>::rayKeys(const BoxProbeRow& ray, const float* boxes, float limit, float* keys) {
    std::uint32_t lanes = 0;
    const float lowX = ray.fromX + ray.marginX, lowY = ray.fromY + ray.marginY;
    const float highX = ray.fromX - ray.marginX, highY = ray.fromY - ray.marginY;
    const Float zero{};
    for (std::uint32_t i = 0; i < width; i += W) {
        const Float left = loadLanes<W>(boxes + lowerX + i);
        const Float x1 = (left - lowX) * ray.inverseX, x2 = (loadLanes<W>(boxes + upperX + i) - highX) * ray.inverseX;
        const Float y1 = (loadLanes<W>(boxes + lowerY + i) - lowY) * ray.inverseY;
        const Float y2 = (loadLanes<W>(boxes + upperY + i) - highY) * ray.inverseY;
        const Float enter = larger(larger(smaller(x1, x2), smaller(y1, y2)), zero);
        const Float leave = smaller(larger(x1, x2), larger(y1, y2));
        storeLanes(keys + i, enter);
        lanes |= (bitsOf<W>(enter <= leave) & bitsOf<W>(enter <= limit) & bitsOf<W>(left == left)) << i;
    }
    return lanes;
}

template <int W>
std::uint32_t WideBoxProbe<W>::pointKeys(const BoxProbeRow& point, const float* boxes, float limit, float* keys) {
    constexpr float shorter = 1 - 0x1p-20f;
    std::uint32_t lanes = 0;
    const Float zero{};
    for (std::uint32_t i = 0; i < width; i += W) {
        const Float left = loadLanes<W>(boxes + lowerX + i);
        const Float x = larger(larger(left - point.fromX, point.fromX - loadLanes<W>(boxes + upperX + i)), zero);
        const Float y = larger(
            larger(loadLanes<W>(boxes + lowerY + i) - point.fromY, point.fromY - loadLanes<W>(boxes + upperY + i)),
            zero);
        const Float distance = squareRoot<W>(x * x + y * y) * shorter - point.marginX;
        storeLanes(keys + i, distance);
        lanes |= (bitsOf<W>(distance <= limit) & bitsOf<W>(left == left)) << i;
    }
    return lanes;
}

}  // namespace plumb
