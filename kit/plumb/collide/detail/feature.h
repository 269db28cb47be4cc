// SPDX-License-Identifier: MIT
// How is a contact point identified in the next step? By the corner or edge of A and of B that made it.
#pragma once
#include <cstddef>
#include <cstdint>

namespace plumb {

/// A corner or an edge of one shape; up to 128 of each.
struct Feature {
    std::uint8_t code = 0;

    static Feature corner(std::size_t index) { return {static_cast<std::uint8_t>(index)}; }
    static Feature edge(std::size_t index) { return {static_cast<std::uint8_t>(0x80u | index)}; }
};

inline std::uint16_t featureOf(Feature a, Feature b) {
    return static_cast<std::uint16_t>(a.code << 8 | b.code);
}
inline std::uint16_t swapped(std::uint16_t feature) {
    return static_cast<std::uint16_t>(feature << 8 | feature >> 8);
}

}  // namespace plumb
