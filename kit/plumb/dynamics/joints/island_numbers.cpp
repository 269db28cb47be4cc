// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/island_numbers.h>

#include <algorithm>
#include <cmath>

namespace plumb {

namespace {

/// The part of the view that is the same for all islands of a layout.
void showLayout(IslandLanes& view, const IslandLayout& layout, const IslandBundles& bundles) {
    view.links = bundles.links.data();
    view.rows = bundles.rows.data();
    view.joints = bundles.joints.data();
    view.endPlaces = bundles.endPlaces.data();
    view.bodyItems = bundles.bodyItems;
    view.movedItems = bundles.movedItems;
    view.linkCount = static_cast<std::uint32_t>(bundles.links.size());
    view.rowCount = static_cast<std::uint32_t>(bundles.rows.size());
    view.jointCount = static_cast<std::uint32_t>(bundles.joints.size() - 1);
    view.movedEnd = bundles.movedEnd;
    view.laid = layout.joints.data();
    view.laidRows = layout.rows.data();
    view.bodyPlaces = bundles.bodyPlaces.data();
    view.rowPlaces = bundles.rowPlaces.data();
    view.solvedPlaces = bundles.solvedPlaces.data();
    view.blockPlaces = bundles.blockPlaces.data();
    view.steps = layout.steps.data();
    view.lowers = layout.lowers.data();
    view.updates = layout.updates.data();
    view.moved = layout.moved;
    view.laidCount = layout.jointCount();
    view.stepCount = static_cast<std::uint32_t>(layout.steps.size() - 1);
    view.blocks = layout.blocks;
    view.firstFill = layout.firstFill;
    view.someFree = layout.someFree;
    view.isHeld = layout.bodies > layout.moved;
    view.compliance = layout.isTree ? 0 : relativeCompliance;
    view.slack = layout.isTree ? treeCompliance : 0;
}

}  // namespace

/// A lane without a body has one that keeps its place: all numbers stay finite.
void IslandNumbers::layOut(std::span<JointIsland* const> some, int mostFloats) {
    const IslandCode now = islandCode(static_cast<int>(some.size()), mostFloats);
    const bool isNew = layout != some.front()->layout || width != some.size() || code.kernel != now.kernel;
    islands.assign(some.begin(), some.end());
    view.active = active.data();
    view.missed = missed.data();
    view.lost = lost.data();
    view.heavy = heavy.data();
    view.work = work.data();
    view.factored = false;
    if (!isNew) return;
    layout = some.front()->layout;
    width = some.size();
    code = now;
    bundles.lay(*layout, code.use, code.lanes);
    showLayout(view, *layout, bundles);
    const bool isAlone = code.use == LaneUse::Joints;
    const std::size_t block = isAlone ? BlockNumbers::alone : BlockNumbers::beside * width;
    const std::size_t node = isAlone ? NodeNumbers::alone : NodeNumbers::beside * width;
    const std::size_t nodes = layout->moved + layout->jointCount();
    const std::pair<double**, std::size_t> arrays[] = {
        {&view.body, view.bodyItems * std::size_t{BodyField::count} * code.lanes},
        {&view.link, view.linkCount * std::size_t{LinkField::count} * code.lanes},
        {&view.row, view.rowCount * std::size_t{RowField::count} * code.lanes},
        {&view.joint, view.jointCount * std::size_t{JointField::count} * code.lanes},
        {&view.block, (layout->blocks + 1) * block},
        {&view.solution, nodes * node},
        {&view.inverse, layout->blocks * block}};
    std::size_t total = 0;
    constexpr std::size_t line = 8;  // doubles in a cache line: no vector lies across two of them
    for (const auto& [array, size] : arrays) total += size + line;
    items_.assign(total + line, 0.0);
    double* next = items_.data();
    for (const auto& [array, size] : arrays) {
        const auto address = reinterpret_cast<std::uintptr_t>(next) / sizeof(double);
        *array = next + (line - address % line) % line;
        next = *array + size;
    }
    for (std::size_t i = 0; i < view.bodyItems; ++i)
        for (const int field : {BodyField::OwnMass, BodyField::Mass, BodyField::KeepLinear, BodyField::KeepAngular})
            std::fill_n(view.body + (i * BodyField::count + static_cast<std::size_t>(field)) * code.lanes, code.lanes,
                        1.0);
}

void IslandNumbers::fillLanes() const {
    if (code.use == LaneUse::Islands) return;
    const auto fill = [this](double* items, std::size_t fields, std::size_t used) {
        for (std::size_t f = 0; f < fields; ++f)
            std::fill(items + f * code.lanes + used, items + (f + 1) * code.lanes, items[f * code.lanes + used - 1]);
    };
    for (std::size_t b = 0; b < view.jointCount; ++b) {
        const std::size_t used = view.links[view.joints[b].firstLink].joints;
        if (used == code.lanes) continue;
        for (std::size_t k = view.joints[b].firstLink; k < view.joints[b + 1].firstLink; ++k)
            fill(view.link + k * LinkField::count * code.lanes, LinkField::count, used);
        for (std::size_t r = view.joints[b].firstRow; r < view.joints[b + 1].firstRow; ++r)
            fill(view.row + r * RowField::count * code.lanes, RowField::count, used);
    }
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
