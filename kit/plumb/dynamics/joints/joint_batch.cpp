// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_batch.h>

#include <cmath>

#include <plumb/dynamics/bodies/free_motion.h>
#include <plumb/dynamics/joints/joint_island.h>

namespace plumb {

namespace {

float rounded(double value) {
    return static_cast<float>(value);
}

/// Adds to value what others have added to its rounded record.
void pullChange(double& value, float record, double scale) {
    const float known = rounded(value * scale);
    if (record != known) value += (static_cast<double>(record) - static_cast<double>(known)) / scale;
}

/// The moment of inertia that the solver uses: that of the body, or a larger one in a tight chain (see
/// island_stiffness_wide.h).
double inertiaOf(const BodyRecord& body) {
    const double inverse = static_cast<double>(body.inverseGyration);
    if (body.inverseGyration == rounded(std::sqrt(body.inverseInertia * body.mass))) return body.inertia;
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
                                 nodes * 3};
    std::size_t total = 0;
    for (const std::size_t size : sizes) total += size * width;
    constexpr std::size_t line = 8;  // doubles in a cache line
    if (isNew) numbers_.assign(total + line, 0.0);
    const auto address = reinterpret_cast<std::uintptr_t>(numbers_.data()) / sizeof(double);
    double* at = numbers_.data() + (line - address % line) % line;
    double** const arrays[] = {&view_.body, &view_.link, &view_.row, &view_.joint, &view_.block, &view_.answer};
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
}

void JointBatch::load(std::span<JointIsland* const> islands, const JointStore& joints, BodyStore& bodies, double h) {
    const bool isNew = layout_ != islands.front()->layout || width_ != islands.size();
    layout_ = islands.front()->layout;
    width_ = islands.size();
    layOut(isNew);
    islands_.assign(islands.begin(), islands.end());
    view_.active = active_.data();
    view_.factored = false;
    moved_ = false;
    h_ = h;
    for (std::size_t lane = 0; lane < width_; ++lane) {
        JointIsland& island = *islands[lane];
        island.batch = this;
        island.lane = lane;
        for (std::size_t n = 0; n < layout_->bodies; ++n) {
            const bool moves = n < layout_->moved;
            loadBody(bodies, moves ? island.bodies[n] : island.held[n - layout_->moved], n, lane, h);
            if (!moves) continue;
            body(n, BodyField::StiffAlong, lane) = island.stiffness[n].along;
            body(n, BodyField::StiffTurning, lane) = island.stiffness[n].turning;
        }
        for (std::size_t j = 0; j < island.joints.size(); ++j)
            loadJoint(joints.formOf(island.joints[j]), joints, island.joints[j], bodies, j, lane, h);
    }
    writeVelocities(bodies);
    kernel_->place(view_);
    kernel_->setMasses(view_, h);
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
    if (!moves) return;
    const bool turns = record.inverseInertia > 0;
    set(BodyField::InverseMass, record.inverseMass);
    const double inertia = turns ? inertiaOf(record) : 0.0;
    set(BodyField::InverseInertia, turns ? 1 / inertia : 0.0);
    set(BodyField::OwnMass, record.mass);
    set(BodyField::OwnInertia, turns ? record.inertia : 0.0);
    set(BodyField::Mass, record.mass);
    set(BodyField::Inertia, inertia);
    const bool inFields = bodies.step[index].flight != none;  // their kicks include gravity and damping
    const FlightLaw law = inFields ? FlightLaw{} : flightLawOf(bodies, index);
    const Decay linear = decay(law.linearDamping, 0.5 * h), angular = decay(law.angularDamping, 0.5 * h);
    set(BodyField::KeepLinear, linear.keep);
    set(BodyField::KeepAngular, angular.keep);
    set(BodyField::GainX, law.acceleration.linear.x() * linear.gain);
    set(BodyField::GainY, law.acceleration.linear.y() * linear.gain);
    set(BodyField::GainSpin, law.acceleration.angular * angular.gain);
}

void JointBatch::loadJoint(const JointForm& form, const JointStore& joints, JointIndex index, const BodyStore& bodies,
                           std::size_t j, std::size_t lane, double h) {
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
        loadRow(form.row[r], rotation[0], joints[index].springShare, firstRow + r, lane, h);
        row(firstRow + r, RowField::LastState, lane) = static_cast<double>(joints[index].states[r]);
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

void JointBatch::store(JointStore& joints, BodyStore& bodies) {
    kernel_->findInertias(view_, h_);
    for (std::size_t lane = 0; lane < width_; ++lane) {
        JointIsland& island = *islands_[lane];
        for (std::size_t n = 0; n < layout_->moved; ++n) {
            island.stiffness[n] = {body(n, BodyField::StiffAlong, lane), body(n, BodyField::StiffTurning, lane)};
            BodyRecord& record = bodies.record[island.bodies[n]];
            if (record.inverseInertia > 0) setGyration(record, 1 / body(n, BodyField::Inertia, lane));
        }
        for (std::size_t j = 0; j < island.joints.size(); ++j) {
            const auto load = [&](int field) { return number(view_.joint, JointField::count, j, field, lane); };
            JointLoad& sum = joints.loads[island.joints[j]];
            sum.impulse += Vec2(load(JointField::LoadX), load(JointField::LoadY));
            sum.turning += load(JointField::LoadTurn);
            const std::size_t first = layout_->joints[j].firstRow;
            for (std::size_t i = first; i < layout_->joints[j + 1].firstRow; ++i)
                if (!layout_->rows[i].holds)
                    joints[island.joints[j]].states[i - first] =
                        static_cast<RowState>(static_cast<int>(row(i, RowField::LastState, lane)));
        }
    }
}

void JointBatch::pullVelocity(const BodyStore& bodies, BodyIndex index, std::size_t node, std::size_t lane) {
    const SolverVelocity& v = bodies.velocity[index];
    pullChange(body(node, BodyField::Vx, lane), v.x, 1);
    pullChange(body(node, BodyField::Vy, lane), v.y, 1);
    pullChange(body(node, BodyField::Spin, lane), v.w, static_cast<double>(bodies.turn[index].gyration));
}

void JointBatch::pullPlace(const BodyStore& bodies, BodyIndex index, std::size_t node, std::size_t lane) {
    const SolverDisplacement& d = bodies.displacement[index];
    pullChange(body(node, BodyField::X, lane), d.x, 1);
    pullChange(body(node, BodyField::Y, lane), d.y, 1);
    pullChange(body(node, BodyField::Turn, lane), bodies.turn[index].angle, 1);
}

void JointBatch::pull(const BodyStore& bodies) {
    for (std::size_t n = 0; n < layout_->moved; ++n) {
        for (std::size_t lane = 0; lane < width_; ++lane) {
            const BodyIndex index = islands_[lane]->bodies[n];
            pullVelocity(bodies, index, n, lane);
            if (moved_) pullPlace(bodies, index, n, lane);
        }
    }
    if (!moved_) return;
    kernel_->place(view_);
    kernel_->setMasses(view_, h_);
    moved_ = false;
}

void JointBatch::writeVelocities(BodyStore& bodies) const {
    for (std::size_t n = 0; n < layout_->moved; ++n) {
        for (std::size_t lane = 0; lane < width_; ++lane) {
            const BodyIndex index = islands_[lane]->bodies[n];
            SolverVelocity& v = bodies.velocity[index];
            v.x = rounded(body(n, BodyField::Vx, lane));
            v.y = rounded(body(n, BodyField::Vy, lane));
            v.w = rounded(body(n, BodyField::Spin, lane) * static_cast<double>(bodies.turn[index].gyration));
        }
    }
}

void JointBatch::writePlaces(BodyStore& bodies) const {
    for (std::size_t n = 0; n < layout_->moved; ++n) {
        for (std::size_t lane = 0; lane < width_; ++lane) {
            const BodyIndex index = islands_[lane]->bodies[n];
            const double gyration = static_cast<double>(bodies.turn[index].gyration);
            bodies.displacement[index] = {rounded(body(n, BodyField::X, lane)), rounded(body(n, BodyField::Y, lane)),
                                          rounded(body(n, BodyField::Sin, lane) * gyration),
                                          rounded((body(n, BodyField::Cos, lane) - 1) * gyration)};
            bodies.turn[index].angle = rounded(body(n, BodyField::Turn, lane));
        }
    }
}

void JointBatch::kick(BodyStore& bodies) {
    for (std::size_t n = 0; n < layout_->moved; ++n) {
        for (std::size_t lane = 0; lane < width_; ++lane) {
            const BodyIndex index = islands_[lane]->bodies[n];
            const SolverVelocity& warm = bodies.warm[index];
            const auto at = [&](int field) -> double& { return body(n, field, lane); };
            const double linear = at(BodyField::KeepLinear), angular = at(BodyField::KeepAngular);
            const double inverseGyration = static_cast<double>(bodies.turn[index].inverseGyration);
            at(BodyField::Vx) = at(BodyField::Vx) * linear + at(BodyField::GainX) + static_cast<double>(warm.x);
            at(BodyField::Vy) = at(BodyField::Vy) * linear + at(BodyField::GainY) + static_cast<double>(warm.y);
            at(BodyField::Spin) =
                at(BodyField::Spin) * angular + at(BodyField::GainSpin) + static_cast<double>(warm.w) * inverseGyration;
        }
    }
    writeVelocities(bodies);
}

void JointBatch::move(BodyStore& bodies, double h) {
    kernel_->move(view_, h);
    moved_ = true;
    writePlaces(bodies);
}

void JointBatch::activate(bool all, std::size_t lane) {
    for (std::size_t l = 0; l < width_; ++l) active_[l] = all || l == lane ? 1 : 0;
}

void JointBatch::noteStates() {
    if (!layout_->someFree) return;
    for (std::size_t i = 0; i < layout_->rows.size(); ++i)
        if (!layout_->rows[i].holds)
            for (std::size_t lane = 0; lane < width_; ++lane)
                row(i, RowField::LastState, lane) = row(i, RowField::State, lane);
}

void JointBatch::solve(BodyStore& bodies, const IslandTurn& turn, StepObserver* observer) {
    if (!bodies.flights.empty()) pull(bodies);  // fields have changed velocities
    kernel_->prepare(view_, turn);
    kernel_->solve(view_);
    noteStates();
    activate(true, 0);
    kernel_->accept(view_);
    kernel_->addLoads(view_);
    if (observer != nullptr) report(*observer);
    kernel_->noteForces(view_, h_);
    writeVelocities(bodies);
}

void JointBatch::hold(BodyStore& bodies, double h, double fastest, std::span<const bool> active,
                      StepObserver* observer) {
    // Repeated where a pass has changed an angular velocity so much that its prediction of the ends is no longer valid.
    constexpr double far = 0.02;
    pull(bodies);
    for (std::size_t lane = 0; lane < width_; ++lane) active_[lane] = active[lane] ? 1 : 0;
    for (int time = 0; time < 3; ++time) {
        kernel_->prepare(view_, {h, true, true, fastest});
        kernel_->solve(view_);
        std::array<double, 8> again{};
        for (std::size_t n = 0; n < layout_->moved; ++n)
            for (std::size_t lane = 0; lane < width_; ++lane)
                if (std::fabs(body(n, BodyField::Uspin, lane) - body(n, BodyField::Spin, lane)) * h > far)
                    again[lane] = active_[lane];
        kernel_->accept(view_);
        kernel_->addLoads(view_);
        if (observer != nullptr) report(*observer);
        active_ = again;
        if (again == std::array<double, 8>{}) break;
    }
    writeVelocities(bodies);
}

Vec3 JointBatch::answer(std::size_t lane, std::size_t node, const Vec3& impulse) {
    kernel_->prepare(view_, {h_, false, false, 0});
    for (std::size_t n = 0; n < layout_->bodies; ++n)
        for (std::size_t l = 0; l < width_; ++l)
            for (int c = 0; c < 3; ++c) body(n, BodyField::Ux + c, l) = body(n, BodyField::Vx + c, l);
    const Vec3 change = changeBy(lane, node, impulse);
    for (int c = 0; c < 3; ++c) body(node, BodyField::Ux + c, lane) += change[static_cast<std::size_t>(c)];
    kernel_->answer(view_);
    Vec3 result{};
    for (int c = 0; c < 3; ++c)
        result[static_cast<std::size_t>(c)] = body(node, BodyField::Ux + c, lane) - body(node, BodyField::Vx + c, lane);
    return result;
}

void JointBatch::push(BodyStore& bodies, std::size_t lane, std::size_t node, const Vec3& impulse) {
    answer(lane, node, impulse);
    activate(false, lane);
    kernel_->accept(view_);
    kernel_->addLoads(view_);
    writeVelocities(bodies);
}

Vec3 JointBatch::changeBy(std::size_t lane, std::size_t node, const Vec3& impulse) const {
    const double mass = body(node, BodyField::Mass, lane), inertia = body(node, BodyField::Inertia, lane);
    return {impulse[0] / mass, impulse[1] / mass, inertia > 0 ? impulse[2] / inertia : 0.0};
}

bool JointBatch::tryFrom(BodyStore& bodies, std::span<const Vec3> before, const IslandTurn& turn) {
    pull(bodies);
    kernel_->prepare(view_, turn);
    for (std::size_t n = 0; n < layout_->moved; ++n)
        for (int c = 0; c < 3; ++c) body(n, BodyField::Vx + c, 0) = before[n][static_cast<std::size_t>(c)];
    const bool changed = kernel_->solve(view_);
    noteStates();
    activate(true, 0);
    kernel_->accept(view_);
    writeVelocities(bodies);
    return changed;
}

void JointBatch::acceptTry(StepObserver* observer) {
    activate(true, 0);
    kernel_->addLoads(view_);
    if (observer != nullptr) report(*observer);
    kernel_->noteForces(view_, h_);
}

void JointBatch::follow(std::span<Vec3> changes) {
    for (std::size_t n = 0; n < layout_->bodies; ++n)
        for (std::size_t c = 0; c < 3; ++c)
            body(n, BodyField::Ux + static_cast<int>(c), 0) = n < changes.size() ? changes[n][c] : 0.0;
    kernel_->follow(view_);
    for (std::size_t n = 0; n < changes.size(); ++n)
        for (std::size_t c = 0; c < 3; ++c) changes[n][c] = body(n, BodyField::Ux + static_cast<int>(c), 0);
}

void JointBatch::report(StepObserver& observer) const {
    for (std::size_t lane = 0; lane < width_; ++lane) {
        if (active_[lane] == 0) continue;
        for (std::size_t j = 0; j < layout_->jointCount(); ++j) {
            Vec3 impulses{}, after{}, slopes{};
            const JointRows rows = rowsOf(j, lane, impulses, after, slopes);
            observer.noteRows(rows, impulses, after, slopes);
        }
    }
}

JointRows JointBatch::rowsOf(std::size_t j, std::size_t lane, Vec3& impulses, Vec3& after, Vec3& slopes) const {
    JointRows rows;
    const std::size_t first = layout_->joints[j].firstRow,
                      links = layout_->joints[j + 1].firstLink - layout_->joints[j].firstLink;
    rows.body.fill(noBody);
    rows.ends = 2 * links;
    for (std::size_t k = 0; k < links; ++k) {
        const IslandLayout::Link& link = layout_->links[layout_->joints[j].firstLink + k];
        rows.body[2 * k] = islands_[lane]->bodyAt(link.a);
        rows.body[2 * k + 1] = islands_[lane]->bodyAt(link.b);
    }
    for (std::size_t i = first; i < layout_->joints[j + 1].firstRow; ++i) {
        const auto at = [&](int field) { return row(i, field, lane); };
        JointRow& added = rows.add();
        const std::size_t r = i - first;
        for (std::size_t k = 0; k < links; ++k) {
            const int axis = k == 0 ? RowField::AxisX : RowField::SecondAxisX;
            const Vec3 a{-at(axis), -at(axis + 1), at(axis + 2)}, b{at(axis), at(axis + 1), at(axis + 3)};
            (k == 0 ? added.at : rows.far) = {a, b};
            const IslandLayout::Link& link = layout_->links[layout_->joints[j].firstLink + k];
            for (int c = 0; c < 3; ++c)
                after[r] += a[static_cast<std::size_t>(c)] * body(link.a, BodyField::Vx + c, lane) +
                            b[static_cast<std::size_t>(c)] * body(link.b, BodyField::Vx + c, lane);
        }
        impulses[r] = at(RowField::Impulse);
        added.holds = layout_->rows[i].holds;
        added.bounded = layout_->rows[i].bounded;
        if (added.holds) continue;
        added.push = at(RowField::Push);
        added.dampPush = at(RowField::DampPush);
        added.low = at(RowField::Low);
        added.high = at(RowField::High);
        slopes[r] = at(RowField::Slope);
    }
    return rows;
}

BodyMove JointBatch::moveOf(std::size_t lane, std::size_t node) const {
    const auto at = [&](int field) { return body(node, field, lane); };
    return {Vec2(at(BodyField::X), at(BodyField::Y)), at(BodyField::Turn), Vec2(at(BodyField::Vx), at(BodyField::Vy)),
            at(BodyField::Spin)};
}

}  // namespace plumb
