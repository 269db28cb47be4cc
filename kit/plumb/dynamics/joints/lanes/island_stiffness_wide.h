// SPDX-License-Identifier: MIT
// How fast would a tight chain or rod swing sideways, and how is that kept slow enough for the sub-step?
//
// Under a tension F, a link is turned back with the stiffness k = F.r [N m/rad] for each anchor r, and a rod of length
// l pulls its ends back with the stiffness F/l [N/m]. Where this oscillation would be too fast for the sub-step h, the
// body gets more inertia in the solution of its island, until I + I' >= 2 h^2 k and m >= h^2 k. I' is the inertia that
// its neighbours add, because they must move when the body turns. The stiffness falls slowly: one that follows every
// change of the forces makes oscillations grow (tried). Source: Andrews, Teichmann, Kry, "Geometric stiffness for
// real-time constrained multibody dynamics", Comput. Graph. Forum 36 (2017) 235, where it is a separate term. Test: "a
// bridge of 30 planks between two banks bears a heavy box at its middle"
#pragma once
#include <plumb/dynamics/joints/lanes/island_elimination_wide.h>

namespace plumb {

template <int W, LaneUse use>
struct WideStiffness : IslandItems<W, use> {
    using Items = IslandItems<W, use>;
    using D = typename Items::D;
    using S = typename Items::S;
    using BodyAtEnd = typename Items::BodyAtEnd;
    using B = BodyField;
    using L = LinkField;
    using R = RowField;
    using Items::addToEnds;
    using Items::all;
    using Items::bodyOf;
    using Items::endOf;
    using Items::linkOf;
    using Items::rowOf;

    static constexpr double memory = 2;  ///< in which the stiffness of a line that is no longer tight decays [s]

    /// Of active lanes. More mass at the same speed would be more energy: a body keeps its momentum. Not in an island
    /// that nothing holds: there all bodies together must keep the momentum that their own masses have.
    static void setMasses(IslandLanes& v, double h) {
        const auto active = Items::isActive(v);
        for (std::uint32_t i = 0; i < v.movedItems; ++i) {
            const S b = bodyOf(v, i);
            const D was = b[B::Mass], needs = larger(b[B::OwnMass], h * h * b[B::StiffAlong]);
            const D mass = active ? needs : was;
            if (!anyOf<W>(mass != was)) continue;
            v.factored = false;
            b.set(B::Mass, mass);
            if (!v.isHeld) continue;
            const D kept = mass > was ? was / mass : all(1);
            b.set(B::Vx, b[B::Vx] * kept);
            b.set(B::Vy, b[B::Vy] * kept);
        }
    }

    static void findInertias(const IslandLanes& v, double h) {
        bool tight = false;
        for (std::uint32_t i = 0; i < v.movedItems; ++i) {
            const S b = bodyOf(v, i);
            tight = tight || anyOf<W>(needed(b, h) > b[B::OwnInertia]);
        }
        if (tight) findNeighbours(v);
        for (std::uint32_t i = 0; i < v.movedItems; ++i) {
            const S b = bodyOf(v, i);
            const D own = b[B::OwnInertia], alone = tight ? needed(b, h) - neighbourInertia(b) : D{};
            b.set(B::Inertia, own > D{} ? larger(own, alone) : D{});
        }
    }

    /// Of a body alone.
    static D needed(const S& b, double h) { return 2 * h * h * b[B::StiffTurning]; }

    static void noteForces(const IslandLanes& v, double h, bool inPieces) {
        const double rate = 2 / h;  // impulses are of half a sub-step
        for (std::uint32_t i = 0; i < v.movedItems; ++i) {
            bodyOf(v, i).set(B::FreshAlong, D{});
            bodyOf(v, i).set(B::FreshTurning, D{});
        }
        for (std::uint32_t j = 0; j < v.jointCount; ++j)
            if (!v.joints[j].turnsOnly) addForces(v, j, rate);
        const auto active = Items::isActive(v);
        const double half = 0.5 * h, kept = 1 - (half < memory ? half / memory : 1);
        for (std::uint32_t i = 0; i < v.movedItems; ++i) {
            const S b = bodyOf(v, i);
            const auto note = [&](int field, int fresh) {
                b.set(field, active ? larger(b[fresh], kept * b[field]) : b[field]);
            };
            note(B::Swinging, B::FreshTurning);
            if (inPieces) continue;
            note(B::StiffAlong, B::FreshAlong);
            note(B::StiffTurning, B::FreshTurning);
        }
    }

