// SPDX-License-Identifier: MIT
// Which hazard tiles does a body touch during a tick?
#pragma once
#include <span>
#include <vector>

#include <plumb/movers/detail/slide_probe.h>

namespace plumb::detail {

/// Those within one and a half skins of the body as it moves from point to point, of the maps that it met; each once,
/// sorted by map, row and column.
std::vector<TileTouch> hazardsOn(const SlideProbe& probe, std::span<const Vec2> path);

}  // namespace plumb::detail
