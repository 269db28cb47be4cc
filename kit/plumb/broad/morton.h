// SPDX-License-Identifier: MIT
// In which order do boxes that lie near each other stand near each other?
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <plumb/shapes/aabb.h>

namespace plumb {

/// The indices of the boxes, along a Z-shaped curve through their centres; boxes much larger than most come after the
/// others, class by class, each 16 times larger, so that they do not blow up their neighbours' bounds.
/// Where more than runLimit boxes share a cell of the curve, the cell is divided anew, as often as it takes: few boxes
/// far away cost the others nothing. Boxes that are equally placed keep their order. Any coordinates will do.
/// Source: Morton, "A computer oriented geodetic data base", IBM 1966; radix sort: Knuth, TAOCP 3, 5.2.5.
std::vector<std::uint32_t> mortonOrder(std::span<const Aabb> boxes, std::uint32_t runLimit);

/// The same, again and again: keeps its memory.
class MortonSort {
public:
    MortonSort();
    MortonSort(const MortonSort&);  ///< with memory of its own
    MortonSort(MortonSort&&) noexcept;
    MortonSort& operator=(const MortonSort&);
    MortonSort& operator=(MortonSort&&) noexcept;
    ~MortonSort();

    /// Holds until the next call.
    std::span<const std::uint32_t> operator()(std::span<const Aabb> boxes, std::uint32_t runLimit);

    /// Of memory that it holds.
    std::size_t bytes() const;

private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

}  // namespace plumb
