// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/solve_island.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/joints/geometric_stiffness.h>
#include <plumb/dynamics/joints/joint_curve.h>
#include <plumb/dynamics/joints/joint_response.h>
#include <plumb/dynamics/joints/joint_sweep.h>

namespace plumb {

namespace {

/// After this number of iterations, rows keep their states until the next pass.
constexpr int mostTurns = 8;

constexpr double notSolved = -1;  ///< the compliance noted for a row that is not in the matrix

bool sameDirections(const JointRows& a, const JointRows& b) {
    if (a.count != b.count || a.far != b.far) return false;
    for (std::size_t r = 0; r < a.count; ++r)
        if (a.row[r].at != b.row[r].at) return false;
    return true;
}

/// One pass over one island.
class IslandSolution {
public:
    IslandSolution(JointIsland& island, JointStore& joints, BodyStore& bodies, const JointPass& pass)
        : IslandSolution(island, joints, bodies, pass.step) {
        findRows(pass);
        work_.before.resize(island.bodies.size());
        for (std::size_t b = 0; b < island.bodies.size(); ++b) work_.before[b] = velocityOf(bodies, island.bodies[b]);
        findMasses(island, bodies, step_);
        same_ = same_ && work_.masses == work_.massesBefore;
    }
    /// The last solution again, to accept it.
    IslandSolution(JointIsland& island, JointStore& joints, BodyStore& bodies, double step)
        : island_(island), work_(island.work), joints_(joints), bodies_(bodies), step_(step) {}

    void run(StepObserver* observer, bool remember) {
        findImpulses();
        if (remember) noteStates();
        storeVelocities();
        accept(observer);
    }

    /// Returns true if a row came to another part of its curve.
    bool tryFrom(const std::vector<Vec3>& before) {
        work_.before = before;
        const bool changed = findImpulses();
        noteStates();
        storeVelocities();
        return changed;
    }

    void accept(StepObserver* observer) {
        if (observer != nullptr) report(*observer);
        storeLoads();
        noteStiffness(island_, bodies_, step_);
    }

    void push(BodyIndex body, const Vec3& impulse) {
        answer(body, impulse);
        storeVelocities();
        storeLoads();
    }

    /// Solves for an additional impulse: held rows keep their present speeds instead of their targets. Returns by how
    /// much the body's velocity changes.
    Vec3 answer(BodyIndex body, const Vec3& impulse) {
        work_.after = work_.before;
        const auto at = std::find(island_.bodies.begin(), island_.bodies.end(), body);
        const auto node = static_cast<std::uint32_t>(at - island_.bodies.begin());
        add(work_.after[node], velocityChangeBy(node, impulse));
        for (std::size_t j = 0; j < work_.rows.size(); ++j) {
            const Vec3 speeds = speedsOf(j, work_.before);
            for (std::size_t r = 0; r < work_.rows[j].count; ++r) {
                JointRow& row = work_.rows[j].row[r];
                if (row.holds)
                    row.target = speeds[r];
                else
                    row = free(row, speeds[r], work_.states[j][r]);
            }
        }
        findEquations();
        solve();
        Vec3 change = work_.after[node];
        for (std::size_t i = 0; i < change.size(); ++i) change[i] -= work_.before[node][i];
        return change;
    }

private:
    bool findImpulses() {
        bool changed = false;
        for (int turn = 0; turn < mostTurns; ++turn) {
            findEquations();
            applyKnownImpulses();
            solve();
            if (!changeStates()) break;
            changed = true;
        }
        return changed;
    }

