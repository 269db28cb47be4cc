// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/joint_net.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/detail/joint_answer.h>
#include <plumb/dynamics/detail/joint_curve.h>
#include <plumb/dynamics/detail/joint_sweep.h>

namespace plumb {

namespace {

/// A line's stiffness is forgotten in so long [s].
constexpr double memory = 2;

/// Rows that change their state after this many turns stay as they are until the next pass.
constexpr int mostTurns = 8;

/// One pass over one net.
class Pass {
public:
    Pass(JointNet& net, JointStore& joints, BodyStore& bodies, const JointPass& pass)
        : net_(net), joints_(joints), bodies_(bodies), impulses_(net.joints.size()) {
        rows_.reserve(net.joints.size());
        for (const JointIndex index : net.joints) {
            rows_.push_back(joints.rowsOf(index, bodies, pass));
            yields_.emplace_back();
            states_.push_back(joints[index].states);
            for (std::size_t r = 0; r < rows_.back().count; ++r) {
                JointRow& row = rows_.back().row[r];
                yields_.back()[r] = yieldOf(bodies, rows_.back(), row);
                if (pass.onlyHold) giveNothing(row);
                if (pass.correct) dampAhead(row, yields_.back()[r], joints[index].speeds[r]);
                if (!row.holds) states_.back()[r] = soundState(row, states_.back()[r]);
            }
        }
        before_.reserve(net.bodies.size());
        for (const BodyIndex body : net.bodies) before_.push_back(velocityOf(bodies, body));
        step_ = pass.step;
        stiffnessBefore_ = net.stiffness;
        findMasses();
    }

    void run(Audit* audit, bool remember) {
        for (int turn = 0; turn < mostTurns; ++turn) {
            solve();
            if (!changeStates()) break;
        }
        if (audit != nullptr) tell(*audit);
        if (remember) noteStates();
        for (std::size_t b = 0; b < net_.bodies.size(); ++b) setVelocity(bodies_, net_.bodies[b], after_[b]);
        for (std::size_t j = 0; j < rows_.size(); ++j) addLoad(joints_.loads[net_.joints[j]], rows_[j], impulses_[j]);
        findStiffness();
        for (std::size_t b = 0; b < net_.bodies.size(); ++b) slow(bodies_.record[net_.bodies[b]], needed_[b]);
    }

    /// Not what the rows want, but that what they hold goes on as it does.
    void push(BodyIndex body, const Vec3& impulse) {
        after_ = before_;
        const auto at = std::find(net_.bodies.begin(), net_.bodies.end(), body);
        const auto node = static_cast<std::uint32_t>(at - net_.bodies.begin());
        add(after_[node], answerOf(node, impulse));
        for (std::size_t j = 0; j < rows_.size(); ++j) {
            for (std::size_t r = 0; r < rows_[j].count; ++r) {
                JointRow& row = rows_[j].row[r];
                const double speed = speedOf(j, r, before_);
                if (row.holds)
                    row.target = speed;
                else
                    row = free(row, speed, stateOf(j, r));
            }
        }
        solveFor();
        for (std::size_t b = 0; b < net_.bodies.size(); ++b) setVelocity(bodies_, net_.bodies[b], after_[b]);
        for (std::size_t j = 0; j < rows_.size(); ++j) addLoad(joints_.loads[net_.joints[j]], rows_[j], impulses_[j]);
    }

private:
    void noteStates() const {
        for (std::size_t j = 0; j < states_.size(); ++j) joints_[net_.joints[j]].states = states_[j];
    }

    /// A row at its stop stays there; another gives nothing more.
    static JointRow free(JointRow row, double speed, RowState state) {
        row.low = row.high = row.push = row.damper = 0;
        row.bounded = !isStop(state);
        if (isStop(state)) row.lowerStop = row.upperStop = row.target = speed;
        return row;
    }

    void tell(Audit& audit) const {
        for (std::size_t j = 0; j < rows_.size(); ++j) {
            Vec3 before{}, after{}, slopes{};
            for (std::size_t r = 0; r < rows_[j].count; ++r) {
                before[r] = speedOf(j, r, before_);
                after[r] = speedOf(j, r, after_);
                slopes[r] = slopeOf(rows_[j].row[r], yields_[j][r]);
            }
            audit.noteRows(bodies_, rows_[j], impulses_[j], before, after, slopes);
        }
    }

