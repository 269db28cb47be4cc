// SPDX-License-Identifier: MIT
#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include <plumb/dynamics/joints/block_solver.h>
#include <plumb/math/random.h>
#include "catch.h"

using plumb::BlockPlan;
using plumb::BlockSolver;
using plumb::Mat3;
using plumb::Vec3;

namespace {

/// Bodies and joints as a machine has them: some nodes positive, the others, which link two of them, negative.
struct Machine {
    std::uint32_t bodies = 0, joints = 0;
    std::vector<BlockPlan::Edge> edges;

    Machine(plumb::Random& random, int size, int loops) : bodies(static_cast<std::uint32_t>(size)) {
        for (int body = 1; body < size; ++body) link(body, random.integer(0, body - 1));
        for (int loop = 0; loop < loops; ++loop) {
            const int a = random.integer(0, size - 1);
            link(a, (a + random.integer(1, size - 1)) % size);
        }
    }
    void link(int a, int b) {
        const std::uint32_t joint = bodies + joints++;
        edges.push_back({joint, static_cast<std::uint32_t>(a)});
        edges.push_back({static_cast<std::uint32_t>(b), joint});
    }
};

Mat3 randomBlock(plumb::Random& random) {
    Mat3 m;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) m[i][j] = random.uniform(-1, 1);
    return m;
}

}  // namespace

TEST_CASE("a sparse system of blocks is solved as a dense one is", "[dynamics][property]") {
    plumb::Random random(1);
    for (int round = 0; round < 300; ++round) {
        Machine machine(random, random.integer(2, 20), random.integer(0, 6));
        const std::uint32_t nodes = machine.bodies + machine.joints;
        const auto plan = plumb::planBlocks(nodes, machine.edges, 100000);
        REQUIRE(plan != nullptr);
        BlockSolver solver(plan);
        Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(3 * nodes, 3 * nodes);
        Eigen::VectorXd right(3 * nodes);
        solver.clear();
        std::vector<Vec3> x(nodes);
        for (std::uint32_t node = 0; node < nodes; ++node) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                const double value = node < machine.bodies ? random.uniform(0.1, 10) : -random.uniform(1e-3, 1);
                solver.diagonal(node)[i][i] = dense(3 * node + i, 3 * node + i) = value;
                x[node][i] = right[3 * node + i] = random.uniform(-1, 1);
            }
        }
        for (std::size_t e = 0; e < machine.edges.size(); ++e) {
            const auto [a, b] = machine.edges[e];
            const Mat3 block = randomBlock(random);
            solver.add(e, block);
            for (std::uint32_t i = 0; i < 3; ++i) {
                for (std::uint32_t j = 0; j < 3; ++j) {
                    dense(3 * a + i, 3 * b + j) += block[i][j];
                    dense(3 * b + j, 3 * a + i) += block[i][j];
                }
            }
        }
        solver.factor();
        solver.solve(x);
        const Eigen::VectorXd truth = dense.fullPivLu().solve(right);
        double worst = 0;
        for (std::uint32_t node = 0; node < nodes; ++node)
            for (std::uint32_t i = 0; i < 3; ++i) worst = std::max(worst, std::abs(x[node][i] - truth[3 * node + i]));
        CHECK(worst < 1e-9 * (1 + truth.cwiseAbs().maxCoeff()));  // rounding, times a condition of some 1e5
    }
}

TEST_CASE("a tree of 10,000 nodes takes at most three block updates a node", "[dynamics]") {
    plumb::Random random(2);
    const Machine machine(random, 5000, 0);
    const std::uint32_t nodes = machine.bodies + machine.joints;
    CHECK(plumb::planBlocks(nodes, machine.edges, 3 * nodes) != nullptr);
}

TEST_CASE("a net that fills in more than it may is refused", "[dynamics]") {
    plumb::Random random(3);
    const Machine machine(random, 200, 2000);
    CHECK(plumb::planBlocks(machine.bodies + machine.joints, machine.edges, 10000) == nullptr);
}

TEST_CASE("equal machines share one order of elimination, until none is left", "[dynamics]") {
    plumb::Random random(4);
    const Machine doll(random, 11, 0), other(random, 12, 1);
    const auto nodesOf = [](const Machine& machine) { return machine.bodies + machine.joints; };
    plumb::BlockPlans plans;
    const auto plan = plans.find(nodesOf(doll), doll.edges, 1000);
    CHECK(plans.find(nodesOf(doll), doll.edges, 1000) == plan);
    CHECK(plans.find(nodesOf(other), other.edges, 1000) != plan);
    plans.renew();
    CHECK(plans.find(nodesOf(doll), doll.edges, 1000) == plan);
    plans.renew();
    plans.renew();
    CHECK(plan.use_count() == 1);
}
