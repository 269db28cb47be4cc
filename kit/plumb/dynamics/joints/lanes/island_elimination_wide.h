// SPDX-License-Identifier: MIT
// How are all joints of W islands solved at once?
//
// For velocity changes u and impulses L:  M u - J^T L = 0,  J u + e L = r.  M masses, J the rows, e their compliance, r
// the change of speed that a row lacks. Such a matrix of positive M and e has a factorisation L D L^T in any order of
// its nodes; here in that of the layout, where a tree goes from its leaves: A_ij -= A_ik D_k^-1 A_jk^T for the
// neighbours i, j of a node k. Redundant rows (rows that say the same) share their load by e, and a difference between
// what they want is amplified by at most 1 / e. In a tree no rows are redundant: there e is a share of what the joint
// gives when it is eliminated, so that it is small beside any other mass: a wheel of 0.1 kg under 10 t needs 1e-9.
// Source: Baraff, "Linear-time dynamics using Lagrange multipliers", SIGGRAPH 1996; Vanderbei, "Symmetric quasidefinite
// matrices", SIAM J. Optim. 5 (1995) 100.
#pragma once
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
};

/// Where the items are.
template <int W>
struct IslandItems {
    using S = Slots<W>;
    static S bodyOf(const IslandLanes& v, std::uint32_t i) {
        return {v.body + i * std::size_t{BodyField::count} * S::N};
    }
    static S linkOf(const IslandLanes& v, std::uint32_t i) {
        return {v.link + i * std::size_t{LinkField::count} * S::N};
    }
    static S rowOf(const IslandLanes& v, std::uint32_t i) { return {v.row + i * std::size_t{RowField::count} * S::N}; }
};

template <int W>
struct Elimination : IslandItems<W> {
    using D = typename Wide<W>::Double;
    using S = Slots<W>;
    using IslandItems<W>::bodyOf;
    using IslandItems<W>::rowOf;
    using B = BodyField;
    using R = RowField;

    static constexpr D all(double value) { return D{} + value; }

    static S blockOf(const IslandLanes& v, std::uint32_t i) { return {v.block + i * std::size_t{9} * S::N}; }
    static S solutionOf(const IslandLanes& v, std::uint32_t node) {
        return {v.solution + node * std::size_t{3} * S::N};
    }

    /// A row's speed at the velocities whose first fields are these.
    static D speedOf(const IslandLanes& v, std::uint32_t i, int linear, int spin) {
        const IslandShape::Row& shape = v.rows[i];
        const S row = rowOf(v, i);
        D speed = partSpeed(v, shape.link, row, R::AxisX, linear, spin);
        if (shape.parts > 1) speed += partSpeed(v, shape.link + 1, row, R::SecondAxisX, linear, spin);
        return speed;
    }
    static D partSpeed(const IslandLanes& v, std::uint32_t link, const S& row, int axis, int linear, int spin) {
        const S a = bodyOf(v, v.links[link].a), b = bodyOf(v, v.links[link].b);
        return row[axis] * (b[linear] - a[linear]) + row[axis + 1] * (b[linear + 1] - a[linear + 1]) +
               (row[axis + 2] * a[spin] + row[axis + 3] * b[spin]);
    }

    static auto isActive(const IslandLanes& v) { return loadLanes<W>(static_cast<const double*>(v.active)) > D{}; }

    /// U is the free velocity.
    static void start(const IslandLanes& v) {
        for (std::uint32_t i = 0; i < v.bodies; ++i) {
            const S b = bodyOf(v, i);
            b.set(B::Ux, b[B::FreeX]);
            b.set(B::Uy, b[B::FreeY]);
            b.set(B::Uspin, b[B::FreeSpin]);
        }
    }