    /// From the next step on, contacts see a body as heavy to turn as its joints do: else they would feed it.
    static void slow(BodyRecord& record, double inertia) {
        if (record.inverseInertia > 0) setRho(record, 1 / std::max(record.inertia, inertia));
    }

    /// Of each body, as the step has them; what swings along x and y weighs no less than its stiffness needs.
    void findMasses() {
        masses_.reserve(net_.bodies.size());
        for (std::size_t b = 0; b < net_.bodies.size(); ++b) {
            const double mass = 1 / static_cast<double>(bodies_.velocity[net_.bodies[b]].inverseMass);
            const double rho = static_cast<double>(bodies_.turn[net_.bodies[b]].rho);
            const Vec3 needed = times(net_.stiffness[b], step_ * step_);
            const double linear = std::max({mass, needed[0], needed[1]});
            masses_.push_back({linear, linear, rho > 0 ? mass / (rho * rho) : 0.0});
        }
    }

    /// Inertia for those that are pulled back faster than can be followed, from the next step on.
    void findNeeded() {
        needed_.assign(masses_.size(), 0.0);
        bool tight = false;
        for (std::size_t b = 0; b < masses_.size(); ++b) {
            needed_[b] = 2 * net_.stiffness[b][2] * step_ * step_;
            tight = tight || needed_[b] > bodies_.record[net_.bodies[b]].inertia;
        }
        if (!tight) return;
        const std::vector<double> company = companyOf();
        for (std::size_t b = 0; b < masses_.size(); ++b) needed_[b] -= company[b];
    }

    /// For each body, the least by which its neighbours, each free but for it, add to its inertia when it turns:
    /// sum m' r^2 - |sum m' r|^2 / (m + sum m'), m' what a neighbour weighs at the anchor at r, whichever way.
    std::vector<double> companyOf() const {
        struct Company {
            double mass = 0, squares = 0;
            Vec2 moment{0, 0};
        };
        std::vector<Company> company(masses_.size());
        for (std::size_t j = 0; j < rows_.size(); ++j) {
            if (!rows_[j].holdsPoint) continue;
            const auto& nodes = net_.seats[j].node;
            for (std::size_t e = 0; e < 2; ++e) {
                if (nodes[e] == JointNet::Seats::fixed) continue;
                const double weight = weightOf(nodes[1 - e], rows_[j].arm[1 - e], masses_[nodes[e]][0]);
                Company& c = company[nodes[e]];
                c.mass += weight;
                c.moment += weight * rows_[j].arm[e];
                c.squares += weight * rows_[j].arm[e].squaredNorm();
            }
        }
        std::vector<double> added(masses_.size());
        for (std::size_t b = 0; b < added.size(); ++b)
            added[b] = company[b].squares - company[b].moment.squaredNorm() / (masses_[b][0] + company[b].mass);
        return added;
    }

    /// What does not move weighs a million times what hangs on it.
    double weightOf(std::uint32_t node, const Vec2& arm, double hanging) const {
        if (node == JointNet::Seats::fixed) return 1e6 * hanging;
        const double turning = masses_[node][2] > 0 ? arm.squaredNorm() / masses_[node][2] : 0.0;
        return 1 / (1 / masses_[node][0] + turning);
    }

    /// By the forces of this pass.
    void findStiffness() {
        // It falls slowly: one that follows the forces' every turn pumps up what swings (tried).
        std::vector<Vec3> fresh(net_.stiffness.size());
        const double rate = 2 / step_;  // impulses are of half a sub-step
        for (std::size_t j = 0; j < rows_.size(); ++j) {
            for (std::size_t e = 0; e < 2; ++e) {
                const std::uint32_t node = net_.seats[j].node[e];
                if (node == JointNet::Seats::fixed) continue;
                Vec2 force(0, 0);
                for (std::size_t r = 0; r < rows_[j].count; ++r)
                    force += Vec2(rows_[j].row[r].at[e][0], rows_[j].row[r].at[e][1]) * (impulses_[j][r] * rate);
                fresh[node][2] += force.dot(rows_[j].arm[e]);
                if (!(rows_[j].length > 0)) continue;
                for (std::size_t i = 0; i < 2; ++i) fresh[node][i] += 2 * force.norm() / rows_[j].length;
            }
        }
        const double kept = 1 - std::min(0.5 * step_ / memory, 1.0);
        for (std::size_t b = 0; b < fresh.size(); ++b)
            for (std::size_t i = 0; i < 3; ++i)
                net_.stiffness[b][i] = std::max(fresh[b][i], kept * stiffnessBefore_[b][i]);
        findNeeded();
    }

