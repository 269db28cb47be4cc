// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joints/joint_springs.h>

#include <algorithm>
#include <cmath>

#include <plumb/dynamics/joints/joint_measure.h>
#include <plumb/math/detail/step_list.h>
#include <plumb/math/trig.h>

namespace plumb {

namespace {

constexpr double mostF = 1.8;
constexpr double lastPhase = 1.4706289056333368;  ///< 4 sin^2(lastPhase / 2) = mostF [rad]

/// F(q) / q.
double shareOf(double q) {
    if (q < 1e-12) return 1;
    const double phase = std::sqrt(q);
    if (phase >= lastPhase) return mostF / q;
    const double s = 2 * sinCos(0.5 * phase).sin;
    return s * s / q;
}

/// The part of one end in the row's effective inverse mass [1/kg].
double effectiveInverseMass(const BodyStore& bodies, BodyIndex body, const Vec3& at) {
    if (!bodies.canMove(body)) return 0;
    const BodyRecord& record = bodies.record[body];
    return record.inverseMass * (at[0] * at[0] + at[1] * at[1]) + record.inverseInertia * at[2] * at[2];
}

/// Do the springs only turn bodies? Then their part in the bodies' inverse inertia does not change from step to step.
bool onlyTurns(const JointIsland& island) {
    return !island.isSwept() && std::all_of(island.sprung.begin(), island.sprung.end(),
                                            [&](std::uint32_t j) { return island.laid[j].form.springsOnlyTurn(); });
}

/// Calls visit(joint, its form) for each joint with springs.
template <class Visit>
void forEachSprung(const StepList<JointIsland*>& islands, const JointStore& store, Visit&& visit) {
    for (const JointIsland* island : islands)
        for (const std::uint32_t j : island->sprung) {
            const JointIndex joint = island->joints[j];
            island->isSwept() ? visit(joint, store.formOf(joint)) : visit(joint, island->laid[j].form);
        }
}

void shareAmong(const StepList<JointIsland*>& islands, JointStore& store, const BodyStore& bodies, double h) {
    StepList<double> load(bodies.record.size(), 0.0);  // of each body: sum over its springs of k w [1/s^2]
    forEachSprung(islands, store, [&](JointIndex joint, const JointForm& form) {
        const SpringLoad springs = springLoadOf(form, bodies);
        const std::array<BodyIndex, 2> ends{store[joint].bodyA, store[joint].bodyB};
        for (std::size_t r = 0; r < springs.count; ++r)
            for (std::size_t e = 0; e < 2; ++e)
                load[ends[e]] += springs.row[r].stiffness * effectiveInverseMass(bodies, ends[e], springs.row[r].at[e]);
    });
    forEachSprung(islands, store, [&](JointIndex joint, const JointForm&) {
        store[joint].springShare = shareOf(h * h * (load[store[joint].bodyA] + load[store[joint].bodyB]));
    });
}

double springEnergyOf(const SpringLoad& load) {
    double squares = 0, energy = 0, stiffness = 0;
    for (std::size_t r = 0; r < load.count; ++r) {
        const SpringLoad::Row& row = load.row[r];
        energy += 0.5 * row.stiffness * row.stretch * row.stretch;
        squares += row.stretch * row.stretch;
        stiffness = row.stiffness;
    }
    const double stretch = std::sqrt(squares);
    if (stiffness * stretch <= load.mostForce) return energy;
    return load.mostForce * (stretch - 0.5 * load.mostForce / stiffness);  // its force is limited to mostForce
}

}  // namespace

void shareSprings(JointIslands& found, JointStore& store, const BodyStore& bodies, double h) {
    StepList<JointIsland*> islands;
    for (JointIsland& island : found.islands) {
        if (island.sprung.empty() || island.shared == h) continue;
        islands.push_back(&island);
        if (onlyTurns(island)) island.shared = h;
    }
    if (!islands.empty()) shareAmong(islands, store, bodies, h);
}

double springEnergy(const JointStore& joints, const BodyStore& bodies) {
    double energy = 0;
    const auto inRange = [&](BodyIndex body) { return isInRange(bodies.motion[body]); };
    for (JointIndex joint = 0; joint < joints.records.size(); ++joint)
        if (joints.hasSpring(joint) && inRange(joints[joint].bodyA) && inRange(joints[joint].bodyB))
            energy += springEnergyOf(springLoadOf(joints.formOf(joint), bodies));
    return energy;
}

}  // namespace plumb
