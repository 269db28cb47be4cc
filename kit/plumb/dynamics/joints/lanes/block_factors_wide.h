// SPDX-License-Identifier: MIT
// How is a matrix of blocks factored, and how are its equations solved?
//
// A symmetric matrix of positive masses and of rows has a factorisation L D L^T in any order of its nodes; here in that
// of the layout, where a tree goes from its leaves: A_ij -= A_ik D_k^-1 A_jk^T for the neighbours i, j of a node k.
// Afterwards the diagonal holds D_k^-1, and each block below it L_ik = A_ik D_k^-1.
// All is done by columns of blocks. Of islands side by side, each number of a column is a vector; of one island alone,
// each column is one, and its blocks have their rows, too.
// Source: Baraff, "Linear-time dynamics using Lagrange multipliers", SIGGRAPH 1996; Vanderbei, "Symmetric quasidefinite
// matrices", SIAM J. Optim. 5 (1995) 100.
#pragma once
#include <plumb/dynamics/joints/lanes/island_items_wide.h>

namespace plumb {

/// A column of a block, in some parts.
template <class Part, class Factor, std::size_t parts>
struct ColumnParts {
    Part at[parts];

    ColumnParts operator*(const Factor& factor) const {
        ColumnParts result;
        for (std::size_t i = 0; i < parts; ++i) result.at[i] = at[i] * factor;
        return result;
    }
    ColumnParts operator+(const ColumnParts& other) const {
        ColumnParts result;
        for (std::size_t i = 0; i < parts; ++i) result.at[i] = at[i] + other.at[i];
        return result;
    }
    ColumnParts operator-(const ColumnParts& other) const {
        ColumnParts result;
        for (std::size_t i = 0; i < parts; ++i) result.at[i] = at[i] - other.at[i];
        return result;
    }
};

template <int W, LaneUse use>
struct BlockFactors {
    static constexpr bool isAlone = use == LaneUse::Joints;
    using D = std::conditional_t<isAlone, double, typename Wide<W>::Double>;  ///< of all islands
    static constexpr int N = isAlone ? 1 : Wide<W>::doubles;
    static constexpr std::size_t blockSize = use == LaneUse::Joints ? BlockNumbers::alone : BlockNumbers::beside;
    static constexpr std::size_t nodeSize = use == LaneUse::Joints ? NodeNumbers::alone : NodeNumbers::beside;

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

    static constexpr int rowsAlone = 12;  ///< where the rows of a block begin
    static constexpr std::size_t columnsSize = isAlone ? std::size_t{rowsAlone} : BlockNumbers::beside;

    static constexpr D all(double value) { return D{} + value; }

    static S blockOf(const IslandLanes& v, std::uint32_t i) { return {v.block + i * blockSize * N}; }
    static S inverseOf(const IslandLanes& v, std::uint32_t i) { return {v.inverse + i * blockSize * N}; }
    static S solutionOf(const IslandLanes& v, std::uint32_t node) { return {v.solution + node * nodeSize * N}; }
    static Item bodyAt(const IslandLanes& v, std::uint32_t node) { return {v.body + v.bodyPlaces[node]}; }
    static Item rowAt(const IslandLanes& v, std::uint32_t row) { return {v.row + v.rowPlaces[row]}; }

    /// Where the number in this row and column of a block is.
    static constexpr int in(int row, int column) { return isAlone ? 4 * column + row : 3 * row + column; }

    using Vector = typename Wide<W>::Double;
    template <int rows>
    using Column = std::conditional_t<isAlone, ColumnParts<Vector, double, std::size_t{4 / Wide<W>::doubles}>,
                                      ColumnParts<Vector, Vector, std::size_t{rows}>>;

