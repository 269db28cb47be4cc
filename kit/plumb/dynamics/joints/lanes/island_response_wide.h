// SPDX-License-Identifier: MIT
// By how much does each body of W islands respond to an impulse on it, together with all that its joints move?
//
// The response of a body is K f, with f = (x, y, turning): K is its block of the inverse of the island's matrix. All
// such blocks are found in the time of one factorisation, from the last node to the first: with A = L D L^T and the
// nodes i, j that are eliminated after k and have a block with it,
//   Z_ik = - sum_j Z_ij L_jk,   Z_kk = D_k^-1 - sum_i L_ik^T Z_ik,   L_ik = A_ik D_k^-1.
// Contacts see bodies with a mass m and a moment of inertia J of the same K, so that diag(1/m, 1/m, 1/J) is no less
// than K in any direction: 1/m = a + b sqrt(a / c), 1/J = c + b sqrt(c / a), where a is the greatest response to an
// impulse through the centre of mass, c that to a turning one, and b what connects them.
// Source: selected inverse: Takahashi, Fagan, Chen, "Formation of a sparse bus impedance matrix", 1973.
#pragma once
#include <plumb/dynamics/joints/lanes/island_elimination_wide.h>

namespace plumb {

template <int W, LaneUse use>
struct Response {
    using Factors = BlockFactors<W, use>;
    using D = typename Factors::D;
    using S = typename Factors::S;
    using B = BodyField;
    static S blockOf(const IslandLanes& v, std::uint32_t i) { return Factors::blockOf(v, i); }
    static S inverseOf(const IslandLanes& v, std::uint32_t i) { return Factors::inverseOf(v, i); }

    static void find(IslandLanes& v) {
        Elimination<W, use>::makeFactors(v);
        for (std::uint32_t i = 0; i < v.blocks; ++i) Factors::clear(inverseOf(v, i), Factors::columnsSize);
        for (std::uint32_t k = v.stepCount; k-- > 0;) invert(v, k);
        for (std::uint32_t i = 0; i < v.moved; ++i) bound(Factors::bodyAt(v, i), inverseOf(v, i));
    }

    static void invert(const IslandLanes& v, std::uint32_t k) {
        const std::uint32_t node = v.steps[k].node;
        const S inverse = blockOf(v, node), own = inverseOf(v, node);
        for (std::uint32_t u = v.steps[k].firstUpdate; u < v.steps[k + 1].firstUpdate; ++u) {
            const IslandShape::Update& update = v.updates[u];
            const S known = inverseOf(v, update.target);
            subtractProduct<false>(inverseOf(v, update.left), known, blockOf(v, update.right));
            if (update.left != update.right)
                subtractProduct<true>(inverseOf(v, update.right), known, blockOf(v, update.left));
        }
        for (int c = 0; c < static_cast<int>(Factors::columnsSize); ++c) own.set(c, inverse[c]);
        for (std::uint32_t l = v.steps[k].firstLower; l < v.steps[k + 1].firstLower; ++l)
            subtractProduct<true>(own, blockOf(v, v.lowers[l].block), inverseOf(v, v.lowers[l].block));
    }

    /// to -= left right, or left^T right.
    template <bool transposed>
    static void subtractProduct(const S& to, const S& left, const S& right) {
        constexpr auto in = [](int i, int j) { return Factors::in(i, j); };
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                D sum = to[in(i, j)];
                for (int c = 0; c < 3; ++c) sum -= left[transposed ? in(c, i) : in(i, c)] * right[in(c, j)];
                to.set(in(i, j), sum);
            }
    }

    static void bound(const typename Factors::Item& b, const S& k) {
        const D xx = k[0], yy = k[Factors::in(1, 1)], half = 0.5 * (xx - yy), xy = k[Factors::in(0, 1)];
        const D xw = k[Factors::in(0, 2)], yw = k[Factors::in(1, 2)], ww = k[Factors::in(2, 2)];
        const D a = atLeast0(0.5 * (xx + yy) + rootOf(half * half + xy * xy)), c = atLeast0(ww);
        const auto both = a * c > D{};
        const D cross = both ? rootOf((xw * xw + yw * yw) / (both ? a * c : Factors::all(1))) : D{};
        b.set(B::Response, a * (1.0 + cross));
        b.set(B::TurnResponse, c * (1.0 + cross));
    }
    static D atLeast0(D value) { return value > D{} ? value : D{}; }
    static D rootOf(D square) {
        if constexpr (Factors::isAlone)
            return __builtin_sqrt(square);
        else
            return squareRoot<W>(square);
    }
};

}  // namespace plumb
