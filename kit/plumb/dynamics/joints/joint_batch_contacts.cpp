// SPDX-License-Identifier: MIT
// With which masses do contacts see the bodies of a batch, and how do joints answer to their impulses?
#include <algorithm>
#include <cmath>

#include <plumb/dynamics/joints/joint_batch.h>

namespace plumb {

/// May a body that contacts touch be held to something that is much heavier than it is? Contacts that see it as up to
/// 60 times too light rest all the same (tried), but gain or lose energy when they land. Machines with stops or springs
/// would have to be asked in each half: twice the time for a heap of dolls (tried), so they are asked later.
bool JointBatch::isHeavy(const BodyStore& bodies, std::size_t lane) const {
    const double heavy = layout_->someFree ? 30 : 8;
    double mass = 0, lightest = unlimited;
    for (const BodyIndex body : islands_[lane]->bodies) {
        mass += bodies.record[body].mass;
        if (bodies.links[body].solverContacts > 0) lightest = std::min(lightest, bodies.record[body].mass);
    }
    return islands_[lane]->held.empty() ? mass > heavy * lightest : lightest < unlimited;
}

void JointBatch::findContactBodies(const BodyStore& bodies, bool first, std::vector<ContactBody>& found) {
    if (heavy_ == Lanes{} || (!first && !layout_->someFree)) return;
    for (std::size_t i = 0; i < layout_->rows.size(); ++i)
        for (std::size_t lane = 0; lane < width_ && !layout_->rows[i].holds; ++lane)
            row(i, RowField::Bears, lane) = bears(i, lane) ? 1 : 0;
    findContactBodies(bodies, heavy_, found);
}

/// Do contacts push a body of the row, or must they, because it does not part from what it touches?
bool JointBatch::isPushed(const BodyStore& bodies, std::size_t i, std::size_t lane) const {
    constexpr double little = 1e-6;  // of the speed at which it parts: rounding
    const IslandShape::Link& link = layout_->links[layout_->rows[i].link];
    const auto pushes = [&](std::uint32_t n) {
        if (n >= layout_->moved) return false;
        const SolverVelocity& warm = bodies.warm[islands_[lane]->bodies[n]];
        const double x = body(n, BodyField::NormalX, lane), y = body(n, BodyField::NormalY, lane);
        const double parting = body(n, BodyField::Vx, lane) * x + body(n, BodyField::Vy, lane) * y;
        return parting < 0 || static_cast<double>(warm.x) * x + static_cast<double>(warm.y) * y > little * parting;
    };
    return pushes(link.a) || pushes(link.b);
}

/// Do other stops bear than those with which contacts have been solved? One that has opened because nothing pushes its
/// bodies any more does not count.
bool JointBatch::areOthersBearing(const BodyStore& bodies, std::size_t lane) const {
    for (std::size_t i = 0; i < layout_->rows.size(); ++i) {
        if (layout_->rows[i].holds) continue;
        const double known = row(i, RowField::Bears, lane);
        if (known < 0 || bears(i, lane) == (known > 0)) continue;
        if (known == 0 || isPushed(bodies, i, lane)) return true;
    }
    return false;
}

/// A stop that does not bear any more does not bear again in this half.
void JointBatch::noteBearing(bool withStops) {
    for (std::size_t i = 0; i < layout_->rows.size(); ++i) {
        for (std::size_t lane = 0; lane < width_ && !layout_->rows[i].holds; ++lane) {
            if (changed_[lane] == 0) continue;
            double& known = row(i, RowField::Bears, lane);
            if (!withStops || (known > 0 && !bears(i, lane)))
                known = -1;
            else if (known == 0)
                known = bears(i, lane) ? 1 : 0;
        }
    }
}

void JointBatch::findChangedBodies(const BodyStore& bodies, std::vector<ContactBody>& found) {
    findContactBodies(bodies, changed_, found);
}

void JointBatch::findContactBodies(const BodyStore& bodies, const Lanes& lanes, std::vector<ContactBody>& found) {
    if (lanes == Lanes{}) return;
    kernel_->respond(view_);
    for (std::size_t lane = 0; lane < width_; ++lane)
        if (lanes[lane] != 0) addContactBodies(found, bodies, lane);
}

/// Is the row at a stop that pushes against the contacts of its bodies? A stop that pushes the same way as they do
/// opens if they push more.
bool JointBatch::bears(std::size_t i, std::size_t lane) const {
    constexpr double lowerStop = 3, upperStop = 4;  // see island_curve_wide.h
    const double state = row(i, RowField::State, lane);
    if (state < lowerStop) return false;
    const double sign = state == upperStop ? -1 : 1;
    double against = 0;
    const IslandShape::Link& link = layout_->links[layout_->rows[i].link];
    for (const bool isB : {false, true}) {
        const std::uint32_t n = isB ? link.b : link.a;
        if (n >= layout_->moved) continue;
        const double along = row(i, RowField::AxisX, lane) * body(n, BodyField::NormalX, lane) +
                             row(i, RowField::AxisY, lane) * body(n, BodyField::NormalY, lane);
        against -= (isB ? sign : -sign) * along;
    }
    return against > 0;
}

void JointBatch::addContactBodies(std::vector<ContactBody>& found, const BodyStore& bodies, std::size_t lane) {
    // A body that answers by more than this share of what it would do alone is seen as it is. None is seen as more than
    // 1 / least times as heavy: beyond that, impulses may leave the range of floats (tried).
    constexpr double share = 0.25, least = 1e-4;
    const auto linear = [&](std::size_t n) {
        return body(n, BodyField::Response, lane) * body(n, BodyField::OwnMass, lane);
    };
    const auto turning = [&](std::size_t n) {
        return body(n, BodyField::TurnResponse, lane) * body(n, BodyField::Inertia, lane);
    };
    const auto isHeld = [&](std::size_t n) {
        return bodies.links[islands_[lane]->bodies[n]].solverContacts > 0 && std::min(linear(n), turning(n)) < share;
    };
    double count = 0;
    for (std::size_t n = 0; n < layout_->moved; ++n) count += isHeld(n) ? 1 : 0;
    count = std::max(1.0, count);
    for (std::size_t n = 0; n < layout_->moved; ++n) {
        double mass = body(n, BodyField::OwnMass, lane), inertia = body(n, BodyField::Inertia, lane);
        if (isHeld(n)) {
            mass /= std::clamp(count * linear(n), least, 1.0);
            inertia /= std::clamp(count * turning(n), least, 1.0);
        }
        if (mass == body(n, BodyField::ContactMass, lane) && inertia == body(n, BodyField::ContactInertia, lane))
            continue;
        body(n, BodyField::ContactMass, lane) = mass;
        body(n, BodyField::ContactInertia, lane) = inertia;
        found.push_back({islands_[lane]->bodies[n], mass, inertia});
    }
}

}  // namespace plumb
