// SPDX-License-Identifier: MIT
// Of which parts is a joint island built? Plain data, which code for several lanes reads.
#pragma once
#include <cstdint>

namespace plumb {

/// The direction along which a row measures how B's anchor lies from A's.
enum class RowAxis : std::uint8_t {
    World,    ///< fixed in the world
    OnA,      ///< fixed to A's body
    Along,    ///< from A's anchor to B's
    Towards,  ///< the same; along x where the anchors meet
    Across,   ///< at right angles to Towards
    Missing,  ///< along the velocity that B lacks; along x where it lacks none
    Beside,   ///< at right angles to Missing
    Turning,  ///< no direction: the row measures the angle of B less that of A
};

/// Pairs of anchors, rows and blocks, by their numbers. The nodes are the bodies that impulses move, then the joints.
/// Bodies that impulses do not move follow the other bodies; they are not solved for.
struct IslandShape {
    struct Link {
        std::uint32_t a = 0, b = 0;  ///< nodes of its bodies
        std::uint32_t joints = 1;    ///< in the lanes of the item that it stands for (see island_bundles.h)
        bool turnsAlong = false;     ///< some row that holds has the direction from A's anchor to B's
    };
    struct Row {
        std::uint32_t link = 0;   ///< its first link
        std::uint32_t parts = 1;  ///< 2: the next link belongs to it, too
        RowAxis axis[2] = {};     ///< of each part
        bool holds = true, bounded = false;
    };
    /// A body that moves, at one end of a joint's link.
    struct End {
        std::uint32_t node = 0, block = 0;
        std::uint8_t part = 0;  ///< number of the link in the joint
        bool isB = false, transposed = false;
        bool isFirst = true;  ///< no other end of the joint before it has the same block
    };
    /// Where a row of a joint, at one end of a link, stands in a block: so far apart are its numbers, and those of the
    /// joint's rows.
    struct BlockPlace {
        std::uint32_t first = 0;
        std::uint16_t column = 0, row = 0;
        bool isFirst = true;  ///< see End
    };
    struct Joint {
        std::uint32_t firstLink = 0, firstRow = 0, firstEnd = 0;
        bool turnsOnly = false;   ///< see JointForm
        bool holdsPoint = false;  ///< keeps the anchors together
    };
    /// One step of the elimination (see block_plan.h). size: number of unknowns of the node.
    struct Step {
        std::uint32_t node = 0, size = 0, firstLower = 0, firstUpdate = 0;
    };
    struct Lower {
        std::uint32_t node = 0, block = 0, size = 0;
    };
    struct Update {
        std::uint32_t target = 0, left = 0, right = 0;
        std::uint16_t leftSize = 0, rightSize = 0;
    };
};

}  // namespace plumb
