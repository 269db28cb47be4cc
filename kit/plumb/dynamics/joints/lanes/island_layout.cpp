// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/lanes/island_layout.h>

#include <algorithm>

#include <plumb/math/detail/disjoint_sets.h>

namespace plumb {

namespace {

/// An island is swept if its elimination needs more than fewUpdates block updates and more than updatesPerNode per
/// node. What is narrow, such as a truss, needs few, however long it is and however many loops it has.
constexpr std::size_t updatesPerNode = 8;
constexpr std::size_t fewUpdates = 4000;

/// All bodies that impulses do not move count as one.
bool isTree(std::uint32_t moved, const std::vector<LaidJoint>& joints) {
    DisjointSets groups(moved + 1);
    for (const LaidJoint& joint : joints)
        for (std::size_t k = 0; k < joint.form.links; ++k) {
            const BodyIndex a = std::min(joint.link[k].a, moved), b = std::min(joint.link[k].b, moved);
            if (groups.of(a) == groups.of(b)) return false;
            groups.unite(a, b);
        }
    return true;
}

/// All that the layout depends on, as numbers.
std::vector<std::uint32_t> keyOf(std::uint32_t moved, std::uint32_t bodies, bool allTurn,
                                 const std::vector<LaidJoint>& joints) {
    std::vector<std::uint32_t> key{moved, bodies, allTurn ? 1U : 0U};
    for (const LaidJoint& joint : joints) {
        const JointForm& form = joint.form;
        key.push_back(static_cast<std::uint32_t>(form.links * 8 + form.rows * 2 + (form.turnsOnly ? 1 : 0)));
        for (std::size_t k = 0; k < form.links; ++k) key.insert(key.end(), {joint.link[k].a, joint.link[k].b});
        for (std::size_t r = 0; r < form.rows; ++r) {
            const auto axis = static_cast<std::uint32_t>(form.row[r].axis);
            key.push_back(axis * 4 + (form.row[r].holds ? 2 : 0) + (form.row[r].bounded ? 1 : 0));
        }
        if (form.links > 1) key.push_back(static_cast<std::uint32_t>(form.secondAxis));
    }
    return key;
}

class Laying {
public:
    Laying(std::uint32_t moved, std::uint32_t bodies) {
        layout_.moved = moved;
        layout_.bodies = bodies;
    }

    std::shared_ptr<const IslandLayout> lay(const std::vector<LaidJoint>& joints, bool allTurn) {
        for (const LaidJoint& joint : joints) addJoint(joint);
        layout_.joints.push_back({linkCount(), rowCount(), endCount()});
        const std::uint32_t nodes = layout_.moved + layout_.jointCount();
        const bool hasNoLoops = isTree(layout_.moved, joints);
        const auto plan = planBlocks(layout_.moved, layout_.jointCount(), edges_,
                                     std::max(fewUpdates, updatesPerNode * nodes), !hasNoLoops);
        if (plan == nullptr) return swept();
        takePlan(*plan);
        layout_.isTree = allTurn && hasNoLoops;
        return std::make_shared<const IslandLayout>(std::move(layout_));
    }

private:
    static std::shared_ptr<const IslandLayout> swept() {
        IslandLayout layout;
        layout.isSwept = true;
        return std::make_shared<const IslandLayout>(std::move(layout));
    }
    std::uint32_t linkCount() const { return static_cast<std::uint32_t>(layout_.links.size()); }
    std::uint32_t rowCount() const { return static_cast<std::uint32_t>(layout_.rows.size()); }
    std::uint32_t endCount() const { return static_cast<std::uint32_t>(layout_.ends.size()); }

