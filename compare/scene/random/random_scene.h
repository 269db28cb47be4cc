// SPDX-License-Identifier: MIT
// Which scene belongs to a seed, and which seeds does a name stand for?
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include <compare/scene/scene.h>

namespace plumb::compare {

/// 20 to 3,000 dynamic bodies in a closed world, for 300 steps of 1/60 s, called random_<seed>: heaps, drums, hills,
/// levels of tiles, gases, and blocks laid at rest; a fifth of the scenes have dolls, bridges, ropes and cars. A scene
/// is the same to the last bit on every machine. Bodies start without overlap, and none can leave. Test: "the scenes of
/// seeds 1 to 80 are those they have been"
Scene randomScene(std::uint64_t seed);

struct SeedRange {
    std::uint64_t first = 0, last = 0;  ///< both are included
};

/// "random:SEED" or "random:A..B"; empty for a name that does not begin with "random:". Throws std::invalid_argument,
/// saying what was wanted, if the rest of the name has another form, and for more than 10,000 seeds.
std::optional<SeedRange> seedRangeOf(const std::string& name);

}  // namespace plumb::compare
