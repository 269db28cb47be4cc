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

template <int W>
struct WideStiffness {
    using D = typename Wide<W>::Double;
    using S = Slots<W>;
    using B = BodyField;
    using L = LinkField;
    using R = RowField;
    using Body = Elimination<W>;

    static constexpr double memory = 2;  ///< in which the stiffness of a line that is no longer tight decays [s]

    static constexpr D all(double value) { return D{} + value; }
    static void add(const S& slots, int field, D value) { slots.set(field, slots[field] + value); }

    static void setMasses(IslandLanes& v, double h) {
        for (std::uint32_t i = 0; i < v.moved; ++i) {
            const S b = Body::bodyOf(v, i);
            const D mass = larger(b[B::OwnMass], h * h * b[B::StiffAlong]);
            v.factored = v.factored && !anyOf<W>(mass != b[B::Mass]);
            b.set(B::Mass, mass);
        }
    }

    static void findInertias(const IslandLanes& v, double h) {
        bool tight = false;
        for (std::uint32_t i = 0; i < v.moved; ++i) {
            const S b = Body::bodyOf(v, i);
            tight = tight || anyOf<W>(needed(b, h) > b[B::OwnInertia]);
        }
        if (tight) findNeighbours(v);
        for (std::uint32_t i = 0; i < v.moved; ++i) {
            const S b = Body::bodyOf(v, i);
            const D own = b[B::OwnInertia], alone = tight ? needed(b, h) - neighbourInertia(b) : D{};
            b.set(B::Inertia, own > D{} ? larger(own, alone) : D{});
        }
    }

    /// Of a body alone.
    static D needed(const S& b, double h) { return 2 * h * h * b[B::StiffTurning]; }

    static void noteForces(const IslandLanes& v, double h, bool inPieces) {
        const double rate = 2 / h;  // impulses are of half a sub-step
        for (std::uint32_t i = 0; i < v.moved; ++i) {
            Body::bodyOf(v, i).set(B::FreshAlong, D{});
            Body::bodyOf(v, i).set(B::FreshTurning, D{});
        }
        for (std::uint32_t j = 0; j < v.jointCount; ++j)
            if (!v.joints[j].turnsOnly) addForces(v, j, rate);
        const auto active = Body::isActive(v);
        const double half = 0.5 * h, kept = 1 - (half < memory ? half / memory : 1);
        for (std::uint32_t i = 0; i < v.moved; ++i) {
            const S b = Body::bodyOf(v, i);
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
            const S l = Body::linkOf(v, i);
            D x{}, y{}, aside{};
            const int axis = part == 0 ? R::AxisX : R::SecondAxisX;
            for (std::uint32_t r = v.joints[j].firstRow; r < v.joints[j + 1].firstRow; ++r) {
                const S row = Body::rowOf(v, r);
                const D force = row[R::Impulse] * rate;
                x += row[axis] * force;
                y += row[axis + 1] * force;
                if (v.rows[r].axis[0] != RowAxis::Along || v.rows[r].parts > 1) continue;
                const D length = row[R::Coordinate] + row[R::Origin];
                const auto isRod = length > D{};
                aside = isRod ? 2 * magnitude(force) / (isRod ? length : all(1)) : D{};
            }
            addForce(v, v.links[i].a, -(x * l[L::ArmAx] + y * l[L::ArmAy]), aside);
            addForce(v, v.links[i].b, x * l[L::ArmBx] + y * l[L::ArmBy], aside);
        }
    }
    static void addForce(const IslandLanes& v, std::uint32_t body, D turning, D along) {
        if (body >= v.moved) return;
        add(Body::bodyOf(v, body), B::FreshTurning, turning);
        add(Body::bodyOf(v, body), B::FreshAlong, along);
    }

    /// The least effective mass, over all directions, of a neighbour at its anchor. A fixed one counts as a million
    /// times the body's own mass.
    static D leastMass(const IslandLanes& v, std::uint32_t neighbour, D armX, D armY, D own) {
        if (neighbour >= v.moved) return 1e6 * own;
        const S n = Body::bodyOf(v, neighbour);
        const auto turns = n[B::Inertia] > D{};
        const D turning = turns ? (armX * armX + armY * armY) / (turns ? n[B::Inertia] : all(1)) : D{};
        return 1.0 / (1.0 / n[B::Mass] + turning);
    }

    static void findNeighbours(const IslandLanes& v) {
        for (std::uint32_t i = 0; i < v.moved; ++i)
            for (int f = B::NearMass; f <= B::NearSquares; ++f) Body::bodyOf(v, i).set(f, D{});
        for (std::uint32_t j = 0; j < v.jointCount; ++j) {
            if (!v.joints[j].holdsPoint) continue;
            const std::uint32_t i = v.joints[j].firstLink, a = v.links[i].a, b = v.links[i].b;
            const S l = Body::linkOf(v, i);
            addNeighbour(v, a, b, l[L::ArmAx], l[L::ArmAy], l[L::ArmBx], l[L::ArmBy]);
            addNeighbour(v, b, a, l[L::ArmBx], l[L::ArmBy], l[L::ArmAx], l[L::ArmAy]);
        }
    }
    static void addNeighbour(const IslandLanes& v, std::uint32_t body, std::uint32_t other, D x, D y, D otherX,
                             D otherY) {
        if (body >= v.moved) return;
        const S b = Body::bodyOf(v, body);
        const D mass = leastMass(v, other, otherX, otherY, b[B::Mass]);
        add(b, B::NearMass, mass);
        add(b, B::NearX, mass * x);
        add(b, B::NearY, mass * y);
        add(b, B::NearSquares, mass * (x * x + y * y));
    }

    /// The inertia that neighbours add when the body turns, each taken as connected to this body only:
    /// sum m r^2 - |sum m r|^2 / (m_body + sum m).
    static D neighbourInertia(const S& b) {
        const D x = b[B::NearX], y = b[B::NearY];
        return b[B::NearSquares] - (x * x + y * y) / (b[B::Mass] + b[B::NearMass]);
    }
};

}  // namespace plumb