    static void applyKnown(const IslandLanes& v) {
        if (!v.someFree) return;
        for (std::uint32_t j = 0; j < v.jointCount; ++j)
            for (std::uint32_t i = v.joints[j].firstRow; i < v.joints[j + 1].firstRow; ++i)
                if (!v.rows[i].holds && anyOf<W>(rowOf(v, i)[R::Known] != D{})) applyKnown(v, j, i);
    }
    static void applyKnown(const IslandLanes& v, std::uint32_t j, std::uint32_t i) {
        const D known = rowOf(v, i)[R::Known];
        for (std::uint32_t e = v.joints[j].firstEnd; e < v.joints[j + 1].firstEnd; ++e) {
            const S b = bodyOf(v, v.ends[e].node);
            D at[3];
            rowAt(v, i, v.ends[e], at);
            b.set(B::Ux, b[B::Ux] + at[0] * known / b[B::Mass]);
            b.set(B::Uy, b[B::Uy] + at[1] * known / b[B::Mass]);
            const auto turns = b[B::Inertia] > D{};
            const D inertia = turns ? b[B::Inertia] : all(1);
            b.set(B::Uspin, b[B::Uspin] + (turns ? at[2] * known / inertia : D{}));
        }
    }

    /// A unit impulse of a row, as it acts on an end.
    static void rowAt(const IslandLanes& v, std::uint32_t i, const IslandShape::End& end, D (&at)[3]) {
        const S row = rowOf(v, i);
        const int axis = end.part == 0 ? R::AxisX : R::SecondAxisX;
        const double sign = end.isB ? 1 : -1;
        at[0] = row[axis] * sign;
        at[1] = row[axis + 1] * sign;
        at[2] = row[end.isB ? axis + 3 : axis + 2];
    }

    /// For U, from the velocities that it holds. Rows give their known impulses in addition.
    static void solve(IslandLanes& v) {
        makeFactors(v);
        substitute(v, [](const S& row, D speed) { return row[R::Compliance] < D{} ? D{} : speed - row[R::Speed]; });
        const auto active = isActive(v);
        forEachRow(v, [&](const S& row, const S& x, int r) {
            row.set(R::Impulse, active ? row[R::Known] + x[r] : row[R::Impulse]);
        });
    }

    static void makeFactors(IslandLanes& v) {
        if (v.factored) return;
        fill(v);
        factor(v);
        v.factored = true;
    }

    /// Calls work(row, solution of its joint, number of the row in the joint).
    template <class Work>
    [[gnu::always_inline]] static inline void forEachRow(const IslandLanes& v, Work&& work) {
        for (std::uint32_t j = 0; j < v.jointCount; ++j) {
            const std::uint32_t first = v.joints[j].firstRow;
            for (std::uint32_t i = first; i < v.joints[j + 1].firstRow; ++i)
                work(rowOf(v, i), solutionOf(v, v.moved + j), static_cast<int>(i - first));
        }
    }

    /// Solves for a change of U, by which rows change their speeds by -lacks(row, speed), and adds it to U.
    template <class Lacks>
    [[gnu::always_inline]] static inline void substitute(const IslandLanes& v, Lacks&& lacks) {
        for (std::uint32_t i = 0; i < v.moved; ++i)
            for (int c = 0; c < 3; ++c) solutionOf(v, i).set(c, D{});
        for (std::uint32_t j = 0; j < v.jointCount; ++j) {
            const std::uint32_t first = v.joints[j].firstRow;
            for (std::uint32_t i = first; i < v.joints[j + 1].firstRow; ++i)
                solutionOf(v, v.moved + j)
                    .set(static_cast<int>(i - first), lacks(rowOf(v, i), speedOf(v, i, B::Ux, B::Uspin)));
        }
        substitute(v);
    }
    static void substitute(const IslandLanes& v) {
        for (std::uint32_t k = 0; k < v.stepCount; ++k) forward(v, k);
        for (std::uint32_t k = v.stepCount; k-- > 0;) backward(v, k);
        for (std::uint32_t i = 0; i < v.moved; ++i) {
            const S b = bodyOf(v, i), x = solutionOf(v, i);
            b.set(B::Ux, b[B::Ux] + x[0]);
            b.set(B::Uy, b[B::Uy] + x[1]);
            b.set(B::Uspin, b[B::Uspin] + x[2]);
        }
    }

    static void fill(const IslandLanes& v) {
        for (std::uint32_t i = v.firstFill; i < v.blocks; ++i)
            for (int c = 0; c < 9; ++c) blockOf(v, i).set(c, D{});
        for (std::uint32_t i = 0; i < v.moved; ++i) {
            const S m = blockOf(v, i), b = bodyOf(v, i);
            for (int c = 0; c < 9; ++c) m.set(c, D{});
            m.set(0, b[B::Mass]);
            m.set(4, b[B::Mass]);
            m.set(8, b[B::Inertia] > D{} ? b[B::Inertia] : all(1));
        }
        for (std::uint32_t j = 0; j < v.jointCount; ++j) fillJoint(v, j);
    }

