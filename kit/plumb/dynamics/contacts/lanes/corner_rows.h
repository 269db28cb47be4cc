// SPDX-License-Identifier: MIT
// How are the corners of polygons stored for the lanes of the narrow phase?
#pragma once
#include <plumb/dynamics/contacts/contact_batch.h>

namespace plumb {

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

}  // namespace plumb