    /// What a body of the net answers an impulse of (x, y, turn) with.
    Vec3 answerOf(std::uint32_t node, const Vec3& impulse) const {
        const Vec3& mass = masses_[node];
        return {impulse[0] / mass[0], impulse[1] / mass[1], mass[2] > 0 ? impulse[2] / mass[2] : 0.0};
    }

    RowState stateOf(std::size_t j, std::size_t r) const { return states_[j][r]; }
    Wish wish(std::size_t j, std::size_t r) const { return wishOf(rows_[j].row[r], stateOf(j, r), yields_[j][r]); }

    double speedOf(std::size_t j, std::size_t r, const std::vector<Vec3>& velocities) const {
        double speed = 0;
        for (std::size_t e = 0; e < rows_[j].ends; ++e) {
            const std::uint32_t node = net_.seats[j].node[e];
            const Vec3 v = node != JointNet::Seats::fixed ? velocities[node] : velocityOf(bodies_, rows_[j].body[e]);
            speed += dot(rows_[j].row[r].at[e], v);
        }
        return speed;
    }

    /// To the velocities, what rows give whose impulse is known.
    void giveKnown() {
        after_ = before_;
        for (std::size_t j = 0; j < rows_.size(); ++j) {
            for (std::size_t r = 0; r < rows_[j].count; ++r) {
                const Wish known = wish(j, r);
                if (!known.known) continue;
                const JointRow& row = rows_[j].row[r];
                const double impulse = known.impulse;
                impulses_[j][r] = impulse;
                if (impulse == 0) continue;
                for (std::size_t e = 0; e < rows_[j].ends; ++e) {
                    const std::uint32_t node = net_.seats[j].node[e];
                    if (node == JointNet::Seats::fixed) continue;
                    add(after_[node], answerOf(node, times(row.at[e], impulse)));
                }
            }
        }
    }

    void fillBodies() {
        for (std::size_t b = 0; b < net_.bodies.size(); ++b) {
            Mat3& m = net_.solver.diagonal(static_cast<std::uint32_t>(b));
            for (std::size_t i = 0; i < 3; ++i) m[i][i] = masses_[b][i] > 0 ? masses_[b][i] : 1;
        }
    }

    void fillJoint(std::size_t j) {
        const JointRows& rows = rows_[j];
        const std::uint32_t node = static_cast<std::uint32_t>(net_.bodies.size() + j);
        Vec3& right = answer_[node];
        Mat3& diagonal = net_.solver.diagonal(node);
        std::array<Mat3, mostEnds> blocks;
        for (std::size_t r = 0; r < mostRows; ++r) {
            diagonal[r][r] = -1;
            right[r] = 0;
            if (r >= rows.count || !(yields_[j][r] > 0)) continue;  // nothing that it could move
            const Wish wanted = wish(j, r);
            if (wanted.known) continue;
            const JointRow& row = rows.row[r];
            diagonal[r][r] = -wanted.give;
            right[r] = speedOf(j, r, after_) - wanted.speed;
            for (std::size_t e = 0; e < rows.ends; ++e) blocks[e][r] = times(row.at[e], -1);
        }
        for (std::size_t e = 0; e < rows.ends; ++e) {
            if (net_.seats[j].node[e] == JointNet::Seats::fixed) continue;
            if (masses_[net_.seats[j].node[e]][2] == 0)  // nothing turns it
                for (std::size_t r = 0; r < mostRows; ++r) blocks[e][r][2] = 0;
            net_.solver.add(net_.seats[j].edge[e], blocks[e]);
        }
    }

    void solve() {
        giveKnown();
        solveFor();
    }

