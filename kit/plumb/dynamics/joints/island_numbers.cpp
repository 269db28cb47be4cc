// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/island_numbers.h>

#include <algorithm>
#include <cmath>

namespace plumb {

namespace {

/// The part of the view that is the same for all islands of a layout.
void showLayout(IslandLanes& view, const IslandLayout& layout) {
    view.links = layout.links.data();
    view.rows = layout.rows.data();
    view.ends = layout.ends.data();
    view.joints = layout.joints.data();
    view.steps = layout.steps.data();
    view.lowers = layout.lowers.data();
    view.updates = layout.updates.data();
    view.moved = layout.moved;
    view.bodies = layout.bodies;
    view.linkCount = static_cast<std::uint32_t>(layout.links.size());
    view.rowCount = static_cast<std::uint32_t>(layout.rows.size());
    view.jointCount = layout.jointCount();
    view.stepCount = static_cast<std::uint32_t>(layout.steps.size() - 1);
    view.blocks = layout.blocks;
    view.firstFill = layout.firstFill;
    view.someFree = layout.someFree;
    view.compliance = layout.isTree ? 0 : relativeCompliance;
    view.slack = layout.isTree ? treeCompliance : 0;
    view.factored = false;
}

}  // namespace

void IslandNumbers::layOut(std::span<JointIsland* const> some) {
    const bool isNew = layout != some.front()->layout || width != some.size();
    layout = some.front()->layout;
    width = some.size();
    islands.assign(some.begin(), some.end());
    kernel = &islandKernel(static_cast<int>(width));
    showLayout(view, *layout);
    const std::size_t nodes = layout->moved + layout->jointCount();
    const std::pair<double**, std::size_t> arrays[] = {
        {&view.body, layout->bodies * std::size_t{BodyField::count}},
        {&view.link, layout->links.size() * LinkField::count},
        {&view.row, layout->rows.size() * RowField::count},
        {&view.joint, layout->jointCount() * std::size_t{JointField::count}},
        {&view.block, layout->blocks * std::size_t{9}},
        {&view.solution, nodes * 3},
        {&view.inverse, layout->blocks * std::size_t{9}}};
    std::size_t total = 0;
    for (const auto& [array, size] : arrays) total += size * width;
    constexpr std::size_t line = 8;  // doubles in a cache line: no vector lies across two of them
    if (isNew) items_.assign(total + line, 0.0);
    const auto address = reinterpret_cast<std::uintptr_t>(items_.data()) / sizeof(double);
    double* next = items_.data() + (line - address % line) % line;
    for (const auto& [array, size] : arrays) next = (*array = next) + size * width;
    view.active = active.data();
    view.missed = missed.data();
    view.lost = lost.data();
    view.heavy = heavy.data();
}

double IslandNumbers::errorOf(std::size_t i, std::size_t lane) const {
    const double q = row(i, RowField::Coordinate, lane);
    if (layout->rows[i].axis[0] == RowAxis::Turning) return 0;
    if (layout->rows[i].holds) return std::fabs(q);
    return std::max({q - row(i, RowField::LimitUpper, lane), row(i, RowField::LimitLower, lane) - q, 0.0});
}

double IslandNumbers::openingOf(std::size_t lane) const {
    double most = 0;
    for (std::size_t i = 0; i < layout->rows.size(); ++i)
        most = std::max(most, errorOf(i, lane) - row(i, RowField::StartError, lane));
    return most;
}

}  // namespace plumb
