// SPDX-License-Identifier: MIT
// Random machines, as the solver of joint islands takes them, and as matrices.
#pragma once
#include <Eigen/Dense>
#include <cstring>
#include <memory>
#include <utility>
#include <vector>

#include <plumb/dynamics/joints/island_numbers.h>
#include <plumb/math/random.h>

namespace plumb::test {

/// A gear, or a joint of one to three rows.
inline JointForm randomForm(Random& random, bool mayGear, bool someFree) {
    JointForm form(AnchorPair{});
    const int kind = random.integer(mayGear ? 0 : 1, 9);
    if (kind == 0) form.links = 2;
    if (kind > 4) form.holdPoint();
    if (kind < 8) form.add(kind == 1 ? RowAxis::OnA : RowAxis::Turning);
    if (kind == 3 || kind == 4) form.add(RowAxis::Across);
    if (!someFree) return form;
    for (std::size_t r = 0; r < form.rows; ++r) {
        if (form.row[r].axis == RowAxis::World) continue;
        form.row[r].holds = random.integer(0, 3) == 0;
        form.row[r].bounded = !form.row[r].holds && random.integer(0, 2) == 0;
    }
    return form;
}

/// What a random machine may have.
struct MachineParts {
    int loops = 6, held = 3, gears = 3;
    bool someFree = false;
};

/// A tree of bodies and joints, with some loops, and joints to bodies that are held.
struct RandomMachine {
    std::uint32_t moved = 0, held = 0;
    std::vector<LaidJoint> joints;

    RandomMachine(Random& random, int size, const MachineParts& parts)
        : moved(static_cast<std::uint32_t>(size)), left_(parts) {
        for (int body = 1; body < size; ++body) link(random, body, random.integer(0, body - 1));
        for (int loop = 0; loop < parts.loops; ++loop) {
            const int a = random.integer(0, size - 1);
            link(random, a, (a + random.integer(1, size - 1)) % size);
        }
        for (int body = 0; body < parts.held; ++body, ++held) link(random, random.integer(0, size - 1), size + body);
    }
    std::shared_ptr<const IslandLayout> layout(IslandLayouts& layouts, bool allTurn = false) const {
        return layouts.find(moved, moved + held, allTurn, joints);
    }

private:
    void link(Random& random, int a, int b) {
        if (random.integer(0, 1) == 0) std::swap(a, b);
        LaidJoint& joint = joints.emplace_back(LaidJoint{randomForm(random, left_.gears > 0, left_.someFree), {}});
        joint.link[0] = {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)};
        if (joint.form.links == 1) return;
        // The other link of a gear may share bodies with the first one.
        joint.link[1] = random.integer(0, 1) == 0 ? joint.link[0] : joints.front().link[0];
        --left_.gears;
    }

    MachineParts left_;
};

inline RandomMachine randomMachine(Random& random, const MachineParts& most) {
    const int size = random.integer(2, 20);
    MachineParts parts = most;
    parts.loops = random.integer(0, most.loops);
    parts.held = random.integer(0, most.held);
    return RandomMachine(random, size, parts);
}

/// The numbers of some islands of one layout, as the kernel takes them, in vectors of at most so many floats.
class KernelNumbers {
public:
    KernelNumbers(std::shared_ptr<const IslandLayout> layout, std::size_t width, int mostFloats = 16)
        : islands_(width) {
        std::vector<JointIsland*> some;
        for (JointIsland& island : islands_) {
            island.layout = layout;
            some.push_back(&island);
        }
        numbers_.layOut(some, mostFloats);
        numbers_.activateAll();
        numbers_.view.slack = 0;  // the dense solution has none
    }
    KernelNumbers(const KernelNumbers&) = delete;
    KernelNumbers& operator=(const KernelNumbers&) = delete;

    const IslandLayout& layout() const { return *numbers_.layout; }
    IslandLanes& view() { return numbers_.view; }
    double& body(std::size_t i, int field, std::size_t lane = 0) { return numbers_.body(i, field, lane); }
    double& row(std::size_t i, int field, std::size_t lane = 0) { return numbers_.row(i, field, lane); }

    bool solve() {
        numbers_.fillLanes();
        return numbers_.kernel().solve(numbers_.view);
    }