    void addJoint(const LaidJoint& joint) {
        const JointForm& form = joint.form;
        const auto node = layout_.moved + static_cast<std::uint32_t>(layout_.joints.size());
        const auto holds = [&form](std::size_t r) { return form.row[r].axis == RowAxis::World && form.row[r].holds; };
        const bool holdsPoint = form.rows > 1 && holds(0) && holds(1);
        layout_.joints.push_back({linkCount(), rowCount(), endCount(), form.turnsOnly, holdsPoint});
        for (std::size_t r = 0; r < form.rows; ++r) {
            const RowForm& row = form.row[r];
            layout_.rows.push_back({linkCount(),
                                    static_cast<std::uint32_t>(form.links),
                                    {row.axis, form.secondAxis},
                                    row.holds,
                                    row.bounded});
            layout_.someFree = layout_.someFree || !row.holds;
            layout_.someMissing = layout_.someMissing || row.axis == RowAxis::Missing;
        }
        for (std::size_t k = 0; k < form.links; ++k) {
            layout_.links.push_back(joint.link[k]);
            for (std::size_t r = 0; r < form.rows; ++r) {
                const RowAxis axis = k == 0 ? form.row[r].axis : form.secondAxis;
                layout_.links.back().turnsAlong |= form.row[r].holds && axis == RowAxis::Along;
            }
            layout_.someAlong |= layout_.links.back().turnsAlong;
            addEnd(node, joint.link[k].a, k, false);
            addEnd(node, joint.link[k].b, k, true);
        }
    }

    void addEnd(std::uint32_t joint, std::uint32_t node, std::size_t part, bool isB) {
        if (node >= layout_.moved) return;
        bool isFirst = true;
        for (std::size_t e = layout_.joints.back().firstEnd; e < layout_.ends.size(); ++e)
            isFirst = isFirst && layout_.ends[e].node != node;
        layout_.ends.push_back({node, 0, static_cast<std::uint8_t>(part), isB, false, isFirst});
        edges_.push_back({joint, node});
    }

    std::uint32_t sizeOf(std::uint32_t node) const {
        if (node < layout_.moved) return 3;
        const std::size_t j = node - layout_.moved;
        return layout_.joints[j + 1].firstRow - layout_.joints[j].firstRow;
    }

    void takePlan(const BlockPlan& plan) {
        layout_.blocks = plan.blocks;
        layout_.firstFill = layout_.moved + layout_.jointCount();
        for (std::size_t e = 0; e < plan.places.size(); ++e) {
            layout_.ends[e].block = plan.places[e].block;
            layout_.ends[e].transposed = plan.places[e].transposed;
            layout_.firstFill = std::max(layout_.firstFill, plan.places[e].block + 1);
        }
        for (const BlockPlan::Step& step : plan.steps) {
            const bool isEnd = layout_.steps.size() + 1 == plan.steps.size();
            layout_.steps.push_back({step.node, isEnd ? 0 : sizeOf(step.node), step.firstLower, step.firstUpdate});
        }
        std::vector<std::uint32_t> rowsOf(plan.blocks, 0);
        for (const BlockPlan::Lower& lower : plan.lowers) {
            layout_.lowers.push_back({lower.node, lower.block, sizeOf(lower.node)});
            rowsOf[lower.block] = sizeOf(lower.node);
        }
        for (const BlockPlan::Update& update : plan.updates)
            layout_.updates.push_back({update.target, update.left, update.right,
                                       static_cast<std::uint16_t>(rowsOf[update.left]),
                                       static_cast<std::uint16_t>(rowsOf[update.right])});
    }

    IslandLayout layout_;
    std::vector<BlockPlan::Edge> edges_;
};

}  // namespace

void IslandLayouts::renew() {
    std::erase_if(known_, [](const auto& one) { return one.second.use_count() == 1; });
}

std::shared_ptr<const IslandLayout> IslandLayouts::find(std::uint32_t moved, std::uint32_t bodies, bool allTurn,
                                                        const std::vector<LaidJoint>& joints) {
    const auto [known, isNew] = known_.try_emplace(keyOf(moved, bodies, allTurn, joints));
    if (isNew) known->second = Laying(moved, bodies).lay(joints, allTurn);
    return known->second;
}

std::size_t IslandLayouts::bytes() const {
    std::size_t bytes = 0;
    for (const auto& [key, layout] : known_) bytes += bytesOf(key) + layout->bytes();
    return bytes;
}

}  // namespace plumb
