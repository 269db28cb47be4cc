// SPDX-License-Identifier: MIT
// Which manifolds has the narrow phase just computed for the lanes of a batch?
#pragma once
#include <plumb/dynamics/contacts/contact_batch.h>
#include <plumb/math/detail/wide_ops.h>

namespace plumb {

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

/// How long is the step for which contacts are prepared?
struct StepLength {
    float inverse;  ///< 1/dt [1/s]
    float ratio;    ///< of dt to that of the step from which impulses are carried over: they grow with it [-]
    int halves;     ///< half sub-steps in a step [-]
};

/// Writes into some of W lanes.
template <int W>
struct LaneWriter {
    FreshLanes& fresh;
    int lane;  ///< the first
    typename Wide<W>::Mask wanted;

    template <class T>
    [[gnu::always_inline]] void put(T* row, typename LanesOf<W, T>::Type v) const {
        storeLanes(row + lane, wanted ? v : loadLanes<W>(row + lane));
    }
};

/// Number of rows of results, before the input apartX.
inline constexpr std::size_t freshRows = offsetof(FreshLanes, apartX) / (sizeof(float) * batchLanes);

}  // namespace plumb
