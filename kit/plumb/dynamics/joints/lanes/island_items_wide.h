// SPDX-License-Identifier: MIT
// What do the lanes of a vector hold?
//
// Either W islands of one layout: each lane has one of them, and all lanes do the same. Or one island: then the lanes
// of an item hold bodies with consecutive numbers, or links and rows of joints that are built alike (see
// island_bundles.h), so that a single machine fills the vectors, too. Both compute the same numbers in the same order,
// so the bits are the same. They differ in what this file has: how a link reads and pushes its two bodies, and how an
// answer for the whole island is found.
#pragma once
#include <type_traits>

#include <plumb/dynamics/joints/lanes/island_kernel.h>
#include <plumb/math/detail/wide_ops.h>

namespace plumb {

/// The fields of one item.
template <int W>
struct Slots {
    using D = typename Wide<W>::Double;
    static constexpr int N = Wide<W>::doubles;

    double* data;
    D operator[](int field) const { return loadLanes<W>(static_cast<const double*>(data + field * N)); }
    void set(int field, D value) const { storeLanes(data + field * N, value); }
    void add(int field, D value) const { set(field, (*this)[field] + value); }
};

template <int W, LaneUse use>
struct IslandItems {
    using D = typename Wide<W>::Double;
    using S = Slots<W>;
    static constexpr int N = S::N;
    static constexpr bool holdsJoints = use == LaneUse::Joints;
    static constexpr std::size_t bodiesAnEnd = holdsJoints ? N : 1;

    static constexpr D all(double value) { return D{} + value; }

    static S bodyOf(const IslandLanes& v, std::uint32_t i) { return {v.body + i * std::size_t{BodyField::count} * N}; }
    static S linkOf(const IslandLanes& v, std::uint32_t i) { return {v.link + i * std::size_t{LinkField::count} * N}; }
    static S rowOf(const IslandLanes& v, std::uint32_t i) { return {v.row + i * std::size_t{RowField::count} * N}; }

    /// The body at one end of a link: of each lane another one, if lanes hold joints.
    struct BodyAtEnd {
        const double* data[bodiesAnEnd];
        D operator[](int field) const {
            if constexpr (holdsJoints) {
                D lanes{};
                for (std::size_t l = 0; l < bodiesAnEnd; ++l) lanes[l] = data[l][field * N];
                return lanes;
            } else {
                return loadLanes<W>(data[0] + field * N);
            }
        }
    };
    static const std::uint32_t* placesOf(const IslandLanes& v, std::uint32_t link, bool isB) {
        return v.endPlaces + (2 * link + (isB ? 1 : 0)) * bodiesAnEnd;
    }
    static BodyAtEnd endOf(const IslandLanes& v, std::uint32_t link, bool isB) {
        const std::uint32_t* places = placesOf(v, link, isB);
        BodyAtEnd end;
        for (std::size_t l = 0; l < bodiesAnEnd; ++l) end.data[l] = v.body + places[l];
        return end;
    }

    /// Adds to the bodies at both ends of a link that impulses move, joint after joint: two joints may share a body.
    static void addToEnds(const IslandLanes& v, std::uint32_t link, int field, D a, D b) {
        const std::uint32_t *atA = placesOf(v, link, false), *atB = placesOf(v, link, true);
        const std::size_t joints = holdsJoints ? v.links[link].joints : 1;
        for (std::size_t l = 0; l < joints; ++l) {
            if (atA[l] < v.movedEnd) addLane(v.body + atA[l] + field * N, a, l);
            if (atB[l] < v.movedEnd) addLane(v.body + atB[l] + field * N, b, l);
        }
    }
    /// What both ends of a link get in three fields.
    struct Push {
        D a[3], b[3];
    };
    static void pushEnds(const IslandLanes& v, std::uint32_t link, int field, const Push* pushes, int count) {
        const std::uint32_t *atA = placesOf(v, link, false), *atB = placesOf(v, link, true);
        const std::size_t joints = holdsJoints ? v.links[link].joints : 1;
        for (std::size_t l = 0; l < joints; ++l)
            for (int k = 0; k < count; ++k)
                for (int c = 0; c < 3; ++c) {
                    if (atA[l] < v.movedEnd) addLane(v.body + atA[l] + (field + c) * N, pushes[k].a[c], l);
                    if (atB[l] < v.movedEnd) addLane(v.body + atB[l] + (field + c) * N, pushes[k].b[c], l);
                }
    }
    static void addLane(double* to, const D& value, [[maybe_unused]] std::size_t lane) {
        if constexpr (holdsJoints)
            *to += value[lane];
        else
            storeLanes(to, loadLanes<W>(static_cast<const double*>(to)) + value);
    }
    /// 1 where impulses move the body at an end, else 0.
    static D movesAt(const IslandLanes& v, std::uint32_t link, bool isB) {
        const std::uint32_t* places = placesOf(v, link, isB);
        if constexpr (holdsJoints) {
            D moves{};
            for (int l = 0; l < N; ++l) moves[l] = places[l] < v.movedEnd ? 1 : 0;
            return moves;
        } else {
            return all(*places < v.movedEnd ? 1 : 0);
        }
    }

    /// A number that each island has: the same in all lanes, if they hold joints.
    static D ofIsland(const double* numbers) {
        if constexpr (holdsJoints)
            return all(*numbers);
        else
            return loadLanes<W>(numbers);
    }
    static void keepOfIsland(double* numbers, D value) {
        if constexpr (holdsJoints)
            *numbers = value[0];
        else
            storeLanes(numbers, value);
    }
    static D largestOfIsland(D value) {
        if constexpr (holdsJoints) {
            double most = value[0];
            for (int l = 1; l < N; ++l) most = value[l] > most ? value[l] : most;
            return all(most);
        } else {
            return value;
        }
    }
    static auto isActive(const IslandLanes& v) { return ofIsland(v.active) > D{}; }
};

}  // namespace plumb
