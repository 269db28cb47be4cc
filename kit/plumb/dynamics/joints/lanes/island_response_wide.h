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
        for (std::uint32_t i = 0; i < v.blocks; ++i)
            for (int c = 0; c < 9; ++c) inverseOf(v, i).set(c, D{});
        for (std::uint32_t k = v.stepCount; k-- > 0;) invert(v, k);
        for (std::uint32_t i = 0; i < v.moved; ++i) bound(Factors::bodyAt(v, i), inverseOf(v, i));
    }

    static void invert(const IslandLanes& v, std::uint32_t k) {
        const std::uint32_t node = v.steps[k].node;
        const S inverse = blockOf(v, node), own = inverseOf(v, node);
        for (std::uint32_t u = v.steps[k].firstUpdate; u < v.steps[k + 1].firstUpdate; ++u) {
            const IslandShape::Update& update = v.updates[u];
            const S known = inverseOf(v, update.target);
            addProduct<false>(inverseOf(v, update.left), known, blockOf(v, update.right), inverse);
            if (update.left != update.right)
                addProduct<true>(inverseOf(v, update.right), known, blockOf(v, update.left), inverse);
        }
        for (int c = 0; c < 9; ++c) own.set(c, inverse[c]);
        for (std::uint32_t l = v.steps[k].firstLower; l < v.steps[k + 1].firstLower; ++l)
            subtractSolved(own, inverse, blockOf(v, v.lowers[l].block), inverseOf(v, v.lowers[l].block));
    }

    /// to -= known L, with L = block inverse.
    template <bool transposed>
    static void addProduct(const S& to, const S& known, const S& block, const S& inverse) {
        D l[9];
        multiply(l, block, inverse);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                D sum = to[3 * i + j];
                for (int c = 0; c < 3; ++c) sum -= known[transposed ? 3 * c + i : 3 * i + c] * l[3 * c + j];
                to.set(3 * i + j, sum);
            }
    }
    /// own -= L^T solved.
    static void subtractSolved(const S& own, const S& inverse, const S& block, const S& solved) {
        D l[9];
        multiply(l, block, inverse);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                D sum = own[3 * i + j];
                for (int c = 0; c < 3; ++c) sum -= l[3 * c + i] * solved[3 * c + j];
                own.set(3 * i + j, sum);
            }
    }
    static void multiply(D (&l)[9], const S& block, const S& inverse) {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                D sum = block[3 * i] * inverse[j];
                for (int c = 1; c < 3; ++c) sum += block[3 * i + c] * inverse[3 * c + j];
                l[3 * i + j] = sum;
            }
    }

    static void bound(const typename Factors::Item& b, const S& k) {
        const D half = 0.5 * (k[0] - k[4]);
        const D a = atLeast0(0.5 * (k[0] + k[4]) + rootOf(half * half + k[1] * k[1])), c = atLeast0(k[8]);
        const auto both = a * c > D{};
        const D cross = both ? rootOf((k[2] * k[2] + k[5] * k[5]) / (both ? a * c : Factors::all(1))) : D{};
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