    void findRows(const JointPass& pass) {
        const std::size_t count = island_.joints.size();
        std::swap(work_.rows, work_.rowsBefore);
        same_ = work_.rowsBefore.size() == count && work_.compliances.size() == count;
        work_.rows.resize(count);
        work_.states.resize(count);
        work_.equations.resize(count);
        work_.inverseMasses.resize(count);
        work_.impulses.assign(count, Vec3{});
        for (std::size_t j = 0; j < count; ++j) {
            const JointRecord& record = joints_[island_.joints[j]];
            JointRows& rows = work_.rows[j];
            joints_.addRows(island_.joints[j], bodies_, pass, rows);
            work_.states[j] = record.states;
            for (std::size_t r = 0; r < rows.count; ++r) {
                JointRow& row = rows.row[r];
                work_.inverseMasses[j][r] = effectiveInverseMass(bodies_, rows, r);
                if (row.holds) continue;
                if (pass.onlyHold) dropDrive(row);
                if (pass.correct) dampAhead(row, work_.inverseMasses[j][r], record.speeds[r]);
                work_.states[j][r] = validState(row, work_.states[j][r]);
            }
            same_ = same_ && sameDirections(rows, work_.rowsBefore[j]);
        }
    }

    void noteStates() const {
        for (std::size_t j = 0; j < work_.states.size(); ++j) joints_[island_.joints[j]].states = work_.states[j];
    }

    void storeVelocities() {
        for (std::size_t b = 0; b < island_.bodies.size(); ++b) setVelocity(bodies_, island_.bodies[b], work_.after[b]);
    }

    void storeLoads() {
        for (std::size_t j = 0; j < work_.rows.size(); ++j)
            addLoad(joints_.loads[island_.joints[j]], work_.rows[j], work_.impulses[j]);
    }

    /// A row at its stop keeps its speed; any other row gives no impulse.
    static JointRow free(JointRow row, double speed, RowState state) {
        row.low = row.high = row.push = row.damper = 0;
        row.bounded = !isStop(state);
        if (isStop(state)) row.lowerStop = row.upperStop = row.target = speed;
        return row;
    }

    void report(StepObserver& observer) const {
        for (std::size_t j = 0; j < work_.rows.size(); ++j) {
            Vec3 slopes{};
            for (std::size_t r = 0; r < work_.rows[j].count; ++r)
                slopes[r] = slopeOf(work_.rows[j].row[r], work_.inverseMasses[j][r]);
            observer.noteRows(work_.rows[j], work_.impulses[j], speedsOf(j, work_.after), slopes);
        }
    }

    /// The change of velocity of a body of the island by an impulse (x, y, turn).
    Vec3 velocityChangeBy(std::uint32_t node, const Vec3& impulse) const {
        const Vec3& mass = work_.masses[node];
        return {impulse[0] / mass[0], impulse[1] / mass[1], mass[2] > 0 ? impulse[2] / mass[2] : 0.0};
    }

    /// The speeds of a joint's rows.
    Vec3 speedsOf(std::size_t j, const std::vector<Vec3>& velocities) const {
        const JointRows& rows = work_.rows[j];
        Vec3 speeds{};
        for (std::size_t e = 0; e < rows.ends; ++e) {
            const std::uint32_t node = island_.endNodes[j].node[e];
            const Vec3 v = node != JointIsland::EndNodes::fixed ? velocities[node] : velocityOf(bodies_, rows.body[e]);
            for (std::size_t r = 0; r < rows.count; ++r) speeds[r] += dot(rows.at(r, e), v);
        }
        return speeds;
    }

    void findEquations() {
        work_.compliances.resize(work_.rows.size());
        for (std::size_t j = 0; j < work_.rows.size(); ++j) {
            const JointRows& rows = work_.rows[j];
            for (std::size_t r = 0; r < rows.count; ++r) {
                const RowEquation& equation = work_.equations[j][r] =
                    equationOf(rows.row[r], work_.states[j][r], work_.inverseMasses[j][r]);
                const bool solved =
                    !equation.known && work_.inverseMasses[j][r] > 0;  // else the row cannot move anything
                const double compliance = solved ? equation.compliance : notSolved;
                same_ = same_ && compliance == work_.compliances[j][r];
                work_.compliances[j][r] = compliance;
            }
        }
    }

