// SPDX-License-Identifier: MIT
// How does a batch take in its islands at the start of a step, and give them back at its end?
#include <algorithm>
#include <cmath>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/joints/joint_batch.h>

namespace plumb {

namespace {

/// The moment of inertia that the solver uses: that of the body, or a larger one in a tight chain (see
/// island_stiffness_wide.h).
double inertiaOf(const BodyRecord& body) {
    const double inverse = static_cast<double>(body.inverseGyration);
    if (body.inverseGyration == static_cast<float>(std::sqrt(body.inverseInertia * body.mass))) return body.inertia;
    return body.mass / (inverse * inverse);
}

}  // namespace

void JointBatch::layOut(bool isNew) {
    const IslandLayout& layout = *layout_;
    const std::size_t width = width_;
    kernel_ = &islandKernel(static_cast<int>(width));
    const std::size_t nodes = layout.moved + layout.jointCount();
    const std::size_t sizes[] = {layout.bodies * std::size_t{BodyField::count},
                                 layout.links.size() * LinkField::count,
                                 layout.rows.size() * RowField::count,
                                 layout.jointCount() * std::size_t{JointField::count},
                                 layout.blocks * std::size_t{9},
                                 nodes * 3,
                                 layout.blocks * std::size_t{9}};
    std::size_t total = 0;
    for (const std::size_t size : sizes) total += size * width;
    constexpr std::size_t line = 8;  // doubles in a cache line
    if (isNew) numbers_.assign(total + line, 0.0);
    const auto address = reinterpret_cast<std::uintptr_t>(numbers_.data()) / sizeof(double);
    double* at = numbers_.data() + (line - address % line) % line;
    double** const arrays[] = {&view_.body,  &view_.link,   &view_.row,    &view_.joint,
                               &view_.block, &view_.answer, &view_.inverse};
    for (std::size_t i = 0; i < std::size(sizes); at += sizes[i] * width, ++i) *arrays[i] = at;
    view_.links = layout.links.data();
    view_.rows = layout.rows.data();
    view_.ends = layout.ends.data();
    view_.joints = layout.joints.data();
    view_.steps = layout.steps.data();
    view_.lowers = layout.lowers.data();
    view_.updates = layout.updates.data();
    view_.moved = layout.moved;
    view_.bodies = layout.bodies;
    view_.linkCount = static_cast<std::uint32_t>(layout.links.size());
    view_.rowCount = static_cast<std::uint32_t>(layout.rows.size());
    view_.jointCount = layout.jointCount();
    view_.stepCount = static_cast<std::uint32_t>(layout.steps.size() - 1);
    view_.blocks = layout.blocks;
    view_.firstFill = layout.firstFill;
    view_.someFree = layout.someFree;
    view_.compliance = layout.isTree ? 0 : relativeCompliance;
    view_.slack = layout.isTree ? treeCompliance : 0;
}

void JointBatch::load(std::span<JointIsland* const> islands, const JointStore& joints, BodyStore& bodies, double h) {
    const bool isNew = layout_ != islands.front()->layout || width_ != islands.size();
    layout_ = islands.front()->layout;
    width_ = islands.size();
    pieces_ = islands.front()->pieces;
    layOut(isNew);
    islands_.assign(islands.begin(), islands.end());
    view_.active = active_.data();
    view_.missed = missed_.data();
    view_.lost = lost_.data();
    view_.heavy = heavy_.data();
    view_.factored = false;
    moved_ = false;
    h_ = h;
    for (std::size_t lane = 0; lane < width_; ++lane) {
        islands[lane]->batch = this;
        islands[lane]->lane = lane;
    }
    for (std::size_t n = 0; n < layout_->bodies; ++n)
        for (std::size_t lane = 0; lane < width_; ++lane) loadBody(bodies, islands[lane]->bodyAt(n), n, lane, h);
    for (std::size_t n = 0; n < layout_->moved; ++n) {
        for (std::size_t lane = 0; lane < width_; ++lane) {
            body(n, BodyField::StiffAlong, lane) = islands[lane]->stiffness[n].along;
            body(n, BodyField::StiffTurning, lane) = islands[lane]->stiffness[n].turning;
            body(n, BodyField::Swinging, lane) = islands[lane]->stiffness[n].swinging;
        }
    }
    for (std::size_t j = 0; j < layout_->jointCount(); ++j)
        for (std::size_t lane = 0; lane < width_; ++lane)
            loadJoint(islands[lane]->laid[j].form, joints[islands[lane]->joints[j]], bodies, j, lane, h);
    findTouching(bodies);
    for (std::size_t lane = 0; lane < width_; ++lane) heavy_[lane] = isHeavy(bodies, lane) ? 1 : 0;
    activate(true, 0);
    writeVelocities(bodies);
    kernel_->place(view_);
    for (std::size_t i = 0; i < layout_->rows.size(); ++i)
        for (std::size_t lane = 0; lane < width_; ++lane) row(i, RowField::StartError, lane) = errorOf(i, lane);
    kernel_->setMasses(view_, h);
}

void JointBatch::findTouching(const BodyStore& bodies) {
    touching_.clear();
    for (std::uint32_t n = 0; n < layout_->moved; ++n)
        for (std::uint32_t lane = 0; lane < width_; ++lane)
            if (const BodyIndex index = islands_[lane]->bodies[n]; bodies.links[index].solverContacts > 0)
                touching_.push_back({n, lane, index});
}

void JointBatch::loadBody(const BodyStore& bodies, BodyIndex index, std::size_t node, std::size_t lane, double h) {
    const auto set = [&](int field, double value) { body(node, field, lane) = value; };
    const BodyMotion& motion = bodies.motion[index];
    const BodyRecord& record = bodies.record[index];
    const bool moves = node < layout_->moved, drives = record.type == BodyType::Kinematic;
    set(BodyField::X, 0);
    set(BodyField::Y, 0);
    set(BodyField::Turn, 0);
    set(BodyField::Vx, moves || drives ? motion.velocity.x() : 0.0);
    set(BodyField::Vy, moves || drives ? motion.velocity.y() : 0.0);
    set(BodyField::Spin, moves || drives ? motion.angularVelocity : 0.0);
    for (int c = 0; c < 3; ++c)
        for (const int field : {BodyField::FreeX, BodyField::MovedX})
            set(field + c, body(node, BodyField::Vx + c, lane));
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

void JointBatch::loadJoint(const JointForm& form, const JointRecord& record, const BodyStore& bodies, std::size_t j,
                           std::size_t lane, double h) {
    const std::size_t firstLink = layout_->joints[j].firstLink, firstRow = layout_->joints[j].firstRow;
    Rot rotation[maxLinks];
    for (std::size_t k = 0; k < form.links; ++k) {
        const Ends ends = endsAtRest(form.link[k], bodies);
        const Vec2 apart = ends.apart();
        const double fields[] = {ends.a.arm.x(), ends.a.arm.y(), ends.b.arm.x(), ends.b.arm.y(),
                                 apart.x(),      apart.y(),      ends.angle()};
        for (std::size_t f = 0; f < std::size(fields); ++f)
            number(view_.link, LinkField::count, firstLink + k, static_cast<int>(f), lane) = fields[f];
        rotation[k] = ends.a.rotation;
    }
    for (std::size_t r = 0; r < form.rows; ++r) {
        loadRow(form.row[r], rotation[0], record.springShare, firstRow + r, lane, h);
        row(firstRow + r, RowField::LastState, lane) = static_cast<double>(record.states[r]);
        if (form.links == 1) continue;
        const Vec2 second = rotation[1] * form.secondDirection;
        row(firstRow + r, RowField::SecondDirectionX, lane) = second.x();
        row(firstRow + r, RowField::SecondDirectionY, lane) = second.y();
        row(firstRow + r, RowField::Ratio, lane) = form.ratio;
    }
    for (const int f : {JointField::LoadX, JointField::LoadY, JointField::LoadTurn})
        number(view_.joint, JointField::count, j, f, lane) = 0;
}

void JointBatch::loadRow(const RowForm& form, const Rot& rotationA, double springShare, std::size_t i, std::size_t lane,
                         double h) {
    const auto set = [&](int field, double value) { row(i, field, lane) = value; };
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
}

void JointBatch::storeBody(BodyRecord& record, JointIsland::Stiffness& stiffness, std::size_t n, std::size_t lane) {
    stiffness = {body(n, BodyField::StiffAlong, lane), body(n, BodyField::StiffTurning, lane),
                 body(n, BodyField::Swinging, lane)};
    if (!(record.inverseInertia > 0)) return;
    // More inertia at the same spin would be more energy: the body keeps its angular momentum.
    const double was = inertiaOf(record), now = body(n, BodyField::Inertia, lane);
    if (now > was) body(n, BodyField::Spin, lane) *= was / now;
    setGyration(record, 1 / now);
}

void JointBatch::storeJoint(JointRecord& record, JointLoad& sum, std::size_t j, std::size_t lane) const {
    const auto load = [&](int field) { return number(view_.joint, JointField::count, j, field, lane); };
    sum.impulse += Vec2(load(JointField::LoadX), load(JointField::LoadY));
    sum.turning += load(JointField::LoadTurn);
    const std::size_t first = layout_->joints[j].firstRow;
    for (std::size_t i = first; i < layout_->joints[j + 1].firstRow; ++i)
        if (!layout_->rows[i].holds)
            record.states[i - first] = static_cast<RowState>(static_cast<int>(row(i, RowField::LastState, lane)));
}

void JointBatch::store(JointStore& joints, BodyStore& bodies) {
    kernel_->findInertias(view_, h_);
    for (std::size_t n = 0; n < layout_->moved; ++n)
        for (std::size_t lane = 0; lane < width_; ++lane)
            storeBody(bodies.record[islands_[lane]->bodies[n]], islands_[lane]->stiffness[n], n, lane);
    for (std::size_t j = 0; j < layout_->jointCount(); ++j) {
        for (std::size_t lane = 0; lane < width_; ++lane) {
            const JointIndex joint = islands_[lane]->joints[j];
            storeJoint(joints[joint], joints.loads[joint], j, lane);
        }
    }
}

}  // namespace plumb