    /// Of one lane; the others have only one.
    void take(KernelNumbers& single, std::size_t lane) {
        forEachNumber(single, lane, [](double& own, double& other) { own = other; });
    }
    bool hasBitsOf(KernelNumbers& single, std::size_t lane) {
        bool same = true;
        forEachNumber(single, lane,
                      [&](double& own, double& other) { same = same && std::memcmp(&own, &other, sizeof own) == 0; });
        return same;
    }

private:
    template <class Visit>
    void forEachNumber(KernelNumbers& single, std::size_t lane, Visit&& visit) {
        for (std::size_t i = 0; i < layout().bodies; ++i)
            for (int f = 0; f < BodyField::count; ++f) visit(body(i, f, lane), single.body(i, f));
        for (std::size_t i = 0; i < layout().rows.size(); ++i)
            for (int f = 0; f < RowField::count; ++f) visit(row(i, f, lane), single.row(i, f));
    }

    std::vector<JointIsland> islands_;
    IslandNumbers numbers_;
};

/// The rows of a machine as a matrix, over the velocities of all bodies. Turning of a body that cannot turn has no
/// column of its own in solving: its mass counts as infinite.
struct DenseRows {
    Eigen::MatrixXd rows;
    Eigen::VectorXd inverseMass, before;

    explicit DenseRows(KernelNumbers& lanes) {
        const IslandLayout& layout = lanes.layout();
        const auto size = 3 * static_cast<Eigen::Index>(layout.bodies);
        rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(layout.rows.size()), size);
        inverseMass = before = Eigen::VectorXd::Zero(size);
        for (std::size_t i = 0; i < layout.rows.size(); ++i)
            for (std::uint32_t part = 0; part < layout.rows[i].parts; ++part) addPart(lanes, i, part);
        for (std::uint32_t b = 0; b < layout.bodies; ++b) {
            before.segment<3>(3 * b) << lanes.body(b, BodyField::Vx), lanes.body(b, BodyField::Vy),
                lanes.body(b, BodyField::Spin);
            if (b >= layout.moved) continue;
            const double inertia = lanes.body(b, BodyField::Inertia);
            inverseMass[3 * b] = inverseMass[3 * b + 1] = 1 / lanes.body(b, BodyField::Mass);
            inverseMass[3 * b + 2] = inertia > 0 ? 1 / inertia : 0;
        }
    }
    Eigen::VectorXd after(KernelNumbers& lanes) const {
        Eigen::VectorXd u(before.size());
        for (Eigen::Index i = 0; i < u.size(); ++i)
            u[i] = lanes.body(static_cast<std::size_t>(i / 3), BodyField::Ux + static_cast<int>(i % 3));
        return u;
    }
    double speedAfter(KernelNumbers& lanes, std::size_t row) const {
        return rows.row(static_cast<Eigen::Index>(row)).dot(after(lanes));
    }
    /// Of u = M^-1 J^T L, as a share of the largest.
    double velocityError(KernelNumbers& lanes) const {
        Eigen::VectorXd impulses(rows.rows());
        for (Eigen::Index r = 0; r < rows.rows(); ++r)
            impulses[r] = lanes.row(static_cast<std::size_t>(r), RowField::Impulse);
        const Eigen::VectorXd changes = inverseMass.cwiseProduct(rows.transpose() * impulses);
        return (after(lanes) - before - changes).cwiseAbs().maxCoeff() / (1 + impulses.cwiseAbs().maxCoeff());
    }
    double inverseMassOf(Eigen::Index row) const { return rows.row(row).cwiseAbs2().dot(inverseMass.transpose()); }

private:
    void addPart(KernelNumbers& lanes, std::size_t i, std::uint32_t part) {
        const IslandLayout::Link& link = lanes.layout().links[lanes.layout().rows[i].link + part];
        const int axis = part == 0 ? RowField::AxisX : RowField::SecondAxisX;
        const auto r = static_cast<Eigen::Index>(i);
        const double x = lanes.row(i, axis), y = lanes.row(i, axis + 1);
        const Eigen::RowVector3d a(-x, -y, lanes.row(i, axis + 2)), b(x, y, lanes.row(i, axis + 3));
        rows.block<1, 3>(r, 3 * link.a) += a;
        rows.block<1, 3>(r, 3 * link.b) += b;
    }
};

}  // namespace plumb::test
