// SPDX-License-Identifier: MIT
// How is a matrix of blocks factored, and how are its equations solved?
//
// A symmetric matrix of positive masses and of rows has a factorisation L D L^T in any order of its nodes; here in that
// of the layout, where a tree goes from its leaves: A_ij -= A_ik D_k^-1 A_jk^T for the neighbours i, j of a node k. The
// blocks of several islands lie side by side, or those of one island alone.
// Source: Baraff, "Linear-time dynamics using Lagrange multipliers", SIGGRAPH 1996; Vanderbei, "Symmetric quasidefinite
// matrices", SIAM J. Optim. 5 (1995) 100.
#pragma once
#include <plumb/dynamics/joints/lanes/island_items_wide.h>

namespace plumb {

template <int W, LaneUse use>
struct BlockFactors {
    static constexpr bool isAlone = use == LaneUse::Joints;
    using D = std::conditional_t<isAlone, double, typename Wide<W>::Double>;  ///< of all islands
    static constexpr int N = isAlone ? 1 : Wide<W>::doubles;

    /// Numbers that lie so many doubles apart.
    template <int stride>
    struct Apart {
        double* data;
        D operator[](int i) const {
            if constexpr (isAlone)
                return data[i * stride];
            else
                return loadLanes<W>(static_cast<const double*>(data + i * stride));
        }
        void set(int i, D value) const {
            if constexpr (isAlone)
                data[i * stride] = value;
            else
                storeLanes(data + i * stride, value);
        }
    };
    using S = Apart<N>;
    using Item = Apart<Wide<W>::doubles>;  ///< a body's or a row's

    static constexpr D all(double value) { return D{} + value; }

    static S blockOf(const IslandLanes& v, std::uint32_t i) { return {v.block + i * std::size_t{9} * N}; }
    static S inverseOf(const IslandLanes& v, std::uint32_t i) { return {v.inverse + i * std::size_t{9} * N}; }
    static S solutionOf(const IslandLanes& v, std::uint32_t node) {
        return {v.solution + node * std::size_t{3} * N};
    }
    static Item bodyAt(const IslandLanes& v, std::uint32_t node) { return {v.body + v.bodyPlaces[node]}; }
    static Item rowAt(const IslandLanes& v, std::uint32_t row) { return {v.row + v.rowPlaces[row]}; }

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

    static void substitute(const IslandLanes& v) {
        for (std::uint32_t k = 0; k < v.stepCount; ++k) forward(v, k);
        for (std::uint32_t k = v.stepCount; k-- > 0;) backward(v, k);
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
