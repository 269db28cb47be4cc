// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_sweep.h>

#include <algorithm>

#include <plumb/dynamics/joints/joint_curve.h>
#include <plumb/dynamics/joints/joint_response.h>

namespace plumb {

namespace {

void push(const JointRows& rows, std::size_t row, double impulse, BodyStore& bodies) {
    for (std::size_t e = 0; e < rows.ends; ++e) {
        if (bodies.velocity[rows.body[e]].inverseMass == 0) continue;
        Vec3 v = velocityOf(bodies, rows.body[e]);
        add(v, velocityChangeBy(bodies, rows.body[e], times(rows.at(row, e), impulse)));
        setVelocity(bodies, rows.body[e], v);
    }
}

/// Solves all rows that hold together.
void sweepHolding(JointRecord& record, const JointRows& rows, BodyStore& bodies, const Softness& soft) {
    Mat3 k;
    Vec3 missingSpeed{};
    for (std::size_t r = 0; r < maxRows; ++r) {
        k[r][r] = 1;
        if (r >= rows.count || !rows.row[r].holds) continue;
        missingSpeed[r] = rows.row[r].target - speedOf(rows, r, bodies);
        k[r][r] = effectiveInverseMass(bodies, rows, r) * (1 + relativeCompliance);
        for (std::size_t c = 0; c < r; ++c) {
            if (!rows.row[c].holds) continue;
            double sum = 0;
            for (std::size_t e = 0; e < rows.ends; ++e)
                sum += dot(rows.at(c, e), velocityChangeBy(bodies, rows.body[e], rows.at(r, e)));
            k[r][c] = k[c][r] = sum;
        }
    }
    const Vec3 change = symmetricInverse(k) * missingSpeed;
    for (std::size_t r = 0; r < rows.count; ++r) {
        if (!rows.row[r].holds) continue;
        const double added = change[r] * static_cast<double>(soft.massScale) -
                             record.impulse[r] * static_cast<double>(soft.impulseScale);
        record.impulse[r] += added;
        push(rows, r, added, bodies);
    }
}

/// The impulse L at which the row's curve meets the line v + w (L - old), the speed that its own impulse gives it.
double impulseOnCurve(const JointRow& row, double v, double old, double w) {
    const double slope = slopeOf(row, w);
    const auto onSlope = [&](double bound) { return (row.push + bound - slope * (v - w * old)) / (1 + slope * w); };
    if (row.bounded) return std::clamp(onSlope(0), row.low, row.high);
    const double at = std::clamp(old - (v - row.target) / w, onSlope(row.low), onSlope(row.high));
    return std::min(std::max(at, old - (v - row.lowerStop) / w), old - (v - row.upperStop) / w);
}

/// Applies the impulse of the previous half sub-step as a first guess. Then solves the driven and limited rows one by
/// one, and after them all rows that hold together.
void sweepJoint(JointRecord& record, JointLoad& load, const JointRows& rows, BodyStore& bodies, const Softness& soft) {
    for (std::size_t r = 0; r < rows.count; ++r) push(rows, r, record.impulse[r], bodies);
    for (std::size_t r = 0; r < rows.count; ++r) {
        const JointRow& row = rows.row[r];
        const double w = effectiveInverseMass(bodies, rows, r);
        if (row.holds || !(w > 0)) continue;
        const double old = record.impulse[r];
        const double now = impulseOnCurve(row, speedOf(rows, r, bodies), old, w);
        record.impulse[r] = now;
        push(rows, r, now - old, bodies);
    }
    sweepHolding(record, rows, bodies, soft);
    addLoad(load, rows, record.impulse);
}

Vec3 speedsOf(const JointRows& rows, const BodyStore& bodies) {
    Vec3 speeds{};
    for (std::size_t r = 0; r < rows.count; ++r) speeds[r] = speedOf(rows, r, bodies);
    return speeds;
}

}  // namespace

void sweepIsland(JointIsland& island, JointStore& joints, BodyStore& bodies, const SweepPass& pass) {
    island.hinges.solve(*pass.hingeSolver, bodies.solverBodies(), pass.hinges);
    JointRows rows;
    for (const JointIndex index : island.others) {
        joints.addRows(index, bodies, pass.joints, rows);
        sweepJoint(joints[index], joints.loads[index], rows, bodies, pass.hinges.soft);
        if (pass.observer == nullptr) continue;
        Vec3 slopes{};
        for (std::size_t r = 0; r < rows.count; ++r)
            slopes[r] = slopeOf(rows.row[r], effectiveInverseMass(bodies, rows, r));
        pass.observer->noteRows(rows, joints[index].impulse, speedsOf(rows, bodies), slopes);
    }
}

}  // namespace plumb
