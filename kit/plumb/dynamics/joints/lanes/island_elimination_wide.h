// SPDX-License-Identifier: MIT
// How are all joints of W islands solved at once?
//
// For velocity changes u and impulses L:  M u - J^T L = 0,  J u + e L = r.  M masses, J the rows, e their compliance, r
// the change of speed that a row lacks (block_factors_wide.h solves it). Redundant rows (rows that say the same) share
// their load by e, and a difference between what they want is amplified by at most 1 / e. In a tree no rows are
// redundant: there e is a share of what the joint gives when it is eliminated, so that it is small beside any other
// mass: a wheel of 0.1 kg under 10 t needs 1e-9.
#pragma once
#include <plumb/dynamics/joints/lanes/block_factors_wide.h>

namespace plumb {

template <int W, LaneUse use>
struct Elimination : IslandItems<W, use> {
    using Items = IslandItems<W, use>;
    using D = typename Items::D;
    using S = typename Items::S;
    using Items::all;
    using Items::bodyOf;
    using Items::endOf;
    using Items::rowOf;
    using Factors = BlockFactors<W, use>;
    using Block = typename Factors::S;
    using Number = typename Factors::D;
    using B = BodyField;
    using R = RowField;

    /// A row's speed at the velocities whose first fields are these.
    static D speedOf(const IslandLanes& v, std::uint32_t i, int linear, int spin) {
        const IslandShape::Row& shape = v.rows[i];
        const S row = rowOf(v, i);
        D speed = partSpeed(v, shape.link, row, R::AxisX, linear, spin);
        if (shape.parts > 1) speed += partSpeed(v, shape.link + 1, row, R::SecondAxisX, linear, spin);
        return speed;
    }
    static D partSpeed(const IslandLanes& v, std::uint32_t link, const S& row, int axis, int linear, int spin) {
        const auto a = endOf(v, link, false), b = endOf(v, link, true);
        return row[axis] * (b[linear] - a[linear]) + row[axis + 1] * (b[linear + 1] - a[linear + 1]) +
               (row[axis + 2] * a[spin] + row[axis + 3] * b[spin]);
    }

    /// U is the free velocity.
    static void start(const IslandLanes& v) {
        for (std::uint32_t i = 0; i < v.bodyItems; ++i) {
            const S b = bodyOf(v, i);
            b.set(B::Ux, b[B::FreeX]);
            b.set(B::Uy, b[B::FreeY]);
            b.set(B::Uspin, b[B::FreeSpin]);
        }
    }

    /// Joint after joint, whatever lanes hold: a sum in another order has other bits.
    static void applyKnown(const IslandLanes& v) {
        for (std::uint32_t j = 0; j < v.jointCount && v.someFree; ++j)
            for (std::uint32_t link = v.joints[j].firstLink; link < v.joints[j + 1].firstLink; ++link)
                applyKnown(v, j, link, link == v.joints[j].firstLink ? R::AxisX : R::SecondAxisX);
    }
    static void applyKnown(const IslandLanes& v, std::uint32_t j, std::uint32_t link, int axis) {
        const auto a = endOf(v, link, false), b = endOf(v, link, true);
        typename Items::Push pushes[3];
        int count = 0;
        for (std::uint32_t i = v.joints[j].firstRow; i < v.joints[j + 1].firstRow; ++i) {
            const S row = rowOf(v, i);
            const D known = row[R::Known];
            if (v.rows[i].holds || !anyOf<W>(known != D{})) continue;
            const D x = row[axis] * known, y = row[axis + 1] * known;
            pushes[count++] = {{-x / a[B::Mass], -y / a[B::Mass], turnBy(a, row[axis + 2] * known)},
                               {x / b[B::Mass], y / b[B::Mass], turnBy(b, row[axis + 3] * known)}};
        }
        Items::pushEnds(v, link, B::Ux, pushes, count);
    }
    template <class Body>
    static D turnBy(const Body& b, D push) {
        const D inertia = b[B::Inertia];
        const auto turns = inertia > D{};
        return turns ? push / (turns ? inertia : all(1)) : D{};
    }

    /// For U, from the velocities that it holds. Rows give their known impulses in addition.
    static void solve(IslandLanes& v) {
        makeFactors(v);
        const std::uint32_t cleared = Factors::isAlone ? v.moved + v.laidCount : v.moved;
        for (std::uint32_t n = 0; n < cleared; ++n) Factors::clear(Factors::solutionOf(v, n), Factors::nodeSize);
        forEachRow(v, [&v](const S& row, std::uint32_t i, std::uint32_t joint, int r) {
            const D lacks = speedOf(v, i, B::Ux, B::Uspin) - row[R::Speed];
            setSolved(v, joint, r, row[R::Compliance] < D{} ? D{} : lacks);
        });
        Factors::substitute(v);
        for (std::uint32_t n = 0; n < v.moved; ++n) {
            const auto b = Factors::bodyAt(v, n);
            const Block x = Factors::solutionOf(v, n);
            for (int c = 0; c < 3; ++c) b.set(B::Ux + c, b[B::Ux + c] + x[c]);
        }
        const auto active = Items::isActive(v);
        forEachRow(v, [&](const S& row, std::uint32_t, std::uint32_t joint, int r) {
            row.set(R::Impulse, active ? row[R::Known] + solved(v, joint, r) : row[R::Impulse]);
        });
    }

