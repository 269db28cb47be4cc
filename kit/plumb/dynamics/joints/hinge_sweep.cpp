// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/hinge_sweep.h>

#include <bit>

namespace plumb {

namespace {

constexpr int colours = 64;

/// The batches of one colour, while they are filled.
struct Filling {
    std::vector<HingeBatch> batches;
    std::vector<JointIndex> jointOf;
    std::size_t count = 0;

    /// ratio: of this step to the last one.
    void add(const JointRecord& record, JointIndex index, const AnchorPair& anchors, double ratio) {
        const std::size_t lane = count++ % batchLanes;
        if (lane == 0) {
            batches.push_back(HingeBatch{});
            jointOf.insert(jointOf.end(), batchLanes, none);
        }
        HingeBatch& batch = batches.back();
        jointOf[jointOf.size() - batchLanes + lane] = index;
        batch.bodyA[lane] = anchors.a.body;
        batch.bodyB[lane] = anchors.b.body;
        batch.localXA[lane] = static_cast<float>(anchors.a.local.x());
        batch.localYA[lane] = static_cast<float>(anchors.a.local.y());
        batch.localXB[lane] = static_cast<float>(anchors.b.local.x());
        batch.localYB[lane] = static_cast<float>(anchors.b.local.y());
        batch.impulseX[lane] = static_cast<float>(record.impulse[0] * ratio);
        batch.impulseY[lane] = static_cast<float>(record.impulse[1] * ratio);
    }
};

}  // namespace

std::vector<JointIndex> HingeSweep::take(const std::vector<JointIndex>& joints, const JointStore& store,
                                         const BodyStore& bodies) {
    std::vector<std::uint64_t> used(bodies.record.size(), 0);
    std::vector<Filling> fillings(colours);
    std::vector<JointIndex> left;
    for (const JointIndex index : joints) {
        const auto* hinge = std::get_if<RevoluteJoint>(&store[index].joint);
        if (hinge == nullptr || !hinge->isPlain() || hinge->anchors.a.shift != hinge->anchors.b.shift) {
            left.push_back(index);
            continue;
        }
        const BodyIndex a = hinge->anchors.a.body, b = hinge->anchors.b.body;
        const std::uint64_t taken = (bodies.isDynamic(a) ? used[a] : 0) | (bodies.isDynamic(b) ? used[b] : 0);
        const int colour = std::countr_one(taken);
        if (colour == colours) {
            left.push_back(index);
            continue;
        }
        used[a] |= std::uint64_t{1} << colour;
        used[b] |= std::uint64_t{1} << colour;
        fillings[static_cast<std::size_t>(colour)].add(store[index], index, hinge->anchors, bodies.stepRatio);
    }
    batches_.clear();
    jointOf_.clear();
    for (const Filling& filling : fillings) {
        batches_.insert(batches_.end(), filling.batches.begin(), filling.batches.end());
        jointOf_.insert(jointOf_.end(), filling.jointOf.begin(), filling.jointOf.end());
    }
    generationOf_.clear();
    for (const JointIndex joint : jointOf_) generationOf_.push_back(joint == none ? 0 : store[joint].generation);
    return left;
}

void HingeSweep::release(JointStore& store) const {
    for (std::size_t i = 0; i < jointOf_.size(); ++i) {
        if (jointOf_[i] == none || store[jointOf_[i]].generation != generationOf_[i]) continue;
        const HingeBatch& batch = batches_[i / batchLanes];
        const std::size_t lane = i % batchLanes;
        store[jointOf_[i]].impulse = {static_cast<double>(batch.impulseX[lane]),
                                      static_cast<double>(batch.impulseY[lane]), 0};
    }
}

void HingeSweep::prepare(const HingeSolver& solver, const BodyStore& bodies) {
    solver.prepare(batches_.data(), batches_.size(), bodies.place.data());
}

void HingeSweep::solve(const HingeSolver& solver, const SolverBodies& bodies, const HingePass& pass) {
    solver.warmStart(batches_.data(), batches_.size(), bodies);
    solver.solve(batches_.data(), batches_.size(), bodies, pass);
}

void HingeSweep::addLoads(JointStore& store) const {
    for (std::size_t i = 0; i < jointOf_.size(); ++i) {
        if (jointOf_[i] == none) continue;
        const HingeBatch& batch = batches_[i / batchLanes];
        const std::size_t lane = i % batchLanes;
        store.loads[jointOf_[i]].impulse +=
            Vec2(static_cast<double>(batch.totalX[lane]), static_cast<double>(batch.totalY[lane]));
    }
}

}  // namespace plumb
