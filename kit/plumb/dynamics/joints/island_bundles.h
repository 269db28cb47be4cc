// SPDX-License-Identifier: MIT
// Which parts of islands lie in the same lanes?
//
// If each lane has an island, these are the same parts of all of them: each body, link, row and joint of the layout is
// an item. If all lanes have one island, an item is a bundle: bodies with consecutive numbers, or joints that are built
// alike and follow each other; the last lanes of a bundle that is not full repeat its last joint.
#pragma once
#include <plumb/dynamics/joints/lanes/island_kernel.h>
#include <plumb/dynamics/joints/lanes/island_layout.h>

namespace plumb {

struct IslandBundles {
    std::vector<IslandShape::Joint> joints;  ///< and one past the end
    std::vector<IslandShape::Link> links;
    std::vector<IslandShape::Row> rows;
    std::vector<std::uint32_t> endPlaces, solvedPlaces;  ///< see IslandLanes
    std::vector<IslandShape::BlockPlace> blockPlaces;
    std::uint32_t bodyItems = 0, movedItems = 0, movedEnd = 0;

    /// Where the numbers of each part of the layout begin, in the first of its lanes.
    std::vector<std::uint32_t> bodyPlaces, linkPlaces, rowPlaces, jointPlaces;

    void lay(const IslandLayout& layout, LaneUse use, std::size_t lanes);
    std::size_t bytes() const;

private:
    void bundle(const IslandLayout& layout, std::size_t first, std::size_t count, std::size_t lanes);
    void placeEnds(const IslandLayout& layout, std::size_t first, std::size_t count, std::size_t bodies);
};

}  // namespace plumb