    static void fillJoint(const IslandLanes& v, std::uint32_t j) {
        const std::uint32_t first = v.joints[j].firstRow;
        const int rows = static_cast<int>(v.joints[j + 1].firstRow - first);
        const S diagonal = blockOf(v, v.moved + j);
        for (int r = 0; r < rows; ++r) {
            const D compliance = rowOf(v, first + static_cast<std::uint32_t>(r))[R::Compliance];
            for (int c = 0; c < rows; ++c) diagonal.set(3 * r + c, D{});
            diagonal.set(4 * r, compliance < D{} ? all(-1) : -compliance);
        }
        for (std::uint32_t e = v.joints[j].firstEnd; e < v.joints[j + 1].firstEnd; ++e)
            for (int r = 0; r < rows; ++r) fillEnd(v, v.ends[e], first + static_cast<std::uint32_t>(r), r);
    }

    static void fillEnd(const IslandLanes& v, const IslandShape::End& end, std::uint32_t i, int r) {
        const S block = blockOf(v, end.block);
        const auto solved = rowOf(v, i)[R::Compliance] >= D{};
        D at[3];
        rowAt(v, i, end, at);
        at[2] = bodyOf(v, end.node)[B::Inertia] > D{} ? at[2] : D{};
        for (int c = 0; c < 3; ++c) {
            const int place = end.transposed ? 3 * c + r : 3 * r + c;
            const D value = solved ? -at[c] : D{};
            block.set(place, end.isFirst ? value : block[place] + value);
        }
    }

    /// Calls work with a size as a constant, so that loops over it are unrolled.
    template <class Work>
    [[gnu::always_inline]] static inline void sized(std::uint32_t size, Work&& work) {
        switch (size) {
            case 0: return;
            case 1: return work(Size<1>{});
            case 2: return work(Size<2>{});
            default: return work(Size<3>{});
        }
    }
    template <int N>
    struct Size {
        static constexpr int value = N;
    };

    static void factor(const IslandLanes& v) {
        for (std::uint32_t k = 0; k < v.stepCount; ++k) {
            if (v.slack > 0 && v.steps[k].node >= v.moved) loosen(v, blockOf(v, v.steps[k].node));
            sized(v.steps[k].size, [&](auto size) { eliminate<decltype(size)::value>(v, k); });
        }
    }

    /// Makes a joint of a tree softer by a share of what it gives.
    static void loosen(const IslandLanes& v, const S& block) {
        for (int i = 0; i < 9; ++i) block.set(i, block[i] * (1 + v.slack));
    }

    /// Of a symmetric matrix; zero where it has none. By L D L^T: of a body that a joint has made stiff along one
    /// direction, the determinant would lose the other directions.
    template <int E>
    static void invert(const S& m) {
        if constexpr (E == 1) {
            m.set(0, reciprocal(m[0]));
        } else if constexpr (E == 2) {
            const D i0 = reciprocal(m[0]), l = m[1] * i0;
            const D i1 = reciprocal(m[4] - l * m[1]);
            m.set(0, i0 + l * l * i1);
            m.set(1, -l * i1);
            m.set(3, -l * i1);
            m.set(4, i1);
        } else {
            const D i0 = reciprocal(m[0]), l1 = m[1] * i0, l2 = m[2] * i0;
            const D i1 = reciprocal(m[4] - l1 * m[1]), e = m[5] - l1 * m[2], l3 = e * i1;
            const D i2 = reciprocal(m[8] - l2 * m[2] - l3 * e), p = l1 * l3 - l2;
            const D xy = -l1 * i1 - p * l3 * i2, xz = p * i2, yz = -l3 * i2;
            const D inverse[9] = {i0 + l1 * l1 * i1 + p * p * i2, xy, xz, xy, i1 + l3 * l3 * i2, yz, xz, yz, i2};
            for (int i = 0; i < 9; ++i) m.set(i, inverse[i]);
        }
    }
    static D reciprocal(D v) {
        const auto some = v != D{};
        return some ? 1.0 / (some ? v : all(1)) : D{};
    }

