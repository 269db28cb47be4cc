// SPDX-License-Identifier: MIT
#include <plumb/impact/detail/meeting.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <plumb/impact/detail/bounces.h>

namespace plumb {

namespace {

/// The most sweeps over both points: enough for the impulses to converge [-]. Sweeps end earlier when no bit changes.
constexpr int mostSweeps = 200;
/// A machine at its stops answers a large impulse otherwise than a small one: what still approaches faster than this is
/// solved again, this often at most [m/s, -].
constexpr double stopped = 1e-6;
constexpr int mostTurns = 4;

double product(const OfBoth& a, const OfBoth& b) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) sum += a.a[i] * b.a[i] + a.b[i] * b.b[i];
    return sum;
}

/// A direction at a point: the impulses of 1 N s along it.
struct MeetingRow {
    OfBoth along, response;
    double before = 0, speed = 0, impulse = 0;
};

class Impact {
public:
    Impact(std::span<const MeetingPoint> points, const Vec2& normal, const ImpactLaw& law, MeetingBodies& bodies)
        : law_(law), bodies_(bodies), count_(2 * points.size()) {
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec2 axis = i % 2 == 0 ? normal : perp(normal);
            const MeetingPoint& point = points[i / 2];
            rows_[i].along = {{-axis.x(), -axis.y(), -cross(point.armA, axis)},
                              {axis.x(), axis.y(), cross(point.armB, axis)}};
            if (i % 2 == 0 || law.friction > 0) rows_[i].response = bodies.responseTo(rows_[i].along);
        }
        const OfBoth& first = rows_[0].response;
        movesA_ = first.a != Vec3{};
        movesB_ = first.b != Vec3{};
    }

    double approach() {
        const OfBoth velocity = bodies_.velocity();
        double fastest = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            rows_[i].before = rows_[i].speed = product(rows_[i].along, velocity);
            if (i % 2 == 0) fastest = std::max(fastest, -rows_[i].speed);
        }
        return std::isfinite(fastest) ? fastest : 0;
    }

    /// False if it cannot be solved. again: corrects a solution, and needs no friction.
    bool solve(double restitution, bool again, Meeting& meeting) {
        for (std::size_t i = 0; i < count_; i += 2)
            if (!(response(i, i) > 0)) return false;
        const OfBoth start = bodies_.velocity();
        count_ == 2 ? solveOne(restitution) : solveTwo(restitution, !again && law_.friction > 0);
        OfBoth sum;
        for (const MeetingRow& row : rows())
            for (std::size_t c = 0; c < 3; ++c) {
                sum.a[c] += row.impulse * row.along.a[c];
                sum.b[c] += row.impulse * row.along.b[c];
            }
        const auto isFinite = [](double part) { return std::isfinite(part); };
        if (!std::all_of(sum.a.begin(), sum.a.end(), isFinite) || !std::all_of(sum.b.begin(), sum.b.end(), isFinite))
            return false;
        bodies_.push(sum);
        note(start, sum, meeting);
        return true;
    }

