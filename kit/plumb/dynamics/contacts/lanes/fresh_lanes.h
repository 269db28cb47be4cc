// SPDX-License-Identifier: MIT
// What has just been found of where lanes' shapes touch?
#pragma once
#include <plumb/dynamics/contacts/contact_batch.h>

namespace plumb {

/// Shapes this near count as in contact, so that what rests keeps its manifold while it trembles [m].
inline constexpr float contactMargin = 0.01f;

struct alignas(64) FreshPoint {
    Lanes<float> x, y;  ///< half way between the surfaces, or where they are foreseen to meet; in A's frame [m]
    Lanes<float> separation;
    Lanes<std::int32_t> feature;
};

struct alignas(64) FreshLanes {
    Lanes<float> normalX, normalY;  ///< from A to B, in A's frame
    FreshPoint points[2];
    Lanes<std::int32_t> count;      ///< of points, 0 to 2
    Lanes<std::int32_t> uncertain;  ///< not 0: whether and how the two meet in this step takes a closer look

    Lanes<float> apartX, apartY;  ///< if around: from A's centre of mass to B's, as the contact sees it [m]
    bool around = false;          ///< some lane's bodies meet around the world

    [[gnu::always_inline]] const float* apartXFrom(int lane) const { return around ? apartX + lane : nullptr; }
    [[gnu::always_inline]] const float* apartYFrom(int lane) const { return around ? apartY + lane : nullptr; }
};

/// Without what is known before anything is found.
inline constexpr std::size_t freshRows = offsetof(FreshLanes, apartX) / (sizeof(float) * batchLanes);

}  // namespace plumb