    /// Numbers that follow each other, or of which only each third is taken.
    template <int M, int each>
    static Column<M> load(const S& from, int first) {
        Column<M> column;
        if constexpr (isAlone)
            for (int i = 0; i < 4; i += Wide<W>::doubles)
                column.at[i / Wide<W>::doubles] = loadLanes<W>(static_cast<const double*>(from.data + first + i));
        else
            for (int i = 0; i < M; ++i) column.at[i] = from[first + each * i];
        return column;
    }
    template <int M, int each>
    static void store(const S& to, int first, const Column<M>& column) {
        if constexpr (isAlone)
            for (int i = 0; i < 4; i += Wide<W>::doubles)
                storeLanes(to.data + first + i, column.at[i / Wide<W>::doubles]);
        else
            for (int i = 0; i < M; ++i) to.set(first + each * i, column.at[i]);
    }
    template <int M>
    static Column<M> columnOf(const S& block, int c) {
        return load<M, 3>(block, in(0, c));
    }
    /// Of a block below the diagonal.
    template <int E>
    static Column<E> rowOf(const S& block, int r) {
        return load<E, 1>(block, isAlone ? rowsAlone + 4 * r : 3 * r);
    }

    static void clear(const S& numbers, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) numbers.set(static_cast<int>(i), D{});
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
    template <int size>
    struct Size {
        static constexpr int value = size;
    };

    /// The same for the height of a column. If a column is a vector, it is high enough for all.
    template <class Work>
    [[gnu::always_inline]] static inline void ofHeight(std::uint32_t rows, Work&& work) {
        if constexpr (isAlone)
            work(Size<3>{});
        else
            sized(rows, work);
    }

    static void factor(const IslandLanes& v) {
        for (std::uint32_t k = 0; k < v.stepCount; ++k) {
            if (v.slack > 0 && v.steps[k].node >= v.moved) loosen(v, blockOf(v, v.steps[k].node));
            sized(v.steps[k].size, [&](auto size) { eliminate<decltype(size)::value>(v, k); });
        }
    }

    /// Makes a joint of a tree softer by a share of what it gives.
    static void loosen(const IslandLanes& v, const S& block) {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) block.set(in(i, j), block[in(i, j)] * (1 + v.slack));
    }

