// SPDX-License-Identifier: MIT
// How is a joint island built? Islands that are built alike share one layout, and are solved side by side.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include <plumb/dynamics/joints/joint_form.h>
#include <plumb/math/detail/block_plan.h>

namespace plumb {

struct IslandLayout : IslandShape {
    std::uint32_t moved = 0, bodies = 0;  ///< bodies that impulses move, and all
    std::vector<IslandShape::Link> links;
    std::vector<IslandShape::Row> rows;
    std::vector<IslandShape::End> ends;
    std::vector<IslandShape::Joint> joints;   ///< and one past the end
    std::uint32_t blocks = 0, firstFill = 0;  ///< blocks from firstFill on are not of an edge
    std::vector<IslandShape::Step> steps;     ///< and one past the end
    std::vector<IslandShape::Lower> lowers;
    std::vector<IslandShape::Update> updates;
    bool someFree = false;     ///< some row does not hold
    bool someAlong = false;    ///< some link turns along (see IslandShape::Link)
    bool someMissing = false;  ///< some axis depends on velocities
    bool isTree = false;       ///< no loops, and all bodies can turn: its rows are independent
    bool isSwept = false;      ///< to solve it at once would take too much work; there is no more to tell

    std::uint32_t jointCount() const { return static_cast<std::uint32_t>(joints.size() - 1); }
    std::size_t bytes() const {
        return bytesOf(links) + bytesOf(rows) + bytesOf(ends) + bytesOf(joints) + bytesOf(steps) + bytesOf(lowers) +
               bytesOf(updates);
    }
};

/// A joint of an island, and the nodes of its links.
struct LaidJoint {
    JointForm form;
    std::array<IslandShape::Link, maxLinks> link{};
};

/// The layouts of all islands that there are.
class IslandLayouts {
public:
    /// Forgets those that nobody has any more.
    void renew();
    /// allTurn: all the island's moved bodies can turn.
    std::shared_ptr<const IslandLayout> find(std::uint32_t moved, std::uint32_t bodies, bool allTurn,
                                             const std::vector<LaidJoint>& joints);
    std::size_t bytes() const;

private:
    std::map<std::vector<std::uint32_t>, std::shared_ptr<const IslandLayout>> known_;
};

}  // namespace plumb
