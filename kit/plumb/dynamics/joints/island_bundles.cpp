// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/island_bundles.h>

#include <algorithm>

namespace plumb {

namespace {

bool areAlike(const IslandLayout& layout, std::size_t i, std::size_t j) {
    const IslandShape::Joint *a = &layout.joints[i], *b = &layout.joints[j];
    if (a[1].firstLink - a->firstLink != 1 || b[1].firstLink - b->firstLink != 1) return false;
    if (a[1].firstRow - a->firstRow != b[1].firstRow - b->firstRow || a->turnsOnly != b->turnsOnly) return false;
    for (std::uint32_t r = 0; r < a[1].firstRow - a->firstRow; ++r) {
        const IslandShape::Row &p = layout.rows[a->firstRow + r], &q = layout.rows[b->firstRow + r];
        if (p.axis[0] != q.axis[0] || p.holds != q.holds || p.bounded != q.bounded) return false;
    }
    return true;
}

std::uint32_t itemsOf(std::size_t parts, std::size_t anItem) {
    return static_cast<std::uint32_t>((parts + anItem - 1) / anItem);
}

/// Item i of some fields in this lane.
std::uint32_t placeOf(std::size_t item, int fields, std::size_t lanes, std::size_t lane) {
    return static_cast<std::uint32_t>(item * static_cast<std::size_t>(fields) * lanes + lane);
}

/// A block of its own, for what is not solved.
IslandShape::BlockPlace nowhere(const IslandLayout& layout, bool isAlone) {
    return {static_cast<std::uint32_t>(layout.blocks * (isAlone ? BlockNumbers::alone : BlockNumbers::beside)), 1, 3,
            true};
}

IslandShape::BlockPlace blockPlaceOf(const IslandLayout& layout, std::size_t joint, std::uint32_t part, bool isB,
                                     bool isAlone) {
    for (std::uint32_t e = layout.joints[joint].firstEnd; e < layout.joints[joint + 1].firstEnd; ++e) {
        const IslandShape::End& end = layout.ends[e];
        if (end.part != part || end.isB != isB) continue;
        const std::size_t size = isAlone ? BlockNumbers::alone : BlockNumbers::beside;
        const std::uint16_t along = isAlone ? 4 : 1, across = isAlone ? 1 : 3;
        return {static_cast<std::uint32_t>(end.block * size), end.transposed ? across : along,
                end.transposed ? along : across, end.isFirst};
    }
    return nowhere(layout, isAlone);
}

}  // namespace

void IslandBundles::lay(const IslandLayout& layout, LaneUse use, std::size_t lanes) {
    const std::size_t most = use == LaneUse::Joints ? lanes : 1, count = layout.jointCount();
    bodyItems = itemsOf(layout.bodies, most);
    movedItems = itemsOf(layout.moved, most);
    bodyPlaces.clear();
    for (std::size_t n = 0; n <= layout.bodies; ++n)
        bodyPlaces.push_back(placeOf(n / most, BodyField::count, lanes, n % most));
    movedEnd = bodyPlaces[layout.moved];
    joints.clear();
    links.clear();
    rows.clear();
    endPlaces.clear();
    solvedPlaces.clear();
    blockPlaces.clear();
    linkPlaces.assign(layout.links.size(), 0);
    rowPlaces.assign(layout.rows.size(), 0);
    jointPlaces.assign(count, 0);
    for (std::size_t first = 0, next = 0; first < count; first = next) {
        for (next = first + 1; next < count && next - first < most && areAlike(layout, first, next);) ++next;
        bundle(layout, first, next - first, lanes);
        placeEnds(layout, first, next - first, most);
    }
    joints.push_back({static_cast<std::uint32_t>(links.size()), static_cast<std::uint32_t>(rows.size()), 0});
}

void IslandBundles::bundle(const IslandLayout& layout, std::size_t first, std::size_t count, std::size_t lanes) {
    const IslandShape::Joint& one = layout.joints[first];
    const std::size_t firstLink = links.size(), firstRow = rows.size();
    for (std::size_t l = 0; l < count; ++l) {
        const IslandShape::Joint* joint = &layout.joints[first + l];
        jointPlaces[first + l] = placeOf(joints.size(), JointField::count, lanes, l);
        for (std::uint32_t k = joint->firstLink; k < joint[1].firstLink; ++k)
            linkPlaces[k] = placeOf(firstLink + k - joint->firstLink, LinkField::count, lanes, l);
        for (std::uint32_t r = joint->firstRow; r < joint[1].firstRow; ++r)
            rowPlaces[r] = placeOf(firstRow + r - joint->firstRow, RowField::count, lanes, l);
    }
    joints.push_back({static_cast<std::uint32_t>(firstLink), static_cast<std::uint32_t>(firstRow), 0, one.turnsOnly,
                      one.holdsPoint});
    for (std::uint32_t r = one.firstRow; r < (&one)[1].firstRow; ++r) {
        rows.push_back(layout.rows[r]);
        rows.back().link = static_cast<std::uint32_t>(firstLink);
    }
    for (std::uint32_t k = one.firstLink; k < (&one)[1].firstLink; ++k) {
        links.push_back(layout.links[k]);
        links.back().joints = static_cast<std::uint32_t>(count);
    }
}

void IslandBundles::placeEnds(const IslandLayout& layout, std::size_t first, std::size_t count, std::size_t bodies) {
    const IslandShape::Joint* one = &layout.joints[first];
    for (std::size_t l = 0; l < bodies; ++l)
        solvedPlaces.push_back(
            static_cast<std::uint32_t>((layout.moved + first + std::min(l, count - 1)) * NodeNumbers::alone));
    for (std::uint32_t k = 0; k < one[1].firstLink - one->firstLink; ++k)
        for (const bool isB : {false, true})
            for (std::size_t l = 0; l < bodies; ++l) {
                const std::size_t joint = first + std::min(l, count - 1);
                const IslandShape::Link& link = layout.links[layout.joints[joint].firstLink + k];
                endPlaces.push_back(bodyPlaces[isB ? link.b : link.a]);
                blockPlaces.push_back(l < count ? blockPlaceOf(layout, joint, k, isB, bodies > 1)
                                                : nowhere(layout, bodies > 1));
            }
}

std::size_t IslandBundles::bytes() const {
    return bytesOf(joints) + bytesOf(links) + bytesOf(rows) + bytesOf(endPlaces) + bytesOf(blockPlaces) +
           bytesOf(solvedPlaces) + bytesOf(bodyPlaces) + bytesOf(linkPlaces) + bytesOf(rowPlaces) +
           bytesOf(jointPlaces);
}

}  // namespace plumb
