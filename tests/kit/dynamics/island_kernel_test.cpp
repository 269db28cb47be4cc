// SPDX-License-Identifier: MIT
// Does the solver of joint islands find what a dense solution of the same equations finds?
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include <plumb/dynamics/joints/joint_rows.h>
#include <plumb/math/detail/for_lanes.h>
#include "catch.h"
#include "kit/dynamics/island_machines.h"

using plumb::BlockPlan;
using plumb::BodyField;
using plumb::IslandLayout;
using plumb::IslandLayouts;
using plumb::Random;
using plumb::RowAxis;
using plumb::RowField;
using plumb::RowState;
using plumb::test::DenseRows;
using plumb::test::KernelNumbers;
using plumb::test::MachineParts;
using plumb::test::RandomMachine;
using plumb::test::randomMachine;

namespace {

/// A row that does not hold.
struct Curve {
    double target = 0, low = 0, high = 0, lowerStop = -plumb::unlimited, upperStop = plumb::unlimited;
    bool bounded = false;
};

/// A part of its curve that the row has.
RowState validState(const Curve& row, RowState state) {
    if (row.high == plumb::unlimited) return RowState::AtTarget;
    if (row.bounded) return state > RowState::AtHigh ? RowState::AtTarget : state;
    if (state == RowState::AtLowerStop && row.lowerStop == -plumb::unlimited) return RowState::AtHigh;
    if (state == RowState::AtUpperStop && row.upperStop == plumb::unlimited) return RowState::AtLow;
    return state == RowState::AtTarget && row.low == row.high ? RowState::AtLow : state;
}

/// Motor, spring and limits of a row that does not hold, each of which may be missing; and a state that is valid.
void drawCurve(Random& random, KernelNumbers& lanes, std::size_t i) {
    const auto chance = [&] { return random.integer(0, 1) == 0; };
    Curve row;
    row.bounded = lanes.layout().rows[i].bounded;
    row.high = chance() ? random.uniform(0, 3) : 0;
    if (random.integer(0, 7) == 0) row.high = plumb::unlimited;
    row.low = -row.high;
    if (!row.bounded) {
        if (chance()) row.lowerStop = random.uniform(-2, 1);
        if (chance()) row.upperStop = std::max(row.lowerStop, random.uniform(-1, 2));
        row.target = std::clamp(random.uniform(-2, 2), row.lowerStop, row.upperStop);
    }
    const bool springs = chance();
    const double push = springs ? random.uniform(-3, 3) : 0, slope = springs && chance() ? random.uniform(0.01, 3) : 0;
    const auto drawn = static_cast<RowState>(random.integer(0, 4));
    const double fields[] = {static_cast<double>(validState(row, drawn)),
                             row.target,
                             row.low,
                             row.high,
                             row.lowerStop,
                             row.upperStop,
                             push,
                             0,
                             slope};
    for (std::size_t f = 0; f < std::size(fields); ++f) lanes.row(i, RowField::State + static_cast<int>(f)) = fields[f];
}

/// The axis of a part of a row, and its levers: rows of a joint are independent.
void drawAxis(Random& random, KernelNumbers& lanes, std::size_t i, std::uint32_t part) {
    const IslandLayout& layout = lanes.layout();
    const int at = part == 0 ? RowField::AxisX : RowField::SecondAxisX;
    const bool isSecond = i > 0 && layout.rows[i - 1].link == layout.rows[i].link;
    const RowAxis axis = layout.rows[i].axis[part];
    const double angle = axis == RowAxis::World ? (isSecond ? 1.57 : 0.0) : random.uniform(0, 6);
    const bool turns = axis == RowAxis::Turning;
    lanes.row(i, at) = turns ? 0 : std::cos(angle);
    lanes.row(i, at + 1) = turns ? 0 : std::sin(angle);
    lanes.row(i, at + 2) = turns ? -1 : random.uniform(-1, 1);
    lanes.row(i, at + 3) = turns ? 1 : random.uniform(-1, 1);
}

/// turns: all bodies can turn; else some cannot.
void drawNumbers(Random& random, KernelNumbers& lanes, bool allTurn = false) {
    const IslandLayout& layout = lanes.layout();
    for (std::uint32_t b = 0; b < layout.bodies; ++b) {
        for (int c = 0; c < 3; ++c)
            lanes.body(b, BodyField::FreeX + c) = lanes.body(b, BodyField::Vx + c) = random.uniform(-3, 3);
        if (b >= layout.moved) continue;
        const double mass = random.uniform(0.1, 10), inertia = random.uniform(0.1, 10);
        const bool turns = random.integer(0, 7) > 0 || allTurn;
        lanes.body(b, BodyField::Mass) = mass;
        lanes.body(b, BodyField::InverseMass) = 1 / mass;
        lanes.body(b, BodyField::Inertia) = turns ? inertia : 0;
        lanes.body(b, BodyField::InverseInertia) = turns ? 1 / inertia : 0;
    }
    for (std::size_t i = 0; i < layout.rows.size(); ++i) {
        for (std::uint32_t part = 0; part < layout.rows[i].parts; ++part) drawAxis(random, lanes, i, part);
        lanes.row(i, RowField::Speed) = random.uniform(-1, 1);
        if (!layout.rows[i].holds) drawCurve(random, lanes, i);
    }
    const DenseRows dense(lanes);
    for (std::size_t i = 0; i < layout.rows.size(); ++i) {
        const double inverseMass = dense.inverseMassOf(static_cast<Eigen::Index>(i));
        lanes.row(i, RowField::InverseMass) = inverseMass;
        lanes.row(i, RowField::Compliance) = inverseMass > 0 ? lanes.view().compliance * inverseMass : -1;
    }
}

/// By how much velocities and impulses differ from M u - J^T L = 0, J u + e L = what rows lack; as a share of the
/// largest.
double differenceFromDense(KernelNumbers& lanes, const std::vector<double>& wanted) {
    const DenseRows dense(lanes);
    const Eigen::Index rows = dense.rows.rows(), moved = 3 * static_cast<Eigen::Index>(lanes.layout().moved);
    using Matrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    Matrix matrix = Matrix::Zero(moved + rows, moved + rows);
    Eigen::Matrix<long double, Eigen::Dynamic, 1> right = Matrix::Zero(moved + rows, 1);
    for (Eigen::Index i = 0; i < moved; ++i)
        matrix(i, i) = dense.inverseMass[i] > 0 ? 1.0L / static_cast<long double>(dense.inverseMass[i]) : 1.0L;
    for (Eigen::Index r = 0; r < rows; ++r) {
        for (Eigen::Index i = 0; i < moved; ++i)
            matrix(moved + r, i) = matrix(i, moved + r) = dense.inverseMass[i] > 0 ? -dense.rows(r, i) : 0;
        const double own = dense.inverseMassOf(r);
        matrix(moved + r, moved + r) = own > 0 ? -lanes.view().compliance * own : -1;
        if (own > 0) right[moved + r] = dense.rows.row(r).dot(dense.before) - wanted[static_cast<std::size_t>(r)];
    }
    const Eigen::VectorXd truth = matrix.fullPivLu().solve(right).template cast<double>();
    double speedError = 0, impulseError = 0;
    for (Eigen::Index i = 0; i < moved; ++i) {
        const double now = lanes.body(static_cast<std::size_t>(i / 3), BodyField::Ux + static_cast<int>(i % 3));
        speedError = std::max(speedError, std::fabs(now - dense.before[i] - truth[i]));
    }
    for (Eigen::Index r = 0; r < rows; ++r) {
        const double impulse = lanes.row(static_cast<std::size_t>(r), RowField::Impulse);
        impulseError = std::max(impulseError, std::fabs(impulse - truth[moved + r]));
    }
    return std::max(speedError / (1 + truth.head(moved).cwiseAbs().maxCoeff()),
                    impulseError / (1 + truth.tail(rows).cwiseAbs().maxCoeff()));
}

/// Of the first link of each joint.
std::vector<BlockPlan::Edge> edgesOf(const RandomMachine& machine) {
    std::vector<BlockPlan::Edge> edges;
    for (std::uint32_t j = 0; j < machine.joints.size(); ++j) {
        const IslandLayout::Link& link = machine.joints[j].link[0];
        edges.push_back({machine.moved + j, link.a});
        edges.push_back({link.b, machine.moved + j});
    }
    return edges;
}

/// Is the row at a point of the curve in island_curve_wide.h? Up to rounding, and up to the compliance of its stiff
/// parts.
bool isOnCurve(KernelNumbers& lanes, std::size_t i, double speed) {
    const auto field = [&](int f) { return lanes.row(i, f); };
    const double impulse = field(RowField::Impulse), push = field(RowField::Push), slope = field(RowField::Slope);
    const double low = field(RowField::Low), high = field(RowField::High), target = field(RowField::Target);
    const double lower = field(RowField::LowerStop), upper = field(RowField::UpperStop);
    const double give = plumb::relativeCompliance * field(RowField::InverseMass) * std::fabs(impulse);
    const double s = give + 1e-6 * (1 + std::fabs(speed));
    const double t = 1e-6 * (1 + std::fabs(impulse) + std::fabs(push) + slope * std::fabs(speed));
    const double aside = push - slope * speed, driven = impulse - aside;
    if (lanes.layout().rows[i].bounded) return std::fabs(impulse - std::clamp(aside, low, high)) <= t;
    if (speed < lower - s || speed > upper + s) return false;
    if (driven > high + t) return speed <= lower + s;
    if (driven < low - t) return speed >= upper - s;
    const bool isBelow = speed<target - s, isAbove = speed> target + s;
    return !(isBelow && driven < high - t) && !(isAbove && driven > low + t);
}

std::vector<double> wantedSpeeds(KernelNumbers& lanes) {
    std::vector<double> wanted;
    for (std::size_t i = 0; i < lanes.layout().rows.size(); ++i) wanted.push_back(lanes.row(i, RowField::Speed));
    return wanted;
}

/// How many lanes of doubles this machine can have.
std::vector<std::size_t> widths() {
    std::vector<std::size_t> some{1};
    for (const int width : {2, 4, 8})
        if (plumb::machineLanes() >= 2 * width) some.push_back(static_cast<std::size_t>(width));
    return some;
}

}  // namespace

