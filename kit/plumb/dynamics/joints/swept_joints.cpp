// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/swept_joints.h>

#include <algorithm>
#include <bit>
#include <tuple>

#include <plumb/dynamics/joints/joint_rows.h>
#include <plumb/math/detail/sorting.h>

namespace plumb {

namespace {

using N = SweptField;

constexpr int colours = 64;  ///< a joint without a colour has a batch of its own

SweptForm shapeOf(const JointForm& form) {
    SweptForm shape{.links = static_cast<std::uint8_t>(form.links), .rows = static_cast<std::uint8_t>(form.rows)};
    if (form.links > 1) shape.secondAxis = form.secondAxis;
    shape.secondAlongY = form.secondDirection.y() != 0;
    shape.turnsOnly = form.turnsOnly;
    std::size_t fields = N::joint + form.links * N::link;
    for (std::size_t r = 0; r < form.rows; ++r) {
        const RowForm& row = form.row[r];
        const bool isWorld = row.axis == RowAxis::World;
        shape.axis[r] = row.axis;
        shape.alongY[r] = isWorld && row.direction.y() != 0;
        shape.holds[r] = row.holds;
        shape.bounded[r] = row.bounded;
        if (isWorld && row.holds && form.links == 1) continue;
        shape.first[r] = static_cast<std::uint8_t>(fields);
        int own = N::held;
        if (row.axis == RowAxis::OnA) own = N::directed;
        if (!row.holds) own = N::free;
        if (form.links > 1) own = N::twofold;
        fields += static_cast<std::size_t>(own);
    }
    shape.fields = static_cast<std::uint8_t>(fields);
    return shape;
}

/// The lowest colour that no joint of its bodies has yet; colours if there is none.
int colourOf(const JointForm& form, std::vector<std::uint64_t>& used, const BodyStore& bodies) {
    std::uint64_t taken = 0;
    for (std::size_t k = 0; k < form.links; ++k)
        for (const BodyIndex body : {form.link[k].a.body, form.link[k].b.body})
            if (bodies.isDynamic(body)) taken |= used[body];
    const int colour = std::countr_one(taken);
    for (std::size_t k = 0; k < form.links && colour < colours; ++k)
        for (const BodyIndex body : {form.link[k].a.body, form.link[k].b.body})
            used[body] |= std::uint64_t{1} << colour;
    return colour;
}

}  // namespace

void SweptJoints::take(const std::vector<JointIndex>& joints, const std::vector<LaidJoint>& laid,
                       const JointStore& store, const BodyStore& bodies) {
    struct Place {
        int colour = 0;
        std::uint32_t shape = 0, joint = 0;
    };
    *this = {};
    std::vector<std::uint64_t> used(bodies.record.size(), 0);
    std::vector<SweptForm> shapes;
    std::vector<Place> places;
    for (std::uint32_t j = 0; j < joints.size(); ++j) {
        const SweptForm shape = shapeOf(laid[j].form);
        const auto known = std::find(shapes.begin(), shapes.end(), shape);
        places.push_back({colourOf(laid[j].form, used, bodies), static_cast<std::uint32_t>(known - shapes.begin()), j});
        if (known == shapes.end()) shapes.push_back(shape);
    }
    sortBy(places, [](const Place& place) { return std::tuple(place.colour, place.shape); });
    std::size_t lane = 0;
    for (std::size_t i = 0; i < places.size(); ++i, ++lane) {
        const Place& place = places[i];
        if (i == 0 || lane == batchLanes || place.colour == colours || place.colour != places[i - 1].colour ||
            place.shape != places[i - 1].shape) {
            const SweptForm& shape = shapes[place.shape];
            batches_.push_back({shape, shape == plainHinge, fields_.size(), slots_.size()});
            fields_.resize(fields_.size() + shape.fields);
            slots_.resize(slots_.size() + std::size_t{2} * shape.links);
            jointOf_.resize(jointOf_.size() + batchLanes, none);
            lane = 0;
        }
        const JointIndex joint = joints[place.joint];
        jointOf_[jointOf_.size() - batchLanes + lane] = joint;
        add(joint, laid[place.joint].form, store[joint], bodies.stepRatio, lane);
    }
    for (const JointIndex joint : jointOf_) generationOf_.push_back(joint == none ? 0 : store[joint].generation);
}

/// ratio: of this step to the last one.
void SweptJoints::add(JointIndex joint, const JointForm& form, const JointRecord& record, double ratio,
                      std::size_t lane) {
    const SweptBatch& batch = batches_.back();
    const auto set = [&](std::size_t field, double value) {
        fields_[batch.fields + field].of[lane] = static_cast<float>(value);
    };
    for (std::size_t k = 0; k < form.links; ++k) {
        const Anchor &a = form.link[k].a, &b = form.link[k].b;
        const std::size_t first = N::joint + k * N::link;
        slots_[batch.bodies + 2 * k].of[lane] = a.body;
        slots_[batch.bodies + 2 * k + 1].of[lane] = b.body;
        for (std::size_t c = 0; c < 2; ++c) {
            const int i = static_cast<int>(c);
            set(first + N::LocalAx + c, a.local[i]);
            set(first + N::LocalBx + c, b.local[i]);
            set(first + N::ShiftX + c, b.shift[i] - a.shift[i]);
        }
    }
    for (std::size_t r = 0; r < form.rows; ++r) {
        set(N::Impulse + r, record.impulse[r] * ratio);
        if (batch.shape.first[r] > 0) addRow(joint, form, r, lane);
    }
}

void SweptJoints::addRow(JointIndex joint, const JointForm& form, std::size_t r, std::size_t lane) {
    const std::size_t first = batches_.back().fields + batches_.back().shape.first[r];
    const RowForm& row = form.row[r];
    const auto set = [&](std::size_t field, double value) {
        fields_[first + field].of[lane] = static_cast<float>(value);
    };
    angles_.push_back({first + N::Origin, lane, row.origin, form.link, {}});
    if (row.axis == RowAxis::Turning) angles_.back().ratio[0] = 1;
    if (form.links > 1 && form.secondAxis == RowAxis::Turning) angles_.back().ratio[1] = form.ratio;
    set(N::Origin, row.origin);
    if (angles_.back().ratio == std::array<double, maxLinks>{}) angles_.pop_back();
    if (form.links == 1 && row.holds && row.axis != RowAxis::OnA) return;
    set(N::LocalX, row.direction.x());
    set(N::LocalY, row.direction.y());
    if (form.links > 1) {
        set(N::SecondLocalX, form.secondDirection.x());
        set(N::SecondLocalY, form.secondDirection.y());
        set(N::Ratio, form.ratio);
    }
    if (row.holds) return;
    const double values[] = {row.speed,          row.rate,        boundOf(row.maxForce),
                             row.limit.lower,    row.limit.upper, row.spring.stiffness,
                             row.spring.damping, row.springRest};
    for (std::size_t i = 0; i < std::size(values); ++i) set(N::Speed + i, values[i]);
    if (row.spring.stiffness > 0) springs_.push_back({first + N::Stiffness, lane, joint, row.spring.stiffness});
}

void SweptJoints::release(JointStore& store) const {
    for (std::size_t i = 0; i < jointOf_.size(); ++i) {
        if (jointOf_[i] == none || store[jointOf_[i]].generation != generationOf_[i]) continue;
        const SweptBatch& batch = batches_[i / batchLanes];
        for (std::size_t r = 0; r < batch.shape.rows; ++r)
            store[jointOf_[i]].impulse[r] =
                static_cast<double>(fields_[batch.fields + N::Impulse + r].of[i % batchLanes]);
    }
}

void SweptJoints::prepare(const SweptKernel& kernel, const JointStore& store, const BodyStore& bodies) {
    for (const Angle& angle : angles_) {
        double origin = angle.origin;
        for (std::size_t k = 0; k < maxLinks; ++k)
            if (angle.ratio[k] != 0)
                origin -= angle.ratio[k] *
                          (bodies.motion[angle.link[k].b.body].angle - bodies.motion[angle.link[k].a.body].angle);
        fields_[angle.field].of[angle.lane] = static_cast<float>(origin);
    }
    for (const Stiffness& spring : springs_)
        fields_[spring.field].of[spring.lane] = static_cast<float>(spring.stiffness * store[spring.joint].springShare);
    for (const SweptBatch& batch : batches_)
        kernel.prepare(batch, fields_[batch.fields].of, slots_[batch.bodies].of, bodies.place.data());
}

void SweptJoints::solve(const SweptKernel& kernel, BodyStore& bodies, SweptPass pass, StepObserver* observer) {
    const SolverBodies all = bodies.solverBodies();
    std::vector<float> told(observer != nullptr ? maxRows * N::told * batchLanes : 0);
    for (const bool isFirstGuess : {true, false}) {
        pass.isFirstGuess = isFirstGuess;
        pass.told = isFirstGuess || observer == nullptr ? nullptr : told.data();
        for (std::size_t i = 0; i < batches_.size(); ++i) {
            const SweptBatch& batch = batches_[i];
            kernel.solve(batch, fields_[batch.fields].of, slots_[batch.bodies].of, all, pass);
            if (pass.told != nullptr && !batch.isPlain) tell(batch, &jointOf_[i * batchLanes], pass.told, *observer);
        }
    }
}

/// Tells the observer what the rows of a batch have given.
void SweptJoints::tell(const SweptBatch& batch, const JointIndex* joints, const float* told,
                       StepObserver& observer) const {
    for (std::size_t lane = 0; lane < batchLanes && joints[lane] != none; ++lane) {
        JointRows rows;
        rows.body.fill(noBody);
        rows.ends = std::size_t{2} * batch.shape.links;
        for (std::size_t e = 0; e < rows.ends; ++e) rows.body[e] = slots_[batch.bodies + e].of[lane];
        Vec3 impulses{}, after{}, slopes{};
        for (std::size_t r = 0; r < batch.shape.rows; ++r) {
            const auto at = [&](std::size_t field) {
                return static_cast<double>(told[(r * N::told + field) * batchLanes + lane]);
            };
            JointRow& row = rows.add();
            row.at = {Vec3{-at(N::AxisX), -at(N::AxisY), at(N::TurnA)}, Vec3{at(N::AxisX), at(N::AxisY), at(N::TurnB)}};
            rows.far = {Vec3{-at(N::SecondX), -at(N::SecondY), at(N::SecondTurnA)},
                        Vec3{at(N::SecondX), at(N::SecondY), at(N::SecondTurnB)}};
            row.holds = batch.shape.holds[r];
            row.bounded = batch.shape.bounded[r];
            row.push = at(N::Push);
            row.high = at(N::High);
            row.low = -row.high;
            impulses[r] = at(N::Given);
            after[r] = at(N::After);
            slopes[r] = at(N::Slope);
        }
        observer.noteRows(rows, impulses, after, slopes);
    }
}

void SweptJoints::addLoads(JointStore& store) const {
    for (std::size_t i = 0; i < jointOf_.size(); ++i) {
        if (jointOf_[i] == none) continue;
        const auto at = [&](std::size_t field) {
            return static_cast<double>(fields_[batches_[i / batchLanes].fields + field].of[i % batchLanes]);
        };
        JointLoad& load = store.loads[jointOf_[i]];
        load.impulse += Vec2(at(N::LoadX), at(N::LoadY));
        load.turning += at(N::LoadTurn);
    }
}

}  // namespace plumb
