// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_measure.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace plumb {

namespace {

/// See RowAxis. Axes along a missing velocity are not measured.
Vec2 axisOf(RowAxis axis, const Vec2& direction, const Ends& ends) {
    const Vec2 along = ends.apart().stableNormalized();
    const Vec2 towards = ends.apart().squaredNorm() > 0 ? along : Vec2(1, 0);
    switch (axis) {
        case RowAxis::World: return direction;
        case RowAxis::OnA: return ends.a.rotation * direction;
        case RowAxis::Along: return along;
        case RowAxis::Towards: return towards;
        case RowAxis::Across: return perp(towards);
        default: return {0, 0};
    }
}

MeasuredRow measureLink(const AnchorPair& anchors, RowAxis axis, const Vec2& direction, const BodyStore& bodies) {
    MeasuredRow row;
    if (axis == RowAxis::Turning) {
        const BodyMotion &a = bodies.motion[anchors.a.body], &b = bodies.motion[anchors.b.body];
        row.at = {Vec3{0, 0, -1}, Vec3{0, 0, 1}};
        row.coordinate = b.angle - a.angle;
        row.speed = b.angularVelocity - a.angularVelocity;
        return row;
    }
    const Ends ends = endsAtRest(anchors, bodies);
    const Vec2 along = axisOf(axis, direction, ends), fromA = ends.a.arm + ends.apart();
    row.at = {Vec3{-along.x(), -along.y(), -cross(fromA, along)}, Vec3{along.x(), along.y(), cross(ends.b.arm, along)}};
    const bool isLength = axis == RowAxis::Along || axis == RowAxis::Towards;
    row.coordinate = isLength ? ends.apart().norm() : along.dot(ends.apart());
    const auto part = [](const Vec3& at, const End& end) {
        return at[0] * end.velocity.x() + at[1] * end.velocity.y() + at[2] * end.spin;
    };
    row.speed = part(row.at[0], ends.a) + part(row.at[1], ends.b);
    return row;
}

std::span<const RowForm> rowsOf(const JointForm& form) {
    return {form.row.data(), form.rows};
}

bool turns(const JointForm& form, const RowForm& row) {
    return row.axis == RowAxis::Turning && form.links == 1;
}

double rowError(const JointForm& form, const RowForm& row, const BodyStore& bodies) {
    const double q = measure(form, row, bodies).coordinate;
    return row.holds ? std::fabs(q) : std::max({0.0, row.limit.lower - q, q - row.limit.upper});
}

}  // namespace

MeasuredRow measure(const JointForm& form, const RowForm& row, const BodyStore& bodies) {
    MeasuredRow measured = measureLink(form.link[0], row.axis, row.direction, bodies);
    if (form.links > 1) {
        const MeasuredRow second = measureLink(form.link[1], form.secondAxis, form.secondDirection, bodies);
        measured.coordinate += form.ratio * second.coordinate;
        measured.speed += form.ratio * second.speed;
    }
    measured.coordinate -= row.origin;
    return measured;
}

/// An angle beyond its limit counts at B's anchor.
double errorOf(const JointForm& form, const BodyStore& bodies) {
    double most = 0, gap = 0;
    for (const RowForm& row : rowsOf(form)) {
        if (turns(form, row) && row.holds) continue;
        const double error = rowError(form, row, bodies);
        if (row.axis == RowAxis::World && row.holds)
            gap = Vec2(gap, error).stableNorm();
        else
            most = std::max(most, turns(form, row) ? error * form.link[0].b.local.norm() : error);
    }
    return std::max(most, gap);
}

double angleErrorOf(const JointForm& form, const BodyStore& bodies) {
    double most = 0;
    for (const RowForm& row : rowsOf(form))
        if (turns(form, row)) most = std::max(most, rowError(form, row, bodies));
    return most;
}

SpringLoad springLoadOf(const JointForm& form, const BodyStore& bodies) {
    SpringLoad load;
    const auto rows = rowsOf(form);
    const bool heldTurn = std::any_of(rows.begin(), rows.end(),
                                      [](const RowForm& row) { return row.holds && row.axis == RowAxis::Turning; });
    for (const RowForm& row : rows) {
        if (!row.isSpring()) continue;
        const MeasuredRow measured = measure(form, row, bodies);
        SpringLoad::Row& added = load.row[load.count++];
        added = {measured.at, row.spring.stiffness, measured.coordinate - row.springRest};
        if (heldTurn) added.at[0][2] = added.at[1][2] = 0;  // it cannot turn the bodies
        if (row.bounded) load.mostForce = row.maxForce;
    }
    return load;
}

double turningOf(const JointForm& form, const BodyStore& bodies) {
    double fastest = 0;
    for (std::size_t k = 0; k < form.links; ++k) {
        bool isLength = false, holds = false;
        for (const RowForm& row : rowsOf(form)) {
            const RowAxis axis = k == 0 ? row.axis : form.secondAxis;
            holds = holds || (row.holds && axis != RowAxis::Turning);
            isLength = isLength || (row.holds && axis == RowAxis::Along);
        }
        if (!holds) continue;
        const Ends ends = endsAtRest(form.link[k], bodies);
        const Vec2 apart = ends.apart(), fromA = ends.a.arm + apart;
        const double a = fromA.norm(), b = ends.b.arm.norm(), length = apart.norm();
        if (a + b > 0)
            fastest = std::max(fastest, std::max(std::fabs(ends.a.spin) * a, std::fabs(ends.b.spin) * b) / (a + b));
        if (!isLength || !(length > 0)) continue;
        const Vec2 aside =
            (ends.b.velocity + perp(ends.b.arm) * ends.b.spin) - (ends.a.velocity + perp(fromA) * ends.a.spin);
        fastest = std::max(fastest, aside.norm() / length);
    }
    return fastest;
}

}  // namespace plumb
