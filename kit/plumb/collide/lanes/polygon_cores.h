// SPDX-License-Identifier: MIT
// The corners of W polygons side by side.
#pragma once
#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/math/detail/wide_ops.h>
#include <plumb/math/detail/wide_rows.h>

namespace plumb {

/// Times the size of coordinates: the length that counts as their rounding, as in collide/detail/core.h.
inline constexpr float lengthRoundings = 4 * 1.1920929e-7f;

/// Rows from a polygon's count on are copies of its first corner.
template <int W>
struct PolygonCores {
    using F = typename Wide<W>::Float;

    F x[mostCorners], y[mostCorners], normalX[mostCorners], normalY[mostCorners];
    typename Wide<W>::Int count;
    int most;  ///< the largest count

    int after(int corner) const { return corner + 1 < mostCorners ? corner + 1 : 0; }

    void load(const std::int32_t* counts, const std::uint32_t* proxies, const CornerTable& table) {
        count = loadLanes<W>(counts);
        most = mostOf(counts);
        loadFour(0, table.first, proxies);
        if (most > 4) loadFour(4, table.more, proxies);
        if (most == 4) {
            x[4] = x[0];
            y[4] = y[0];
        }
    }

    static int mostOf(const std::int32_t* counts) {
        int most = 2;
        for (int i = 0; i < W; ++i) most = counts[i] > most ? counts[i] : most;
        return most;
    }

    void loadFour(int first, const CornerRows* corners, const std::uint32_t* proxies) {
        const float* rows = corners->x;
        const auto put = [first](F* to, const Rows<W>& from) {
            to[first] = from.x;
            to[first + 1] = from.y;
            to[first + 2] = from.z;
            to[first + 3] = from.w;
        };
        put(x, loadRows<W, 16>(rows, proxies));
        put(y, loadRows<W, 16>(rows + 4, proxies));
        put(normalX, loadRows<W, 16>(rows + 8, proxies));
        put(normalY, loadRows<W, 16>(rows + 12, proxies));
    }
};

}  // namespace plumb