    static void addForces(const IslandLanes& v, std::uint32_t j, double rate) {
        for (std::uint32_t part = 0, i = v.joints[j].firstLink; i < v.joints[j + 1].firstLink; ++i, ++part) {
            const S l = linkOf(v, i);
            D x{}, y{}, aside{};
            bool isAlong = false;
            const int axis = part == 0 ? R::AxisX : R::SecondAxisX;
            for (std::uint32_t r = v.joints[j].firstRow; r < v.joints[j + 1].firstRow; ++r) {
                const S row = rowOf(v, r);
                const D force = row[R::Impulse] * rate;
                x += row[axis] * force;
                y += row[axis + 1] * force;
                if (v.rows[r].axis[0] != RowAxis::Along || v.rows[r].parts > 1) continue;
                isAlong = true;
                const D length = row[R::Coordinate] + row[R::Origin];
                const auto isRod = length > D{};
                aside = isRod ? 2 * magnitude(force) / (isRod ? length : all(1)) : D{};
            }
            addToEnds(v, i, B::FreshTurning, -(x * l[L::ArmAx] + y * l[L::ArmAy]), x * l[L::ArmBx] + y * l[L::ArmBy]);
            if (isAlong) addToEnds(v, i, B::FreshAlong, aside, aside);
        }
    }

    /// The least effective mass, over all directions, of a neighbour at its anchor. A fixed one counts as a million
    /// times the body's own mass.
    static D leastMass(const BodyAtEnd& neighbour, D moves, D armX, D armY, D own) {
        const D inertia = neighbour[B::Inertia];
        const auto turns = inertia > D{};
        const D turning = turns ? (armX * armX + armY * armY) / (turns ? inertia : all(1)) : D{};
        return moves > D{} ? 1.0 / (1.0 / neighbour[B::Mass] + turning) : 1e6 * own;
    }

    static void findNeighbours(const IslandLanes& v) {
        for (std::uint32_t i = 0; i < v.movedItems; ++i)
            for (int f = B::NearMass; f <= B::NearSquares; ++f) bodyOf(v, i).set(f, D{});
        for (std::uint32_t j = 0; j < v.jointCount; ++j) {
            if (!v.joints[j].holdsPoint) continue;
            const std::uint32_t i = v.joints[j].firstLink;
            const S l = linkOf(v, i);
            const D ax = l[L::ArmAx], ay = l[L::ArmAy], bx = l[L::ArmBx], by = l[L::ArmBy];
            const BodyAtEnd a = endOf(v, i, false), b = endOf(v, i, true);
            const D forA = leastMass(b, Items::movesAt(v, i, true), bx, by, a[B::Mass]);
            const D forB = leastMass(a, Items::movesAt(v, i, false), ax, ay, b[B::Mass]);
            addToEnds(v, i, B::NearMass, forA, forB);
            addToEnds(v, i, B::NearX, forA * ax, forB * bx);
            addToEnds(v, i, B::NearY, forA * ay, forB * by);
            addToEnds(v, i, B::NearSquares, forA * (ax * ax + ay * ay), forB * (bx * bx + by * by));
        }
    }

    /// The inertia that neighbours add when the body turns, each taken as connected to this body only:
    /// sum m r^2 - |sum m r|^2 / (m_body + sum m).
    static D neighbourInertia(const S& b) {
        const D x = b[B::NearX], y = b[B::NearY];
        return b[B::NearSquares] - (x * x + y * y) / (b[B::Mass] + b[B::NearMass]);
    }
};

}  // namespace plumb