private:
    std::span<MeetingRow> rows() { return {rows_.data(), count_}; }
    double response(std::size_t i, std::size_t j) const { return product(rows_[i].along, rows_[j].response); }

    void solveOne(double restitution) {
        const ImpactResponse k{response(0, 0), response(0, 1), response(1, 1)};
        const ImpactLaw law{restitution, law_.friction, law_.surfaceSpeed};
        const ImpactImpulses given = impactImpulses(k, -rows_[0].speed, rows_[1].speed + law.surfaceSpeed, law);
        rows_[0].impulse = given.normal;
        rows_[1].impulse = given.tangent;
    }

    /// Poisson's law: the impulses that just stop the approach, and e of them once more. So both together never give
    /// energy, as Newton's law would at two points.
    void solveTwo(double restitution, bool withFriction) {
        for (MeetingRow& row : rows()) {
            row.impulse = 0;
            row.speed = row.before;
        }
        for (int sweep = 0; sweep < mostSweeps; ++sweep) {
            bool changes = false;
            for (std::size_t i = 0; i < count_; ++i)
                if (i % 2 == 0 || withFriction) changes = stopRow(i) || changes;
            if (!changes) break;
        }
        for (MeetingRow& row : rows()) {
            row.impulse *= 1 + restitution;
            row.speed += restitution * (row.speed - row.before);
        }
        if (withFriction && gains()) solveTwo(restitution, false);
    }

    /// First the normal, then friction within its limit; sums are clamped, so a later sweep may take impulses back.
    bool stopRow(std::size_t i) {
        MeetingRow& row = rows_[i];
        const double old = row.impulse, mass = response(i, i);
        if (!(mass > 0)) return false;
        const double speed = row.speed + beltAt(i), limit = i % 2 == 0 ? 0 : law_.friction * rows_[i - 1].impulse;
        row.impulse = i % 2 == 0 ? std::max(old - speed / mass, 0.0) : std::clamp(old - speed / mass, -limit, limit);
        for (std::size_t j = 0; j < count_; ++j) rows_[j].speed += response(j, i) * (row.impulse - old);
        return row.impulse != old;
    }

    /// Where bodies are very oblique, the sweeps may find no impulses that obey friction, and would give energy.
    bool gains() const {
        double work = 0, size = 0;
        for (std::size_t i = 0; i < count_; ++i) {
            const double part = rows_[i].impulse * (0.5 * (rows_[i].before + rows_[i].speed) + beltAt(i));
            work += part;
            size += std::fabs(part);
        }
        return work > 1e-9 * size;
    }

    double beltAt(std::size_t i) const { return i % 2 == 0 ? 0 : law_.surfaceSpeed; }

    /// An impulse P along a direction in which the speed goes from v to v' does the work P (v + v') / 2, exactly. The
    /// belt's surface and bodies that impulses do not move are drivers: their work is entered apart, or friction on a
    /// moving belt would seem to create energy.
    void note(const OfBoth& start, const OfBoth& sum, Meeting& meeting) {
        const OfBoth end = bodies_.velocity();
        for (std::size_t i = 0; i < count_; ++i) {
            const MeetingRow& row = rows_[i];
            const double mean = 0.5 * (row.before + product(row.along, end));
            if (i % 2 == 0) {
                meeting.normalImpulse += row.impulse;
                meeting.bounce += row.impulse * mean;
            } else {
                meeting.tangentImpulse += row.impulse;
                meeting.friction += row.impulse * (mean + law_.surfaceSpeed);
                meeting.drivers -= row.impulse * law_.surfaceSpeed;
            }
        }
        if (!movesA_) meeting.drivers -= product({sum.a, {}}, start);
        if (!movesB_) meeting.drivers -= product({{}, sum.b}, start);
        meeting.onB += Vec2(sum.b[0], sum.b[1]);
    }

    ImpactLaw law_;
    MeetingBodies& bodies_;
    std::size_t count_;
    std::array<MeetingRow, 4> rows_;
    bool movesA_ = false, movesB_ = false;
};

Vec3 changeOf(const LooseBody& body, const Vec3& impulse) {
    return {impulse[0] * body.inverseMass, impulse[1] * body.inverseMass, impulse[2] * body.inverseInertia};
}

}  // namespace

OfBoth LooseBodies::responseTo(const OfBoth& impulse) {
    return {changeOf(a, impulse.a), changeOf(b, impulse.b)};
}

void LooseBodies::push(const OfBoth& impulse) {
    const OfBoth change = responseTo(impulse);
    for (std::size_t c = 0; c < 3; ++c) {
        a.velocity[c] += change.a[c];
        b.velocity[c] += change.b[c];
    }
}

void Meeting::add(const Meeting& next) {
    approachSpeed = std::max(approachSpeed, next.approachSpeed);
    normalImpulse += next.normalImpulse;
    tangentImpulse += next.tangentImpulse;
    onB += next.onB;
    friction += next.friction;
    drivers += next.drivers;
    bounce += next.bounce;
}

Meeting solveMeeting(std::span<const MeetingPoint> points, const Vec2& normal, const ImpactLaw& law, double resting,
                     MeetingBodies& bodies) {
    Meeting meeting;
    Impact impact(points, normal, law, bodies);
    double approach = meeting.approachSpeed = impact.approach();
    // One law for both points, that of the faster one: else a box that lands flat might bounce with one corner only.
    const double restitution = bounces(law.restitution, approach, resting) ? law.restitution : 0;
    for (int turn = 0; turn < mostTurns && approach > (turn == 0 ? 0 : stopped); ++turn) {
        if (!impact.solve(restitution, turn > 0, meeting)) break;
        approach = impact.approach();
    }
    return meeting;
}

}  // namespace plumb
