// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/block_solver.h>

#include <algorithm>

namespace plumb {

namespace {

Mat3 transposed(const Mat3& m) {
    Mat3 result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result[i][j] = m[j][i];
    return result;
}

}  // namespace

void BlockSolver::clear() {
    std::fill(blocks_.begin(), blocks_.end(), Mat3{});
}

void BlockSolver::add(std::size_t edge, const Mat3& m) {
    Mat3& block = blocks_[plan_->places[edge].block];
    const Mat3 added = plan_->places[edge].transposed ? transposed(m) : m;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) block[i][j] += added[i][j];
}

void BlockSolver::factor() {
    for (std::size_t k = 0; k + 1 < plan_->steps.size(); ++k) {
        Mat3& inverse = blocks_[plan_->steps[k].node];
        inverse = symmetricInverse(inverse);
        std::uint32_t last = 0;
        Mat3 scaled;
        for (std::size_t u = plan_->steps[k].firstUpdate; u < plan_->steps[k + 1].firstUpdate; ++u) {
            const BlockPlan::Update& update = plan_->updates[u];
            if (u == plan_->steps[k].firstUpdate || update.left != last) scaled = blocks_[update.left] * inverse;
            last = update.left;
            subtractTimesTransposed(blocks_[update.target], scaled, blocks_[update.right]);
        }
    }
}

void BlockSolver::solve(std::span<Vec3> x) const {
    for (std::size_t k = 0; k + 1 < plan_->steps.size(); ++k) {
        if (plan_->steps[k].firstLower == plan_->steps[k + 1].firstLower) continue;
        const Vec3 scaled = blocks_[plan_->steps[k].node] * x[plan_->steps[k].node];
        for (std::size_t l = plan_->steps[k].firstLower; l < plan_->steps[k + 1].firstLower; ++l)
            subtract(x[plan_->lowers[l].node], blocks_[plan_->lowers[l].block] * scaled);
    }
    for (std::size_t k = plan_->steps.size() - 1; k-- > 0;) {
        Vec3 right = x[plan_->steps[k].node];
        for (std::size_t l = plan_->steps[k].firstLower; l < plan_->steps[k + 1].firstLower; ++l)
            subtract(right, transposeTimes(blocks_[plan_->lowers[l].block], x[plan_->lowers[l].node]));
        // D^-1 (b - sum D L^T x): the sum holds A_ik^T x_i as it stands
        x[plan_->steps[k].node] = blocks_[plan_->steps[k].node] * right;
    }
}

}  // namespace plumb
