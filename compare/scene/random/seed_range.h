// SPDX-License-Identifier: MIT
// Which seeds does a name on the command line stand for?
#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace plumb::compare {

struct SeedRange {
    std::uint64_t first = 0, last = 0;  ///< both are included
};

/// "random:SEED" or "random:A..B"; empty for a name that does not begin with "random:". Throws std::invalid_argument,
/// saying what was wanted, if the rest of the name has another form, and for more than 10,000 seeds.
std::optional<SeedRange> seedRangeOf(const std::string& name);

}  // namespace plumb::compare