TEST_CASE("joints of random trees and loops get the impulses of a dense solution", "[dynamics][joints][property]") {
    struct Kind {
        MachineParts most;
        double error;
        bool allTurn = false;
    };
    // Rounding, times a condition of some 1e5. A joint that is eliminated before a body makes it 1 / e = 1e5 times as
    // stiff along its rows: of the body's other directions, some digits are lost then.
    const Kind kinds[] = {{{.loops = 0, .held = 1, .gears = 0}, 1e-9, true},
                          {{.loops = 0, .held = 1, .gears = 0}, 1e-5},
                          {{.held = 0, .gears = 0}, 1e-6},
                          {{}, 1e-5}};
    Random random(1);
    IslandLayouts layouts;
    for (const Kind& kind : kinds) {
        double worst = 0;
        for (int round = 0; round < 200; ++round) {
            const auto layout = randomMachine(random, kind.most).layout(layouts, kind.allTurn);
            REQUIRE(layout != nullptr);
            KernelNumbers lanes(layout, 1);
            drawNumbers(random, lanes, kind.allTurn);
            const std::vector<double> wanted = wantedSpeeds(lanes);
            CHECK_FALSE(lanes.solve());
            worst = std::max(worst, differenceFromDense(lanes, wanted));
        }
        CHECK(worst < kind.error);
    }
}

