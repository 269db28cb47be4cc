// SPDX-License-Identifier: MIT
// Where are the numbers of islands that are solved side by side?
//
// Up to eight islands of one layout lie in the lanes of one block of doubles (see lanes/island_kernel.h for its order);
// one island alone fills all lanes (see island_bundles.h).
// This is that block, with names for its places. It stays where it is from step to step, as long as layout and number
// of islands do: what the code for lanes found in one step is its first guess in the next.
#pragma once
#include <span>

#include <plumb/dynamics/joints/island_bundles.h>
#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

using LaneFlags = std::array<double, 8>;  ///< of each lane: 1 or 0; doubles, as the code for lanes takes them

struct IslandNumbers {
    std::shared_ptr<const IslandLayout> layout;
    std::vector<JointIsland*> islands;  ///< of each lane
    std::size_t width = 1;              ///< their number
    IslandCode code;
    IslandBundles bundles;
    IslandLanes view;
    LaneFlags active{}, missed{}, lost{}, heavy{}, work{};  ///< see IslandLanes

    /// Makes room for these islands, which have one layout, in vectors of at most so many floats.
    void layOut(std::span<JointIsland* const> some, int mostFloats);

    const IslandKernel& kernel() const { return *code.kernel; }

    double& body(std::size_t node, int field, std::size_t lane) const {
        return at(view.body + bundles.bodyPlaces[node], field, lane);
    }
    double& link(std::size_t i, int field, std::size_t lane) const {
        return at(view.link + bundles.linkPlaces[i], field, lane);
    }
    double& row(std::size_t i, int field, std::size_t lane) const {
        return at(view.row + bundles.rowPlaces[i], field, lane);
    }
    double& joint(std::size_t j, int field, std::size_t lane) const {
        return at(view.joint + bundles.jointPlaces[j], field, lane);
    }
    /// Lanes that have no joint of their own get the numbers of the one before them.
    void fillLanes() const;
    BodyIndex bodyAt(std::size_t node, std::size_t lane) const { return islands[lane]->bodyAt(node); }
    /// Of a body that impulses move.
    BodyIndex movedBody(std::size_t node, std::size_t lane) const { return islands[lane]->bodies[node]; }

    /// Calls visit(node, lane) for each body that impulses move.
    template <class Visit>
    void forEachMoved(Visit&& visit) const {
        for (std::size_t n = 0; n < layout->moved; ++n)
            for (std::size_t lane = 0; lane < width; ++lane) visit(n, lane);
    }
    /// Calls visit(row, lane) for each row that does not hold.
    template <class Visit>
    void forEachFreeRow(Visit&& visit) const {
        for (std::size_t i = 0; i < layout->rows.size() && layout->someFree; ++i)
            for (std::size_t lane = 0; lane < width && !layout->rows[i].holds; ++lane) visit(i, lane);
    }

    void activateAll() { std::fill_n(active.begin(), width, 1.0); }
    void activateOnly(std::size_t lane) {
        std::fill_n(active.begin(), width, 0.0);
        active[lane] = 1;
    }
    /// How far a row's coordinate is from where it is held, or beyond its limits [m]; 0 for angles.
    double errorOf(std::size_t row, std::size_t lane) const;
    /// By how much the worst joint of one island has opened since the step's start [m].
    double openingOf(std::size_t lane) const;

    std::size_t bytes() const { return bytesOf(items_) + bytesOf(islands) + bundles.bytes(); }

private:
    double& at(double* first, int field, std::size_t lane) const {
        return first[static_cast<std::size_t>(field) * code.lanes + lane];
    }

    std::vector<double> items_;
};

}  // namespace plumb