    /// Adds the known impulses of rows to the velocities.
    void applyKnownImpulses() {
        work_.after = work_.before;
        for (std::size_t j = 0; j < work_.rows.size(); ++j) {
            const JointRows& rows = work_.rows[j];
            for (std::size_t r = 0; r < rows.count; ++r) {
                const RowEquation& equation = work_.equations[j][r];
                if (!equation.known) continue;
                work_.impulses[j][r] = equation.impulse;
                if (equation.impulse == 0) continue;
                for (std::size_t e = 0; e < rows.ends; ++e) {
                    const std::uint32_t node = island_.endNodes[j].node[e];
                    if (node == JointIsland::EndNodes::fixed) continue;
                    add(work_.after[node], velocityChangeBy(node, times(rows.at(r, e), equation.impulse)));
                }
            }
        }
    }

    /// Finds the impulses and changes of velocity with which the rows fulfil their equations.
    void solve() {
        if (!same_) factor();
        same_ = true;
        const std::size_t bodies = island_.bodies.size();
        work_.answer.assign(bodies + work_.rows.size(), Vec3{});
        for (std::size_t j = 0; j < work_.rows.size(); ++j) {
            const Vec3 speeds = speedsOf(j, work_.after);
            for (std::size_t r = 0; r < work_.rows[j].count; ++r)
                if (work_.compliances[j][r] != notSolved)
                    work_.answer[bodies + j][r] = speeds[r] - work_.equations[j][r].speed;
        }
        island_.solver.solve(work_.answer);
        for (std::size_t b = 0; b < bodies; ++b) add(work_.after[b], work_.answer[b]);
        for (std::size_t j = 0; j < work_.rows.size(); ++j)
            for (std::size_t r = 0; r < work_.rows[j].count; ++r)
                if (!work_.equations[j][r].known) work_.impulses[j][r] = work_.answer[bodies + j][r];
    }

    void factor() {
        island_.solver.clear();
        for (std::size_t b = 0; b < island_.bodies.size(); ++b) {
            Mat3& m = island_.solver.diagonal(static_cast<std::uint32_t>(b));
            for (std::size_t i = 0; i < 3; ++i) m[i][i] = work_.masses[b][i] > 0 ? work_.masses[b][i] : 1;
        }
        for (std::size_t j = 0; j < work_.rows.size(); ++j) fillJoint(j);
        island_.solver.factor();
        work_.massesBefore = work_.masses;
    }

    void fillJoint(std::size_t j) {
        const JointRows& rows = work_.rows[j];
        Mat3& diagonal = island_.solver.diagonal(static_cast<std::uint32_t>(island_.bodies.size() + j));
        for (std::size_t r = 0; r < maxRows; ++r) {
            const bool solved = r < rows.count && work_.compliances[j][r] != notSolved;
            diagonal[r][r] = solved ? -work_.compliances[j][r] : -1;
        }
        for (std::size_t e = 0; e < rows.ends; ++e) {
            const std::uint32_t node = island_.endNodes[j].node[e];
            if (node == JointIsland::EndNodes::fixed) continue;
            Mat3 block;
            for (std::size_t r = 0; r < rows.count; ++r) {
                if (work_.compliances[j][r] == notSolved) continue;
                block[r] = times(rows.at(r, e), -1);
                if (work_.masses[node][2] == 0) block[r][2] = 0;  // it cannot turn
            }
            island_.solver.add(island_.endNodes[j].edge[e], block);
        }
    }

    bool changeStates() {
        bool changed = false;
        for (std::size_t j = 0; j < work_.rows.size(); ++j) {
            const JointRows& rows = work_.rows[j];
            if (rows.allHold()) continue;
            const Vec3 speeds = speedsOf(j, work_.after);
            for (std::size_t r = 0; r < rows.count; ++r) {
                if (rows.row[r].holds) continue;
                RowState& state = work_.states[j][r];
                const RowState next =
                    nextState(rows.row[r], state, speeds[r], work_.impulses[j][r], work_.inverseMasses[j][r]);
                changed = changed || next != state;
                state = next;
            }
        }
        return changed;
    }