    /// What takes after_ to where the rows want it.
    void solveFor() {
        answer_.assign(net_.bodies.size() + rows_.size(), Vec3{});
        net_.solver.clear();
        fillBodies();
        for (std::size_t j = 0; j < rows_.size(); ++j) fillJoint(j);
        net_.solver.factor();
        net_.solver.solve(answer_);
        for (std::size_t b = 0; b < net_.bodies.size(); ++b) add(after_[b], answer_[b]);
        for (std::size_t j = 0; j < rows_.size(); ++j)
            for (std::size_t r = 0; r < rows_[j].count; ++r)
                if (!wish(j, r).known) impulses_[j][r] = answer_[net_.bodies.size() + j][r];
    }

    bool changeStates() {
        bool changed = false;
        for (std::size_t j = 0; j < rows_.size(); ++j) {
            for (std::size_t r = 0; r < rows_[j].count; ++r) {
                const JointRow& row = rows_[j].row[r];
                if (row.holds) continue;
                RowState& state = states_[j][r];
                const RowState next = nextState(row, state, speedOf(j, r, after_), impulses_[j][r], yields_[j][r]);
                changed = changed || next != state;
                state = next;
            }
        }
        return changed;
    }

    JointNet& net_;
    JointStore& joints_;
    BodyStore& bodies_;
    std::vector<JointRows> rows_;                         ///< of the joints
    std::vector<std::array<RowState, mostRows>> states_;  ///< of the rows
    std::vector<Vec3> yields_;                            ///< what a unit impulse of theirs does to the rows' speeds
    std::vector<Vec3> impulses_;                          ///< of the rows
    double step_ = 0;
    std::vector<Vec3> stiffnessBefore_;
    std::vector<double> needed_;        ///< inertia of the bodies, for what they are pulled back by [kg m^2]
    std::vector<Vec3> masses_;          ///< of the bodies: along x, y, turning; 0: nothing turns it
    std::vector<Vec3> before_, after_;  ///< velocities of the bodies
    std::vector<Vec3> answer_;
};

Vec3 speedsOf(const JointRows& rows, const BodyStore& bodies) {
    Vec3 speeds{};
    for (std::size_t r = 0; r < rows.count; ++r) speeds[r] = speedOf(rows, rows.row[r], bodies);
    return speeds;
}

}  // namespace

void solveNet(JointNet& net, JointStore& joints, BodyStore& bodies, const NetPass& pass) {
    if (net.direct) {
        Pass(net, joints, bodies, pass.direct).run(pass.audit, true);
        return;
    }
    net.hinges.solve(*pass.hingeSolver, bodies.solverBodies(), pass.hinges);
    for (const JointIndex index : net.others) {
        const JointRows rows = joints.rowsOf(index, bodies, pass.swept);
        const Vec3 before = speedsOf(rows, bodies);
        sweepJoint(joints[index], joints.loads[index], rows, bodies, pass.hinges.soft);
        if (pass.audit == nullptr) continue;
        Vec3 slopes{};
        for (std::size_t r = 0; r < rows.count; ++r)
            slopes[r] = slopeOf(rows.row[r], yieldOf(bodies, rows, rows.row[r]));
        pass.audit->noteRows(bodies, rows, joints[index].impulse, before, speedsOf(rows, bodies), slopes);
    }
}

void holdNet(JointNet& net, JointStore& joints, BodyStore& bodies, JointPass pass, Audit* audit) {
    // Once more, if the first time has changed the turning by so much that what it foresaw is not what will be.
    constexpr double far = 0.02;
    pass.onlyHold = true;
    for (int time = 0; time < 3; ++time) {
        std::vector<float> before;
        for (const BodyIndex body : net.bodies) before.push_back(bodies.velocity[body].w);
        Pass(net, joints, bodies, pass).run(audit, false);
        bool changed = false;
        for (std::size_t b = 0; b < net.bodies.size(); ++b) {
            const float turn = (bodies.velocity[net.bodies[b]].w - before[b]) * bodies.turn[net.bodies[b]].rho;
            changed = changed || std::fabs(static_cast<double>(turn)) * pass.step > far;
        }
        if (!changed) return;
    }
}

void pushNet(JointNet& net, JointStore& joints, BodyStore& bodies, BodyIndex body, const Vec3& impulse, double h) {
    Pass(net, joints, bodies, {h, false, 0, 0}).push(body, impulse);
}

}  // namespace plumb
