// SPDX-License-Identifier: MIT
// Which hazard tiles does a body touch on its way through a tick?
#pragma once
#include <span>
#include <vector>

#include <plumb/movers/detail/slide_probe.h>

namespace plumb::detail {

/// Those that come within a skin and a half of it as it goes from place to place, of the maps that it met; each once,
/// by map, row and column.
std::vector<TileTouch> hazardsOn(const SlideProbe& probe, std::span<const Vec2> way);

}  // namespace plumb::detail
