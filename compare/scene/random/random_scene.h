// SPDX-License-Identifier: MIT
// Which scene belongs to a seed?
#pragma once
#include <cstdint>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// 20 to 3,000 dynamic bodies in a closed world, for 300 steps of 1/60 s, called random_<seed>: heaps, drums, hills,
/// levels of tiles, gases, and blocks laid at rest; a fifth of the scenes have dolls, bridges, ropes and cars. A scene
/// is the same to the last bit on every machine. Bodies start without overlap, and none can leave. Test: "the scenes of
/// seeds 1 to 80 are those they have been"
Scene randomScene(std::uint64_t seed);

}  // namespace plumb::compare