    JointIsland& island_;
    IslandWork& work_;
    JointStore& joints_;
    BodyStore& bodies_;
    double step_ = 0;
    bool same_ = false;  ///< the matrix is the one that was factored last
};

Vec3 speedsOf(const JointRows& rows, const BodyStore& bodies) {
    Vec3 speeds{};
    for (std::size_t r = 0; r < rows.count; ++r) speeds[r] = speedOf(rows, r, bodies);
    return speeds;
}

}  // namespace

void solveIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, const IslandPass& pass) {
    if (island.direct) {
        IslandSolution(island, joints, bodies, pass.direct).run(pass.observer, true);
        return;
    }
    island.hinges.solve(*pass.hingeSolver, bodies.solverBodies(), pass.hinges);
    JointRows rows;
    for (const JointIndex index : island.others) {
        joints.addRows(index, bodies, pass.swept, rows);
        sweepJoint(joints[index], joints.loads[index], rows, bodies, pass.hinges.soft);
        if (pass.observer == nullptr) continue;
        Vec3 slopes{};
        for (std::size_t r = 0; r < rows.count; ++r)
            slopes[r] = slopeOf(rows.row[r], effectiveInverseMass(bodies, rows, r));
        pass.observer->noteRows(rows, joints[index].impulse, speedsOf(rows, bodies), slopes);
    }
}

void holdIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, JointPass pass, StepObserver* observer) {
    // Repeated if a pass has changed an angular velocity so much that its prediction of the ends is no longer valid.
    constexpr double far = 0.02;
    pass.onlyHold = true;
    for (int time = 0; time < 3; ++time) {
        std::vector<float> before;
        for (const BodyIndex body : island.bodies) before.push_back(bodies.velocity[body].w);
        IslandSolution(island, joints, bodies, pass).run(observer, false);
        bool changed = false;
        for (std::size_t b = 0; b < island.bodies.size(); ++b) {
            const float turn =
                (bodies.velocity[island.bodies[b]].w - before[b]) * bodies.turn[island.bodies[b]].inverseGyration;
            changed = changed || std::fabs(static_cast<double>(turn)) * pass.step > far;
        }
        if (!changed) return;
    }
}

bool tryIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, const std::vector<Vec3>& before,
               const JointPass& pass) {
    return IslandSolution(island, joints, bodies, pass).tryFrom(before);
}

void acceptIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, double h, StepObserver* observer) {
    IslandSolution(island, joints, bodies, h).accept(observer);
}

void followJoints(const JointIsland& island, std::span<Vec3> changes) {
    const IslandWork& work = island.work;
    const std::size_t bodies = island.bodies.size();
    std::vector<Vec3> answer(bodies + work.rows.size(), Vec3{});
    for (std::size_t j = 0; j < work.rows.size(); ++j) {
        const JointRows& rows = work.rows[j];
        for (std::size_t e = 0; e < rows.ends; ++e) {
            const std::uint32_t node = island.endNodes[j].node[e];
            if (node == JointIsland::EndNodes::fixed || changes[node] == Vec3{}) continue;
            for (std::size_t r = 0; r < rows.count; ++r)
                if (work.compliances[j][r] != notSolved) answer[bodies + j][r] += dot(rows.at(r, e), changes[node]);
        }
    }
    island.solver.solve(answer);
    for (std::size_t b = 0; b < bodies; ++b) add(changes[b], answer[b]);
}

void pushIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, BodyIndex body, const Vec3& impulse,
                double h) {
    IslandSolution(island, joints, bodies, {h, false, 0, 0}).push(body, impulse);
}

Vec3 answerOfIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, BodyIndex body, const Vec3& impulse,
                    double h) {
    return IslandSolution(island, joints, bodies, {h, false, 0, 0}).answer(body, impulse);
}

}  // namespace plumb
