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

    static void applyKnown(const IslandLanes& v) {
        if (!v.someFree) return;
        for (std::uint32_t i = 0; i < v.rowCount; ++i)
            if (!v.rows[i].holds && anyOf<W>(rowOf(v, i)[R::Known] != D{})) applyKnown(v, i);
    }
    static void applyKnown(const IslandLanes& v, std::uint32_t i) {
        const S row = rowOf(v, i);
        const D known = row[R::Known];
        for (std::uint32_t part = 0; part < v.rows[i].parts; ++part) {
            const std::uint32_t link = v.rows[i].link + part;
            const int axis = part == 0 ? R::AxisX : R::SecondAxisX;
            const D massA = endOf(v, link, false)[B::Mass], massB = endOf(v, link, true)[B::Mass];
            for (int c = 0; c < 2; ++c) {
                const D push = row[axis + c] * known;
                Items::addToEnds(v, link, B::Ux + c, -push / massA, push / massB);
            }
            Items::addToEnds(v, link, B::Uspin, turnBy(endOf(v, link, false), row[axis + 2] * known),
                             turnBy(endOf(v, link, true), row[axis + 3] * known));
        }
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
        for (std::uint32_t i = 0; i < v.rowCount; ++i) {
            const S row = rowOf(v, i);
            const D lacks = speedOf(v, i, B::Ux, B::Uspin) - row[R::Speed];
            row.set(R::Lacks, row[R::Compliance] < D{} ? D{} : lacks);
        }
        substitute(v);
        const auto active = Items::isActive(v);
        for (std::uint32_t i = 0; i < v.rowCount; ++i) {
            const S row = rowOf(v, i);
            row.set(R::Impulse, active ? row[R::Known] + row[R::Gives] : row[R::Impulse]);
        }
    }

    static void makeFactors(IslandLanes& v) {
        if (v.factored) return;
        fill(v);
        Factors::factor(v);
        v.factored = true;
    }

    /// Changes U, so that rows change their speeds by what they lack, and finds what they give for that.
    static void substitute(const IslandLanes& v) {
        for (std::uint32_t n = 0; n < v.moved; ++n)
            for (int c = 0; c < 3; ++c) Factors::solutionOf(v, n).set(c, Number{});
        forEachRow(v, [&](std::uint32_t i, const Block& x, int r) { x.set(r, Factors::rowAt(v, i)[R::Lacks]); });
        Factors::substitute(v);
        for (std::uint32_t n = 0; n < v.moved; ++n) {
            const auto b = Factors::bodyAt(v, n);
            const Block x = Factors::solutionOf(v, n);
            for (int c = 0; c < 3; ++c) b.set(B::Ux + c, b[B::Ux + c] + x[c]);
        }
        forEachRow(v, [&](std::uint32_t i, const Block& x, int r) { Factors::rowAt(v, i).set(R::Gives, x[r]); });
    }

    /// Calls work(row, solution of its joint, number of the row in the joint).
    template <class Work>
    [[gnu::always_inline]] static inline void forEachRow(const IslandLanes& v, Work&& work) {
        for (std::uint32_t j = 0; j < v.laidCount; ++j) {
            const std::uint32_t first = v.laid[j].firstRow;
            for (std::uint32_t i = first; i < v.laid[j + 1].firstRow; ++i)
                work(i, Factors::solutionOf(v, v.moved + j), static_cast<int>(i - first));
        }
    }

    static void fill(const IslandLanes& v) {
        for (std::uint32_t i = v.firstFill; i < v.blocks; ++i)
            for (int c = 0; c < 9; ++c) Factors::blockOf(v, i).set(c, Number{});
        for (std::uint32_t i = 0; i < v.moved; ++i) {
            const Block m = Factors::blockOf(v, i);
            const auto b = Factors::bodyAt(v, i);
            for (int c = 0; c < 9; ++c) m.set(c, Number{});
            const Number mass = b[B::Mass], inertia = b[B::Inertia];
            m.set(0, mass);
            m.set(4, mass);
            m.set(8, inertia > Number{} ? inertia : Factors::all(1));
        }
        for (std::uint32_t j = 0; j < v.laidCount; ++j) fillJoint(v, j);
    }

    static void fillJoint(const IslandLanes& v, std::uint32_t j) {
        const std::uint32_t first = v.laid[j].firstRow;
        const int rows = static_cast<int>(v.laid[j + 1].firstRow - first);
        const Block diagonal = Factors::blockOf(v, v.moved + j);
        for (int r = 0; r < rows; ++r) {
            const Number compliance = Factors::rowAt(v, first + static_cast<std::uint32_t>(r))[R::Compliance];
            for (int c = 0; c < rows; ++c) diagonal.set(3 * r + c, Number{});
            diagonal.set(4 * r, compliance < Number{} ? Factors::all(-1) : -compliance);
        }
        for (std::uint32_t e = v.laid[j].firstEnd; e < v.laid[j + 1].firstEnd; ++e)
            for (int r = 0; r < rows; ++r) fillEnd(v, v.ends[e], first + static_cast<std::uint32_t>(r), r);
    }

    /// Of a unit impulse of the row, as it acts on the end.
    static void fillEnd(const IslandLanes& v, const IslandShape::End& end, std::uint32_t i, int r) {
        const Block block = Factors::blockOf(v, end.block);
        const auto row = Factors::rowAt(v, i);
        const auto solved = row[R::Compliance] >= Number{};
        const auto turns = Factors::bodyAt(v, end.node)[B::Inertia] > Number{};
        const int axis = end.part == 0 ? R::AxisX : R::SecondAxisX;
        const double sign = end.isB ? 1 : -1;
        const Number lever = row[end.isB ? axis + 3 : axis + 2];
        const Number at[3] = {row[axis] * sign, row[axis + 1] * sign, turns ? lever : Number{}};
        for (int c = 0; c < 3; ++c) {
            const int place = end.transposed ? 3 * c + r : 3 * r + c;
            const Number value = solved ? -at[c] : Number{};
            block.set(place, end.isFirst ? value : block[place] + value);
        }
    }
};

}  // namespace plumb
