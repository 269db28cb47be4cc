// SPDX-License-Identifier: MIT
// How is a joint island built? Islands that are built alike share one layout, and are solved side by side.
#pragma once
#include <map>
#include <memory>
#include <vector>

#include <plumb/dynamics/joints/block_plan.h>
#include <plumb/dynamics/joints/joint_form.h>

namespace plumb {

struct IslandLayout : IslandShape {
    std::uint32_t moved = 0, bodies = 0;  ///< bodies that impulses move, and all
    std::vector<Link> links;
    std::vector<Row> rows;
    std::vector<End> ends;
    std::vector<Joint> joints;                ///< and one past the end
    std::uint32_t blocks = 0, firstFill = 0;  ///< blocks from firstFill on are not of an edge
    std::vector<Step> steps;                  ///< and one past the end
    std::vector<Lower> lowers;
    std::vector<Update> updates;
    bool someFree = false;     ///< some row does not hold
    bool someMissing = false;  ///< some axis depends on velocities

    std::uint32_t jointCount() const { return static_cast<std::uint32_t>(joints.size() - 1); }
    std::size_t bytes() const {
        return bytesOf(links) + bytesOf(rows) + bytesOf(ends) + bytesOf(joints) + bytesOf(steps) + bytesOf(lowers) +
               bytesOf(updates);
    }
};

/// A joint of an island, and the nodes of its links.
struct LaidJoint {
    JointForm form;
    std::array<IslandLayout::Link, maxLinks> link{};
};

/// The layouts of all islands that were asked for since the last renewal or the one before it.
class IslandLayouts {
public:
    /// Forgets what was not asked for since the last call.
    void renew();
    /// Null if the island has so many loops that it must be swept.
    std::shared_ptr<const IslandLayout> find(std::uint32_t moved, std::uint32_t bodies,
                                             const std::vector<LaidJoint>& joints);
    std::size_t bytes() const;

private:
    using Known = std::map<std::vector<std::uint32_t>, std::shared_ptr<const IslandLayout>>;
    Known now_, before_;
};

}  // namespace plumb