    /// Of a symmetric matrix; zero where it has none. By L D L^T: of a body that a joint has made stiff along one
    /// direction, the determinant would lose the other directions.
    template <int E>
    static void invert(const S& m) {
        if constexpr (E == 1) {
            m.set(0, reciprocal(m[0]));
        } else if constexpr (E == 2) {
            const D i0 = reciprocal(m[0]), l = m[in(0, 1)] * i0;
            const D i1 = reciprocal(m[in(1, 1)] - l * m[in(0, 1)]);
            m.set(0, i0 + l * l * i1);
            m.set(in(0, 1), -l * i1);
            m.set(in(1, 0), -l * i1);
            m.set(in(1, 1), i1);
        } else {
            const D m1 = m[in(0, 1)], m2 = m[in(0, 2)];
            const D i0 = reciprocal(m[0]), l1 = m1 * i0, l2 = m2 * i0;
            const D i1 = reciprocal(m[in(1, 1)] - l1 * m1), e = m[in(1, 2)] - l1 * m2, l3 = e * i1;
            const D i2 = reciprocal(m[in(2, 2)] - l2 * m2 - l3 * e), p = l1 * l3 - l2;
            const D xy = -l1 * i1 - p * l3 * i2, xz = p * i2, yz = -l3 * i2;
            const D inverse[9] = {i0 + l1 * l1 * i1 + p * p * i2, xy, xz, xy, i1 + l3 * l3 * i2, yz, xz, yz, i2};
            for (int i = 0; i < 9; ++i) m.set(in(i / 3, i % 3), inverse[i]);
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
        const std::uint32_t end = v.steps[k + 1].firstUpdate;
        for (std::uint32_t u = v.steps[k].firstUpdate, next = u; u < end; u = next) {
            while (next < end && v.updates[next].left == v.updates[u].left) ++next;
            ofHeight(v.updates[u].leftSize, [&](auto rows) {
                constexpr int m = decltype(rows)::value;
                Column<m> scaled[std::size_t{E}];
                scale<E, m>(blockOf(v, v.updates[u].left), inverse, scaled);
                for (std::uint32_t i = u; i < next; ++i)
                    sized(v.updates[i].rightSize, [&](auto columns) {
                        subtract<E, m, decltype(columns)::value>(blockOf(v, v.updates[i].target), scaled,
                                                                 blockOf(v, v.updates[i].right));
                    });
            });
        }
        for (std::uint32_t l = v.steps[k].firstLower; l < v.steps[k + 1].firstLower; ++l)
            ofHeight(v.lowers[l].size,
                     [&](auto rows) { keep<E, decltype(rows)::value>(blockOf(v, v.lowers[l].block), inverse); });
    }
    /// scaled = left times inverse.
    template <int E, int M>
    static void scale(const S& left, const S& inverse, Column<M> (&scaled)[std::size_t{E}]) {
        for (int j = 0; j < E; ++j) {
            scaled[j] = columnOf<M>(left, 0) * inverse[in(0, j)];
            for (int c = 1; c < E; ++c) scaled[j] = scaled[j] + columnOf<M>(left, c) * inverse[in(c, j)];
        }
    }
    /// target -= scaled times right^T.
    template <int E, int M, int columns>
    static void subtract(const S& target, const Column<M> (&scaled)[std::size_t{E}], const S& right) {
        for (int j = 0; j < columns; ++j) {
            Column<M> sum = scaled[0] * right[in(j, 0)];
            for (int c = 1; c < E; ++c) sum = sum + scaled[c] * right[in(j, c)];
            store<M, 3>(target, in(0, j), columnOf<M>(target, j) - sum);
        }
    }
    /// A_ik becomes L_ik.
    template <int E, int M>
    static void keep(const S& block, const S& inverse) {
        Column<M> scaled[std::size_t{E}];
        scale<E, M>(block, inverse, scaled);
        for (int c = 0; c < E; ++c) {
            store<M, 3>(block, in(0, c), scaled[c]);
            if constexpr (isAlone)
                for (int r = 0; r < M; ++r) block.set(rowsAlone + 4 * r + c, block[in(r, c)]);
        }
    }

    static void substitute(const IslandLanes& v) {
        for (std::uint32_t k = 0; k < v.stepCount; ++k)
            sized(v.steps[k].size, [&](auto size) { forward<decltype(size)::value>(v, k); });
        for (std::uint32_t k = v.stepCount; k-- > 0;)
            sized(v.steps[k].size, [&](auto size) { backward<decltype(size)::value>(v, k); });
    }
    /// Block times x.
    template <int E, int M>
    static Column<M> times(const S& block, const D (&x)[std::size_t{E}]) {
        Column<M> sum = columnOf<M>(block, 0) * x[0];
        for (int c = 1; c < E; ++c) sum = sum + columnOf<M>(block, c) * x[c];
        return sum;
    }
    template <int E>
    static void forward(const IslandLanes& v, std::uint32_t k) {
        const S at = solutionOf(v, v.steps[k].node);
        D x[std::size_t{E}];
        for (int c = 0; c < E; ++c) x[c] = at[c];
        for (std::uint32_t l = v.steps[k].firstLower; l < v.steps[k + 1].firstLower; ++l) {
            const S block = blockOf(v, v.lowers[l].block), y = solutionOf(v, v.lowers[l].node);
            ofHeight(v.lowers[l].size, [&](auto rows) {
                constexpr int m = decltype(rows)::value;
                store<m, 1>(y, 0, load<m, 1>(y, 0) - times<E, m>(block, x));
            });
        }
        store<E, 1>(at, 0, times<E, E>(blockOf(v, v.steps[k].node), x));
    }
    template <int E>
    static void backward(const IslandLanes& v, std::uint32_t k) {
        const S at = solutionOf(v, v.steps[k].node);
        Column<E> x = load<E, 1>(at, 0);
        for (std::uint32_t l = v.steps[k].firstLower; l < v.steps[k + 1].firstLower; ++l) {
            const S block = blockOf(v, v.lowers[l].block), y = solutionOf(v, v.lowers[l].node);
            sized(v.lowers[l].size, [&](auto rows) {
                for (int r = 0; r < decltype(rows)::value; ++r) x = x - rowOf<E>(block, r) * y[r];
            });
        }
        store<E, 1>(at, 0, x);
    }
};

}  // namespace plumb
