// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/island_records.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/bodies/solver_velocity.h>

namespace plumb {

namespace {

/// The moment of inertia that the solver uses: that of the body, or a larger one in a tight chain (see
/// island_stiffness_wide.h).
double inertiaOf(const BodyRecord& body) {
    const double inverse = static_cast<double>(body.inverseGyration);
    if (body.inverseGyration == static_cast<float>(std::sqrt(body.inverseInertia * body.mass))) return body.inertia;
    return body.mass / (inverse * inverse);
}

void loadBody(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t node, std::size_t lane, double h) {
    const auto set = [&](int field, double value) { numbers.body(node, field, lane) = value; };
    const BodyIndex index = numbers.bodyAt(node, lane);
    const BodyMotion& motion = bodies.motion[index];
    const BodyRecord& record = bodies.record[index];
    const bool moves = node < numbers.layout->moved, drives = record.type == BodyType::Kinematic;
    set(BodyField::X, 0);
    set(BodyField::Y, 0);
    set(BodyField::Turn, 0);
    set(BodyField::Vx, moves || drives ? motion.velocity.x() : 0.0);
    set(BodyField::Vy, moves || drives ? motion.velocity.y() : 0.0);
    set(BodyField::Spin, moves || drives ? motion.angularVelocity : 0.0);
    for (int c = 0; c < 3; ++c)
        for (const int field : {BodyField::FreeX, BodyField::MovedX})
            set(field + c, numbers.body(node, BodyField::Vx + c, lane));
    for (int c = 0; c < 3; ++c) set(BodyField::BentX + c, 0);
    if (!moves) return;
    const bool turns = record.inverseInertia > 0;
    set(BodyField::InverseMass, record.inverseMass);
    const double inertia = turns ? inertiaOf(record) : 0.0;
    set(BodyField::InverseInertia, turns ? 1 / inertia : 0.0);
    set(BodyField::OwnMass, record.mass);
    set(BodyField::OwnInertia, turns ? record.inertia : 0.0);
    set(BodyField::Mass, record.mass);
    set(BodyField::Inertia, inertia);
    set(BodyField::NormalX, 0);
    set(BodyField::NormalY, 0);
    set(BodyField::ContactMass, record.mass);
    set(BodyField::ContactInertia, inertia);
    const bool inFields = bodies.step[index].flight != none;  // their kicks include gravity and damping
    const FlightLaw law = inFields ? FlightLaw{} : flightLawOf(bodies, index);
    const Decay linear = decay(law.linearDamping, 0.5 * h), angular = decay(law.angularDamping, 0.5 * h);
    set(BodyField::KeepLinear, linear.keep);
    set(BodyField::KeepAngular, angular.keep);
    set(BodyField::GainX, law.acceleration.linear.x() * linear.gain);
    set(BodyField::GainY, law.acceleration.linear.y() * linear.gain);
    set(BodyField::GainSpin, law.acceleration.angular * angular.gain);
}

void loadRow(const IslandNumbers& numbers, const RowForm& form, const Rot& rotationA, double springShare, std::size_t i,
             std::size_t lane, double h) {
    const auto set = [&](int field, double value) { numbers.row(i, field, lane) = value; };
    const Vec2 direction = form.axis == RowAxis::World ? form.direction : Vec2(rotationA * form.direction);
    set(RowField::DirectionX, direction.x());
    set(RowField::DirectionY, direction.y());
    set(RowField::Origin, form.origin);
    if (form.holds) return;
    set(RowField::DriveSpeed, form.speed);
    set(RowField::DriveRate, form.rate);
    set(RowField::MostImpulse, boundOf(form.maxForce) * (0.5 * h));
    set(RowField::LimitLower, form.limit.lower);
    set(RowField::LimitUpper, form.limit.upper);
    set(RowField::HalfStiffness, form.spring.stiffness * springShare * (0.5 * h));
    set(RowField::HalfDamping, form.spring.damping * (0.5 * h));
    set(RowField::SpringRest, form.springRest);
    set(RowField::StopPush, 0);
}

void loadJoint(const IslandNumbers& numbers, const JointForm& form, const JointRecord& record, const BodyStore& bodies,
               std::size_t j, std::size_t lane, double h) {
    const std::size_t firstLink = numbers.layout->joints[j].firstLink, firstRow = numbers.layout->joints[j].firstRow;
    Rot rotation[maxLinks];
    for (std::size_t k = 0; k < form.links; ++k) {
        const Ends ends = endsAtRest(form.link[k], bodies);
        const Vec2 apart = ends.apart();
        const double fields[] = {ends.a.arm.x(), ends.a.arm.y(), ends.b.arm.x(), ends.b.arm.y(),
                                 apart.x(),      apart.y(),      ends.angle()};
        for (std::size_t f = 0; f < std::size(fields); ++f)
            numbers.link(firstLink + k, static_cast<int>(f), lane) = fields[f];
        rotation[k] = ends.a.rotation;
    }
    for (std::size_t r = 0; r < form.rows; ++r) {
        loadRow(numbers, form.row[r], rotation[0], record.springShare, firstRow + r, lane, h);
        numbers.row(firstRow + r, RowField::LastState, lane) = static_cast<double>(record.states[r]);
        if (form.links == 1) continue;
        const Vec2 second = rotation[1] * form.secondDirection;
        numbers.row(firstRow + r, RowField::SecondDirectionX, lane) = second.x();
        numbers.row(firstRow + r, RowField::SecondDirectionY, lane) = second.y();
        numbers.row(firstRow + r, RowField::Ratio, lane) = form.ratio;
    }
    for (const int f : {JointField::LoadX, JointField::LoadY, JointField::LoadTurn}) numbers.joint(j, f, lane) = 0;
}

void storeBody(const IslandNumbers& numbers, BodyRecord& record, JointIsland::Stiffness& stiffness, std::size_t n,
               std::size_t lane) {
    stiffness = {numbers.body(n, BodyField::StiffAlong, lane), numbers.body(n, BodyField::StiffTurning, lane),
                 numbers.body(n, BodyField::Swinging, lane), numbers.body(n, BodyField::Mass, lane)};
    if (!(record.inverseInertia > 0)) return;
    // More inertia at the same spin would be more energy: the body keeps its angular momentum.
    const double was = inertiaOf(record), now = numbers.body(n, BodyField::Inertia, lane);
    if (now > was) numbers.body(n, BodyField::Spin, lane) *= was / now;
    setGyration(record, 1 / now);
}

void storeJoint(const IslandNumbers& numbers, JointRecord& record, JointLoad& sum, std::size_t j, std::size_t lane) {
    const auto load = [&](int field) { return numbers.joint(j, field, lane); };
    sum.impulse += Vec2(load(JointField::LoadX), load(JointField::LoadY));
    sum.turning += load(JointField::LoadTurn);
    const std::size_t first = numbers.layout->joints[j].firstRow;
    for (std::size_t i = first; i < numbers.layout->joints[j + 1].firstRow; ++i)
        if (!numbers.layout->rows[i].holds)
            record.states[i - first] =
                static_cast<RowState>(static_cast<int>(numbers.row(i, RowField::LastState, lane)));
}

float rounded(double value) {
    return static_cast<float>(value);
}

/// Adds to value what others have added to its rounded record.
void pullChange(double& value, float record, double scale) {
    const float known = rounded(value * scale);
    if (record != known) value += (static_cast<double>(record) - static_cast<double>(known)) / scale;
}

/// Takes over a place at which others have put a body.
bool pullPlace(double& value, float record) {
    if (record == rounded(value)) return false;
    value = static_cast<double>(record);
    return true;
}

void pullVelocity(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t n, std::size_t lane) {
    const BodyIndex index = numbers.movedBody(n, lane);
    const SolverVelocity& v = bodies.velocity[index];
    pullChange(numbers.body(n, BodyField::Vx, lane), v.x, 1);
    pullChange(numbers.body(n, BodyField::Vy, lane), v.y, 1);
    pullChange(numbers.body(n, BodyField::Spin, lane), v.w, static_cast<double>(bodies.turn[index].gyration));
}

/// Returns true if its place has changed.
bool pullPlace(const IslandNumbers& numbers, const BodyStore& bodies, std::size_t n, std::size_t lane) {
    const BodyIndex index = numbers.movedBody(n, lane);
    const SolverDisplacement& d = bodies.displacement[index];
    const bool x = pullPlace(numbers.body(n, BodyField::X, lane), d.x);
    const bool y = pullPlace(numbers.body(n, BodyField::Y, lane), d.y);
    return pullPlace(numbers.body(n, BodyField::Turn, lane), bodies.turn[index].angle) || x || y;
}

}  // namespace

void loadIslands(const IslandNumbers& numbers, const JointStore& joints, const BodyStore& bodies, double h) {
    const IslandLayout& layout = *numbers.layout;
    for (std::size_t n = 0; n < layout.bodies; ++n)
        for (std::size_t lane = 0; lane < numbers.width; ++lane) loadBody(numbers, bodies, n, lane, h);
    numbers.forEachMoved([&](std::size_t n, std::size_t lane) {
        const JointIsland::Stiffness& stiffness = numbers.islands[lane]->stiffness[n];
        numbers.body(n, BodyField::StiffAlong, lane) = stiffness.along;
        double& mass = numbers.body(n, BodyField::Mass, lane);
        mass = std::max(mass, stiffness.mass);
        numbers.body(n, BodyField::StiffTurning, lane) = stiffness.turning;
        numbers.body(n, BodyField::Swinging, lane) = stiffness.swinging;
    });
    for (std::size_t j = 0; j < layout.jointCount(); ++j) {
        for (std::size_t lane = 0; lane < numbers.width; ++lane) {
            const JointIsland& island = *numbers.islands[lane];
            loadJoint(numbers, island.laid[j].form, joints[island.joints[j]], bodies, j, lane, h);
        }
    }
    numbers.fillLanes();
}

void storeIslands(const IslandNumbers& numbers, JointStore& joints, BodyStore& bodies) {
    numbers.forEachMoved([&](std::size_t n, std::size_t lane) {
        JointIsland& island = *numbers.islands[lane];
        storeBody(numbers, bodies.record[island.bodies[n]], island.stiffness[n], n, lane);
    });
    for (std::size_t j = 0; j < numbers.layout->jointCount(); ++j) {
        for (std::size_t lane = 0; lane < numbers.width; ++lane) {
            const JointIndex joint = numbers.islands[lane]->joints[j];
            storeJoint(numbers, joints[joint], joints.loads[joint], j, lane);
        }
    }
}

void pullVelocities(const IslandNumbers& numbers, const BodyStore& bodies) {
    numbers.forEachMoved([&](std::size_t n, std::size_t lane) { pullVelocity(numbers, bodies, n, lane); });
}

void writeVelocities(const IslandNumbers& numbers, BodyStore& bodies) {
    numbers.forEachMoved([&](std::size_t n, std::size_t lane) {
        const auto at = [&](int part) { return numbers.body(n, BodyField::Vx + part, lane); };
        if (numbers.active[lane] != 0) setVelocity(bodies, numbers.movedBody(n, lane), {at(0), at(1), at(2)});
    });
}

void pullPlaces(IslandNumbers& numbers, const BodyStore& bodies) {
    bool changed = false;
    numbers.forEachMoved(
        [&](std::size_t n, std::size_t lane) { changed = pullPlace(numbers, bodies, n, lane) || changed; });
    if (changed) numbers.kernel().place(numbers.view);
}

void pullMoves(IslandNumbers& numbers, const BodyStore& bodies, std::size_t lane) {
    bool changed = false;
    for (std::size_t n = 0; n < numbers.layout->moved; ++n) {
        pullVelocity(numbers, bodies, n, lane);
        changed = pullPlace(numbers, bodies, n, lane) || changed;
    }
    if (changed) numbers.kernel().place(numbers.view);
}

void writePlaces(const IslandNumbers& numbers, BodyStore& bodies) {
    numbers.forEachMoved([&](std::size_t n, std::size_t lane) {
        const BodyIndex index = numbers.movedBody(n, lane);
        const auto at = [&](int field) { return numbers.body(n, field, lane); };
        const double gyration = static_cast<double>(bodies.turn[index].gyration);
        bodies.displacement[index] = {rounded(at(BodyField::X)), rounded(at(BodyField::Y)),
                                      rounded(at(BodyField::Sin) * gyration),
                                      rounded((at(BodyField::Cos) - 1) * gyration)};
        bodies.turn[index].angle = rounded(at(BodyField::Turn));
    });
}

BodyMove moveOf(const IslandNumbers& numbers, std::size_t node, std::size_t lane) {
    const auto at = [&](int field) { return numbers.body(node, field, lane); };
    return {Vec2(at(BodyField::X), at(BodyField::Y)), at(BodyField::Turn), Vec2(at(BodyField::Vx), at(BodyField::Vy)),
            at(BodyField::Spin)};
}

}  // namespace plumb
