// SPDX-License-Identifier: MIT
// How are pairs of shapes stored that are collided several at a time, and where they touch?
#pragma once
#include <cstddef>
#include <cstdint>

#include <plumb/math/detail/wide.h>

namespace plumb {

/// How are two shapes collided that are not both boxes? One by one; as a disc, which is A or B, and another shape; as
/// polygons; or one by one if they are near each other as polygons, because one is a segment of a chain.
inline constexpr std::int32_t noKernel = 0, discFirst = 1, discSecond = 2, asPolygons = 3, onChain = 4;

/// In each lane two shapes that are near each other, as boxes. For boxes this is all that is needed to find where they
/// touch; for other shapes it can show that they do not touch.
struct alignas(64) PairLanes {
    Lanes<std::uint32_t> bodyA, bodyB;                    ///< slots of the bodies; an empty lane has 0 and 0
    Lanes<float> halfXA, halfYA, halfXB, halfYB;          ///< [m]
    Lanes<float> radiusA, radiusB;                        ///< rounding radii of the boxes [m]
    Lanes<float> centerXA, centerYA, centerXB, centerYB;  ///< from their body's centre of mass [m]
    Lanes<std::int32_t> kernel;                           ///< noKernel, discFirst, ...
    Lanes<std::uint32_t> proxyA, proxyB;
    Lanes<std::int32_t> cornersA, cornersB;  ///< number of corners, for the lanes that are collided as polygons
};
inline bool hasDisc(const PairLanes& pairs, std::size_t lane) {
    return pairs.halfXA[lane] + pairs.halfYA[lane] == 0 || pairs.halfXB[lane] + pairs.halfYB[lane] == 0;
}

/// One lane of PairLanes, without the boxes.
struct ShapePair {
    std::uint32_t bodyA = 0, bodyB = 0, proxyA = 0, proxyB = 0;
    double shiftX = 0, shiftY = 0;  ///< to B's periodic image near A, in a world that wraps [m]
};
inline ShapePair pairAt(const PairLanes& pairs, std::size_t lane) {
    return {pairs.bodyA[lane], pairs.bodyB[lane], pairs.proxyA[lane], pairs.proxyB[lane], 0, 0};
}
inline constexpr std::size_t pairRows = sizeof(PairLanes) / (sizeof(float) * batchLanes);

/// Polygons of more corners are collided one by one.
inline constexpr int mostCorners = 8;

/// Four corners of a polygon, from its body's centre of mass [m], and the normals of the edges that start there. A
/// polygon of fewer corners is filled up with copies of its first.
struct alignas(64) CornerRows {
    float x[4] = {}, y[4] = {};
    float normalX[4] = {}, normalY[4] = {};
};

/// The corners of all proxies.
struct CornerTable {
    const CornerRows* first = nullptr;  ///< the first four
    const CornerRows* more = nullptr;   ///< the others, if any proxy has more than four
};

/// Shapes nearer than this count as in contact, so that bodies at rest keep their manifolds in spite of jitter [m].
inline constexpr float contactMargin = 0.01f;

struct alignas(64) FreshPoint {
    Lanes<float> x, y;  ///< half-way between the surfaces, or where they are predicted to meet; in A's frame [m]
    Lanes<float> separation;
    Lanes<std::int32_t> feature;
};

struct alignas(64) FreshLanes {
    Lanes<float> normalX, normalY;  ///< from A to B, in A's frame
    FreshPoint points[2];
    Lanes<std::int32_t> count;      ///< number of points, 0 to 2
    Lanes<std::int32_t> uncertain;  ///< not 0: whether and how the two meet in this step must be predicted, or was
    Lanes<float> inset;             ///< of a disc at a face: from its point to the ends of the face; of others 0 [m]

    Lanes<float> apartX, apartY;  ///< if around: from A's centre of mass to that of B's periodic image [m]
    bool around = false;          ///< in some lane, A touches a periodic image of B

    [[gnu::always_inline]] const float* apartXFrom(int lane) const { return around ? apartX + lane : nullptr; }
    [[gnu::always_inline]] const float* apartYFrom(int lane) const { return around ? apartY + lane : nullptr; }
};

/// Number of rows of results, before the input apartX.
inline constexpr std::size_t freshRows = offsetof(FreshLanes, apartX) / (sizeof(float) * batchLanes);

}  // namespace plumb
