// SPDX-License-Identifier: MIT
// In which order are boxes that are near each other stored near each other?
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <plumb/shapes/aabb.h>

namespace plumb {

/// The indices of the boxes, along a Z-order (Morton) curve through their centres; boxes much larger than most come
/// after the others, in classes that are each 16 times larger, so that they do not enlarge the bounds of small ones.
/// Where more than runLimit boxes share a cell of the curve, the cell is divided again, as often as needed: a few boxes
/// far away cost the others nothing. Boxes with the same centre keep their order. Any coordinates are allowed.
/// Source: Morton, "A computer oriented geodetic data base", IBM 1966; radix sort: Knuth, TAOCP 3, 5.2.5.
std::vector<std::uint32_t> mortonOrder(std::span<const Aabb> boxes, std::uint32_t runLimit);

/// The same for repeated use: keeps its memory.
class MortonSort {
public:
    MortonSort();
    MortonSort(const MortonSort&);  ///< with memory of its own
    MortonSort(MortonSort&&) noexcept;
    MortonSort& operator=(const MortonSort&);
    MortonSort& operator=(MortonSort&&) noexcept;
    ~MortonSort();

    /// Valid until the next call.
    std::span<const std::uint32_t> operator()(std::span<const Aabb> boxes, std::uint32_t runLimit);

    /// Memory in use.
    std::size_t bytes() const;

private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

}  // namespace plumb
