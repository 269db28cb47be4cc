// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_rows.h>

#include <algorithm>

namespace plumb {

namespace {

/// A new row holds by default. This turns it into a row that does nothing, before a spring or limit is set.
void release(JointRow& row) {
    if (row.holds) row.low = row.high = row.target = 0;
    row.holds = false;
}

}  // namespace

double boundOf(double force) {
    constexpr double most = 1e40;
    return force < most ? force : unlimited;
}

JointRow rowAlong(const Vec2& axis, const Ends& ends) {
    JointRow row;
    const Vec2 fromA = ends.a.arm + ends.apart();
    row.at[0] = {-axis.x(), -axis.y(), -cross(fromA, axis)};
    row.at[1] = {axis.x(), axis.y(), cross(ends.b.arm, axis)};
    return row;
}

JointRow rowTurning() {
    JointRow row;
    row.at[0] = {0, 0, -1};
    row.at[1] = {0, 0, 1};
    return row;
}

double speedOf(const JointRow& row, const Ends& ends) {
    const auto part = [](const Vec3& at, const End& end) {
        return at[0] * end.velocity.x() + at[1] * end.velocity.y() + at[2] * end.spin;
    };
    return part(row.at[0], ends.a) + part(row.at[1], ends.b);
}

double speedAhead(const JointRow& row, const Ends& ends, double h) {
    Ends slower = ends;
    slower.a.spin = spinAhead(ends.a, h);
    slower.b.spin = spinAhead(ends.b, h);
    return speedOf(row, slower);
}

double speedOf(const JointRows& rows, std::size_t row, const BodyStore& bodies) {
    double speed = 0;
    for (std::size_t e = 0; e < rows.ends; ++e) {
        const Vec3& at = rows.at(row, e);
        const SolverVelocity& v = bodies.velocity[rows.body[e]];
        const double spin = static_cast<double>(v.w) * static_cast<double>(bodies.turn[rows.body[e]].inverseGyration);
        speed += at[0] * static_cast<double>(v.x) + at[1] * static_cast<double>(v.y) + at[2] * spin;
    }
    return speed;
}

void start(JointRows& rows, const Ends& ends) {
    rows.count = 0;
    rows.ends = 2;
    rows.body = {ends.a.body, ends.b.body, noBody, noBody};
    rows.arm = {ends.a.arm, ends.b.arm};
}

void hold(JointRow& row, const PredictedCoordinate& predicted, double speed, const JointPass& pass) {
    row.target = 0;
    if (!pass.correct) return;
    const double back = std::clamp(predicted.now * pass.rate, -pass.fastest, pass.fastest);
    row.target = speed - (predicted.later - predicted.now) / pass.step - back;
}

void keepWithin(JointRow& row, const Limit& limit, const PredictedCoordinate& predicted, double speed,
                const JointPass& pass) {
    release(row);
    // Room up to the limit may be used up in one sub-step. A coordinate beyond the limit is corrected like any other
    // error.
    const auto allowed = [&pass](double room) {
        if (room >= 0) return room / pass.step;
        return pass.correct ? std::max(room * pass.rate, -pass.fastest) : 0.0;
    };
    const double bend = pass.correct ? speed - (predicted.later - predicted.now) / pass.step : 0.0;
    row.upperStop = bend + allowed(limit.upper - predicted.now);
    row.lowerStop = std::min(bend - allowed(predicted.now - limit.lower), row.upperStop);
    row.target = std::clamp(row.target, row.lowerStop, row.upperStop);
}

void drive(JointRow& row, double speed, double force, const JointPass& pass) {
    row.holds = false;
    row.high = force > 0 ? boundOf(force) * (0.5 * pass.step) : 0.0;
    row.low = -row.high;
    row.target = speed;
}

void holdRow(JointRows& rows, const JointRow& row, const PredictedCoordinate& predicted, const Ends& now,
             const JointPass& pass) {
    JointRow& held = rows.add() = row;
    hold(held, predicted, speedAhead(held, now, pass.step), pass);
}

void holdPoint(JointRows& rows, const Ends& now, const Ends& later, const JointPass& pass) {
    const Vec2 gap = now.apart(), gapLater = later.apart();
    JointRow x, y;
    x.at[0] = {-1, 0, now.a.arm.y()};
    x.at[1] = {1, 0, -now.b.arm.y()};
    y.at[0] = {0, -1, -now.a.arm.x()};
    y.at[1] = {0, 1, now.b.arm.x()};
    holdRow(rows, x, {gap.x(), gapLater.x()}, now, pass);
    holdRow(rows, y, {gap.y(), gapLater.y()}, now, pass);
}

void pull(JointRow& row, const Spring& spring, double stretch, const JointPass& pass) {
    release(row);
    row.push = -spring.stiffness * pass.springShare * stretch * (0.5 * pass.step);
    row.damper = spring.damping * (0.5 * pass.step);
}

void addLoad(SpringLoad& load, const JointRow& row, const Spring& spring, double stretch, bool heldTurn) {
    SpringLoad::Row& added = load.row[load.count++];
    added = {{row.at[0], row.at[1]}, spring.stiffness, stretch};
    if (heldTurn) added.at[0][2] = added.at[1][2] = 0;
}

}  // namespace plumb