TEST_CASE("rows with motors, springs and limits come to rest on their curves", "[dynamics][joints][property]") {
    constexpr int rounds = 300;
    Random random(6);
    IslandLayouts layouts;
    int settled = 0;
    for (int round = 0; round < rounds; ++round) {
        INFO("round " << round);
        const auto layout = randomMachine(random, {.loops = 2, .gears = 1, .someFree = true}).layout(layouts);
        REQUIRE(layout != nullptr);
        KernelNumbers lanes(layout, 1);
        drawNumbers(random, lanes);
        bool changes = true;
        for (int turn = 0; turn < 10 && changes; ++turn) changes = lanes.solve();
        if (changes) continue;
        ++settled;
        const DenseRows dense(lanes);
        for (std::size_t i = 0; i < layout->rows.size(); ++i) {
            INFO("row " << i);
            if (!layout->rows[i].holds && lanes.row(i, RowField::InverseMass) > 0)
                CHECK(isOnCurve(lanes, i, dense.speedAfter(lanes, i)));
        }
        CHECK(dense.velocityError(lanes) < 1e-6);
    }
    CHECK(settled > rounds * 9 / 10);
}

TEST_CASE("joint islands that are solved side by side get the bits that each gets alone", "[dynamics][joints]") {
    Random random(2);
    IslandLayouts layouts;
    for (int round = 0; round < 60; ++round) {
        const auto layout = randomMachine(random, {.someFree = round % 2 == 1}).layout(layouts);
        REQUIRE(layout != nullptr);
        std::vector<std::unique_ptr<KernelNumbers>> singles;
        for (int i = 0; i < 8; ++i)
            drawNumbers(random, *singles.emplace_back(std::make_unique<KernelNumbers>(layout, 1, 1)));
        std::vector<std::unique_ptr<KernelNumbers>> wide;
        for (const std::size_t width : widths()) {
            KernelNumbers& lanes = *wide.emplace_back(std::make_unique<KernelNumbers>(layout, width));
            for (std::size_t lane = 0; lane < width; ++lane) lanes.take(*singles[lane], lane);
            lanes.solve();
        }
        for (const auto& single : singles) single->solve();
        for (std::size_t i = 0; i < wide.size(); ++i)
            for (std::size_t lane = 0; lane < widths()[i]; ++lane) CHECK(wide[i]->hasBitsOf(*singles[lane], lane));
    }
}

