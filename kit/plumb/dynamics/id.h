// SPDX-License-Identifier: MIT
// Which body, which joint? An id stays valid until its thing is removed, and is never reused.
#pragma once
#include <cstdint>
#include <string>

namespace plumb {

/// index: the slot; generation: how often the slot was used before; world: the world it belongs to, 0 for none.
struct BodyId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;
    std::uint32_t world = 0;
    friend bool operator==(const BodyId&, const BodyId&) = default;
};

struct JointId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;
    std::uint32_t world = 0;
    friend bool operator==(const JointId&, const JointId&) = default;
};

}  // namespace plumb