    template <int E>
    static void eliminate(const IslandLanes& v, std::uint32_t k) {
        const S inverse = blockOf(v, v.steps[k].node);
        invert<E>(inverse);
        std::uint32_t last = ~std::uint32_t{0};
        D scaled[3][3];
        for (std::uint32_t u = v.steps[k].firstUpdate; u < v.steps[k + 1].firstUpdate; ++u) {
            const IslandShape::Update& update = v.updates[u];
            const S right = blockOf(v, update.right), target = blockOf(v, update.target);
            sized(update.leftSize, [&](auto rows) {
                constexpr int m = decltype(rows)::value;
                if (update.left != last) scale<E, m>(blockOf(v, update.left), inverse, scaled);
                sized(update.rightSize,
                      [&](auto columns) { subtract<E, m, decltype(columns)::value>(target, scaled, right); });
            });
            last = update.left;
        }
    }
    /// scaled = left times inverse.
    template <int E, int M>
    static void scale(const S& left, const S& inverse, D (&scaled)[3][3]) {
        for (int i = 0; i < M; ++i) {
            for (int j = 0; j < E; ++j) {
                D sum = left[3 * i] * inverse[j];
                for (int c = 1; c < E; ++c) sum += left[3 * i + c] * inverse[3 * c + j];
                scaled[i][j] = sum;
            }
        }
    }
    /// target -= scaled times right^T.
    template <int E, int M, int N>
    static void subtract(const S& target, const D (&scaled)[3][3], const S& right) {
        for (int j = 0; j < N; ++j) {
            for (int i = 0; i < M; ++i) {
                D sum = scaled[i][0] * right[3 * j];
                for (int c = 1; c < E; ++c) sum += scaled[i][c] * right[3 * j + c];
                target.set(3 * i + j, target[3 * i + j] - sum);
            }
        }
    }

    static void forward(const IslandLanes& v, std::uint32_t k) {
        sized(v.steps[k].size, [&](auto size) { forwardSized<decltype(size)::value>(v, k); });
    }
    template <int E>
    static void forwardSized(const IslandLanes& v, std::uint32_t k) {
        const IslandShape::Step& step = v.steps[k];
        const S inverse = blockOf(v, step.node), x = solutionOf(v, step.node);
        D scaled[3];
        for (int i = 0; i < E; ++i) {
            scaled[i] = inverse[3 * i] * x[0];
            for (int c = 1; c < E; ++c) scaled[i] += inverse[3 * i + c] * x[c];
        }
        for (std::uint32_t l = step.firstLower; l < v.steps[k + 1].firstLower; ++l) {
            const S block = blockOf(v, v.lowers[l].block), y = solutionOf(v, v.lowers[l].node);
            sized(v.lowers[l].size, [&](auto rows) {
                for (int i = 0; i < decltype(rows)::value; ++i) {
                    D sum = block[3 * i] * scaled[0];
                    for (int c = 1; c < E; ++c) sum += block[3 * i + c] * scaled[c];
                    y.set(i, y[i] - sum);
                }
            });
        }
    }

    static void backward(const IslandLanes& v, std::uint32_t k) {
        sized(v.steps[k].size, [&](auto size) { backwardSized<decltype(size)::value>(v, k); });
    }
    /// D^-1 (b - sum D L^T x): the sum holds A_ik^T x_i as it stands.
    template <int E>
    static void backwardSized(const IslandLanes& v, std::uint32_t k) {
        const IslandShape::Step& step = v.steps[k];
        const S inverse = blockOf(v, step.node), x = solutionOf(v, step.node);
        D right[3];
        for (int c = 0; c < E; ++c) right[c] = x[c];
        for (std::uint32_t l = step.firstLower; l < v.steps[k + 1].firstLower; ++l) {
            const S block = blockOf(v, v.lowers[l].block), y = solutionOf(v, v.lowers[l].node);
            sized(v.lowers[l].size, [&](auto rows) {
                for (int i = 0; i < decltype(rows)::value; ++i)
                    for (int c = 0; c < E; ++c) right[c] -= block[3 * i + c] * y[i];
            });
        }
        for (int i = 0; i < E; ++i) {
            D sum = inverse[3 * i] * right[0];
            for (int c = 1; c < E; ++c) sum += inverse[3 * i + c] * right[c];
            x.set(i, sum);
        }
    }
};

}  // namespace plumb