TEST_CASE("a tree of 10,000 nodes takes at most three block updates a node", "[dynamics]") {
    Random random(3);
    const RandomMachine machine(random, 5000, {.loops = 0, .held = 0, .gears = 0});
    const std::vector<BlockPlan::Edge> edges = edgesOf(machine);
    const auto joints = static_cast<std::uint32_t>(machine.joints.size());
    CHECK(plumb::planBlocks(machine.moved, joints, edges, 3 * (machine.moved + joints)) != nullptr);
}

TEST_CASE("a chain between two walls is eliminated from both ends in turn", "[dynamics]") {
    constexpr std::uint32_t bodies = 20, joints = bodies + 1;
    std::vector<BlockPlan::Edge> edges;
    for (std::uint32_t j = 0; j < joints; ++j) {
        if (j > 0) edges.push_back({bodies + j, j - 1});
        if (j < bodies) edges.push_back({bodies + j, j});
    }
    const auto plan = plumb::planBlocks(bodies, joints, edges, 1000, true);
    REQUIRE(plan != nullptr);
    std::vector<std::uint32_t> order;
    for (const BlockPlan::Step& step : plan->steps)
        if (step.node < bodies) order.push_back(step.node);
    for (std::uint32_t i = 0; i + 1 < bodies / 2; ++i) {
        CHECK(order[2 * i] == i);
        CHECK(order[2 * i + 1] == bodies - 1 - i);
    }
}

TEST_CASE("a net that fills in more than it may is refused", "[dynamics]") {
    Random random(4);
    const RandomMachine machine(random, 200, {.loops = 2000, .held = 0, .gears = 0});
    const std::vector<BlockPlan::Edge> edges = edgesOf(machine);
    const auto joints = static_cast<std::uint32_t>(machine.joints.size());
    CHECK(plumb::planBlocks(machine.moved, joints, edges, 10000) == nullptr);
    IslandLayouts layouts;
    CHECK(machine.layout(layouts)->isSwept);
}

TEST_CASE("equal machines share one layout, until none is left", "[dynamics]") {
    Random random(5);
    const RandomMachine doll(random, 11, {.loops = 0}), other(random, 12, {.loops = 1});
    IslandLayouts layouts;
    auto layout = doll.layout(layouts);
    REQUIRE(!layout->isSwept);
    CHECK(doll.layout(layouts) == layout);
    CHECK(other.layout(layouts) != layout);
    layouts.renew();
    CHECK(doll.layout(layouts) == layout);
    const std::weak_ptr<const IslandLayout> last = std::exchange(layout, nullptr);
    layouts.renew();
    CHECK(last.expired());
}