    /// Calls work(row, its number, that of its joint, its number in the joint).
    template <class Work>
    [[gnu::always_inline]] static inline void forEachRow(const IslandLanes& v, Work&& work) {
        for (std::uint32_t j = 0; j < v.jointCount; ++j)
            for (std::uint32_t first = v.joints[j].firstRow, i = first; i < v.joints[j + 1].firstRow; ++i)
                work(rowOf(v, i), i, j, static_cast<int>(i - first));
    }
    static Block solvedOf(const IslandLanes& v, std::uint32_t joint, std::size_t lane) {
        return {v.solution + v.solvedPlaces[joint * Items::bodiesAnEnd + lane]};
    }
    /// A joint's part of the solution. Lanes that repeat a joint come first, so that its own lane has the last word.
    static void setSolved(const IslandLanes& v, std::uint32_t joint, int r, D value) {
        if constexpr (Items::holdsJoints)
            for (std::size_t l = Items::bodiesAnEnd; l-- > 0;) solvedOf(v, joint, l).set(r, value[l]);
        else
            Factors::solutionOf(v, v.moved + joint).set(r, value);
    }
    static D solved(const IslandLanes& v, std::uint32_t joint, int r) {
        if constexpr (Items::holdsJoints) {
            D value{};
            for (std::size_t l = 0; l < Items::bodiesAnEnd; ++l) value[l] = solvedOf(v, joint, l)[r];
            return value;
        } else {
            return Factors::solutionOf(v, v.moved + joint)[r];
        }
    }

    /// Row after row, whatever lanes hold, as the sum must have the same bits.
    static void findWork(const IslandLanes& v) {
        Number work{};
        for (std::uint32_t i = 0; i < v.laid[v.laidCount].firstRow; ++i) {
            if (!v.laidRows[i].holds) continue;
            const auto row = Factors::rowAt(v, i);
            const Number impulse = row[R::Impulse], after = row[R::Speed] - row[R::Compliance] * impulse;
            work += 0.5 * impulse * (row[R::NotedSpeed] + after);
        }
        Block{v.work}.set(0, work);
    }

    static void makeFactors(IslandLanes& v) {
        if (v.factored) return;
        fill(v);
        Factors::factor(v);
        v.factored = true;
    }

    static void fill(const IslandLanes& v) {
        const auto clear = [&v](std::uint32_t first, std::uint32_t end) {
            for (std::uint32_t i = first; i < end; ++i) Factors::clear(Factors::blockOf(v, i), Factors::columnsSize);
        };
        clear(0, v.moved + v.laidCount);
        clear(v.firstFill, v.blocks);
        for (std::uint32_t n = 0; n < v.moved; ++n) {
            const Block m = Factors::blockOf(v, n);
            const Number mass = Factors::bodyAt(v, n)[B::Mass], inertia = Factors::bodyAt(v, n)[B::Inertia];
            m.set(0, mass);
            m.set(Factors::in(1, 1), mass);
            m.set(Factors::in(2, 2), inertia > Number{} ? inertia : Factors::all(1));
        }
        forEachRow(v, [&v](const S& row, std::uint32_t i, std::uint32_t joint, int r) {
            const D compliance = row[R::Compliance];
            const auto isSolved = compliance >= D{};
            setDiagonal(v, joint, r, isSolved ? -compliance : all(-1));
            for (std::uint32_t part = 0; part < v.rows[i].parts; ++part) {
                const std::uint32_t link = v.rows[i].link + part;
                const int axis = part == 0 ? R::AxisX : R::SecondAxisX;
                const D x = isSolved ? row[axis] : D{}, y = isSolved ? row[axis + 1] : D{};
                const D turnA = isSolved ? row[axis + 2] : D{}, turnB = isSolved ? row[axis + 3] : D{};
                setEnd(v, link, false, r, {x, y, -turned(endOf(v, link, false), turnA)});
                setEnd(v, link, true, r, {-x, -y, -turned(endOf(v, link, true), turnB)});
            }
        });
    }
    template <class Body>
    static D turned(const Body& b, D lever) {
        return b[B::Inertia] > D{} ? lever : D{};
    }

    static void setDiagonal(const IslandLanes& v, std::uint32_t joint, int r, D value) {
        constexpr std::size_t blocksANode = BlockNumbers::alone / NodeNumbers::alone;
        if constexpr (Items::holdsJoints)
            for (std::size_t l = Items::bodiesAnEnd; l-- > 0;)
                Block{v.block + v.solvedPlaces[joint * Items::bodiesAnEnd + l] * blocksANode}.set(Factors::in(r, r),
                                                                                                  value[l]);
        else
            Factors::blockOf(v, v.moved + joint).set(Factors::in(r, r), value);
    }
    /// What a row does to the body at an end, as a column or a row of their block.
    struct AtEnd {
        D along[3];
    };
    static void setEnd(const IslandLanes& v, std::uint32_t link, bool isB, int r, const AtEnd& at) {
        const IslandShape::BlockPlace* places = v.blockPlaces + (2 * link + (isB ? 1 : 0)) * Items::bodiesAnEnd;
        for (std::size_t l = 0; l < Items::bodiesAnEnd; ++l) {
            const IslandShape::BlockPlace& place = places[l];
            for (int c = 0; c < 3; ++c) {
                const Block to{v.block + (place.first + static_cast<std::uint32_t>(r) * place.row +
                                          static_cast<std::uint32_t>(c) * place.column) *
                                             std::size_t{Factors::N}};
                const Number value = laneOf(at.along[c], l);
                to.set(0, place.isFirst ? value : to[0] + value);
            }
        }
    }
    static Number laneOf(const D& value, [[maybe_unused]] std::size_t lane) {
        if constexpr (Items::holdsJoints)
            return value[lane];
        else
            return value;
    }
};

}  // namespace plumb
