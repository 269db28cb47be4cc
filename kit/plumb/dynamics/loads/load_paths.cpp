// SPDX-License-Identifier: MIT
#include <plumb/dynamics/loads/load_paths.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace plumb {

namespace {

// Passes over a group end when they change no speed by more than this:
constexpr float stillPath = 1e-2f;   ///< along a path [m/s]
constexpr float stillPoint = 1e-4f;  ///< at a point [m/s]
// or after as many passes as a quarter of the ratio of masses, between these bounds:
constexpr float fewPasses = 4, manyPasses = 32;

/// Times that a path is corrected [-]: each time but the last, it may have got stuck at a point without load.
constexpr int tries = 3;

/// The one nearer to zero; 0 if they have different signs.
float lesser(float a, float b) {
    if (!(a * b > 0)) return 0;
    return std::fabs(a) < std::fabs(b) ? a : b;
}

}  // namespace

LoadPaths::LoadPaths(ContactGraph& graph, const ContactStore& contacts, BodyStore& bodies,
                     std::span<const BodyIndex> solved, const ContactPasses& passes)
    : bodies_(bodies), passes_(passes), finder_(list_, graph, contacts, bodies) {
    finder_.findAll(solved);
    hidden_.resize(list_.contacts.size());
}

void LoadPaths::begin() {
    for (LoadedContact& c : list_.contacts) c.start = impulsesOf(*c.batch, c.lane);
    for (const LoadGroup& group : list_.groups)
        for (const std::uint32_t contact : group.contacts) hide(contact);
}

/// With zero masses, and apart, a contact changes nothing. It stays in its slot, so the lanes need no test of their
/// own, and its place in the order of colours does not change.
void LoadPaths::hide(std::size_t contact) {
    const LoadedContact& c = list_.contacts[contact];
    Hidden& hidden = hidden_[contact];
    for (int i = 0; i < 2; ++i) {
        PointLanes& p = c.batch->points[i];
        hidden.normalMass[i] = std::exchange(p.normalMass[c.lane], 0.0f);
        hidden.tangentMass[i] = std::exchange(p.tangentMass[c.lane], 0.0f);
        hidden.separation[i] = std::exchange(p.separation[c.lane], 1.0f);
    }
    hidden.rollMass = std::exchange(c.batch->rollMass[c.lane], 0.0f);
}

/// ContactSolver::relax has computed new separations, in hidden lanes too; solve uses the stored ones, so they come
/// back.
void LoadPaths::show(std::size_t contact, bool isRelax) {
    const LoadedContact& c = list_.contacts[contact];
    const Hidden& hidden = hidden_[contact];
    for (int i = 0; i < 2; ++i) {
        PointLanes& p = c.batch->points[i];
        p.normalMass[c.lane] = hidden.normalMass[i];
        p.tangentMass[c.lane] = hidden.tangentMass[i];
        if (!isRelax) p.separation[c.lane] = hidden.separation[i];
    }
    c.batch->rollMass[c.lane] = hidden.rollMass;
}

void LoadPaths::solve() {
    repeat(false,
           [this](const LoadedContact& c) { solveLane(*c.batch, c.lane, bodies_.solverBodies(), firmPassOf(c)); });
}

void LoadPaths::relax() {
    repeat(true,
           [this](const LoadedContact& c) { relaxLane(*c.batch, c.lane, bodies_.solverBodies(), passOf(c), c.start); });
}

template <class SolveContact>
void LoadPaths::repeat(bool isRelax, SolveContact&& solveContact) {
    for (const LoadGroup& group : list_.groups) {
        for (const std::uint32_t contact : group.contacts) show(contact, isRelax);
        const int most = static_cast<int>(std::clamp(0.25f * group.ratio, fewPasses, manyPasses));
        for (int i = 0; i < most; ++i)
            if (pass(group, isRelax, solveContact)) break;
    }
}

/// Corrects each path, then each contact of a group. Returns true if that changed little.
template <class SolveContact>
bool LoadPaths::pass(const LoadGroup& group, bool isRelax, SolveContact&& solveContact) {
    bool isStill = true;
    for (const std::uint32_t path : group.paths) isStill = correct(list_.paths[path], isRelax) && isStill;
    for (const std::uint32_t contact : group.contacts) {
        const LoadedContact& c = list_.contacts[contact];
        const ContactImpulses before = impulsesOf(*c.batch, c.lane);
        solveContact(c);
        for (int i = 0; i < 2; ++i) {
            const PointLanes& p = c.batch->points[i];
            const float change = std::fabs(p.normalImpulse[c.lane] - before.normal[i]);
            isStill = isStill && change <= stillPoint * p.normalMass[c.lane];
        }
    }
    return isStill;
}

const ContactPass& LoadPaths::passOf(const LoadedContact& contact) const {
    return passes_.of(contact.isGround);
}

/// The compliance of a contact's spring, times the contact's effective mass [-]. From massScale = 1 / (1 + c) and
/// impulseScale = c / (1 + c), see Softness: c = impulseScale / massScale.
float LoadPaths::complianceOf(const LoadedContact& contact) const {
    const Softness& soft = passOf(contact).soft;
    return contact.compliance * soft.impulseScale / std::max(soft.massScale, 1e-6f);
}

/// With a spring as firm as the load on it needs: the same two scales, from the smaller compliance.
ContactPass LoadPaths::firmPassOf(const LoadedContact& contact) const {
    ContactPass pass = passOf(contact);
    const float compliance = complianceOf(contact);
    pass.soft.massScale = 1 / (1 + compliance);
    pass.soft.impulseScale = compliance / (1 + compliance);
    return pass;
}

/// Corrects the sum of a path's errors. The first point that would have to pull stops the change (Change::least): it
/// carries nothing any more, and the load needs another path. Returns true if that changed little.
bool LoadPaths::correct(LoadPath& path, bool isRelax) {
    bool isStill = true;
    for (int i = 0; i < tries; ++i) {
        const float inverseMass = path.inverseMass(bodies_);
        const Change change = isRelax ? changeToRelax(path, inverseMass) : changeToSolve(path, inverseMass);
        const float load = std::max(change.wanted, change.least);
        push(path, load, isRelax);
        isStill = isStill && std::fabs(load) * inverseMass <= stillPath;
        if (load == change.wanted || !(impulseAt(path.rows.front(), isRelax) > 0)) break;
        finder_.findAgain(path, isRelax);
    }
    return isStill;
}

/// The formula of the header. As in single contacts, a gap is closed within the sub-step and has no spring; an overlap
/// has the bias speed of its spring, and its compliance, or the push speed without it.
LoadPaths::Change LoadPaths::changeToSolve(const LoadPath& path, float inverseMass) const {
    float error = speedAlong(path), compliance = 0, least = -std::numeric_limits<float>::infinity();
    for (const LoadRow& row : path.rows) {
        const LoadedContact& c = list_.contacts[row.contact];
        const PointLanes& p = c.batch->points[row.point];
        const float s = p.separation[c.lane];
        least = std::max(least, -impulseAt(row, false) / row.share);
        if (s > 0) {
            error += row.share * s * passes_.loose.inverseStep;
            continue;
        }
        const ContactPass& pass = passOf(c);
        const float bias = std::max(pass.soft.biasRate * s, -pass.pushSpeed),
                    rowCompliance = bias > -pass.pushSpeed ? complianceOf(c) / p.normalMass[c.lane] : 0;
        error += row.share * (bias + rowCompliance * p.normalImpulse[c.lane]);
        compliance += row.share * row.share * rowCompliance;
    }
    return {-error / (inverseMass + compliance), least};
}

/// Without springs and bias, as relaxing is: only gaps may still close.
LoadPaths::Change LoadPaths::changeToRelax(const LoadPath& path, float inverseMass) const {
    float error = speedAlong(path), least = -std::numeric_limits<float>::infinity();
    for (const LoadRow& row : path.rows) {
        const LoadedContact& c = list_.contacts[row.contact];
        error += row.share * std::max(c.batch->points[row.point].separation[c.lane], 0.0f) * passes_.loose.inverseStep;
        least = std::max(least, -impulseAt(row, true) / row.share);
    }
    return {-error / inverseMass, least};
}

/// The sum of the speeds at which the points open, by their shares [m/s].
float LoadPaths::speedAlong(const LoadPath& path) const {
    float sum = 0;
    for (const LoadEffect& e : path.effects) {
        const SolverVelocity& v = bodies_.velocity[e.body];
        sum += e.x * v.x + e.y * v.y + e.w * v.w;
    }
    return sum;
}

/// The impulse of a point, which it can lose at the most [N s]. While relaxing, that is the sum of both halves, so that
/// what solve has applied to correct positions can be taken back.
float LoadPaths::impulseAt(const LoadRow& row, bool isRelax) const {
    const LoadedContact& c = list_.contacts[row.contact];
    return (isRelax ? c.start.normal[row.point] : 0.0f) + c.batch->points[row.point].normalImpulse[c.lane];
}

/// Applies a load to all of a path at once: velocities by the effects, impulses by the shares.
void LoadPaths::push(const LoadPath& path, float load, bool isRelax) {
    for (const LoadEffect& e : path.effects) {
        SolverVelocity& v = bodies_.velocity[e.body];
        const float change = v.inverseMass * load;
        v.x += change * e.x;
        v.y += change * e.y;
        v.w += change * e.w;
    }
    for (const LoadRow& row : path.rows) {
        const LoadedContact& c = list_.contacts[row.contact];
        PointLanes& p = c.batch->points[row.point];
        const float old = p.normalImpulse[c.lane];
        const float now =
            std::max(old + row.share * load, isRelax ? -c.start.normal[row.point] : 0.0f);  // no rounding below
        p.normalImpulse[c.lane] = now;
        if (isRelax) p.totalNormal[c.lane] = std::max(p.totalNormal[c.lane] + (now - old), 0.0f);
    }
}

/// A heavy body that was stopped in this step needs no such impulse in the next. Of the two halves of the last
/// sub-step, the lesser impulse is what was needed all the time, as of a weight at rest.
void LoadPaths::end() {
    for (const LoadGroup& group : list_.groups) {
        for (const std::uint32_t contact : group.contacts) {
            const LoadedContact& c = list_.contacts[contact];
            for (int i = 0; i < 2; ++i) {
                PointLanes& p = c.batch->points[i];
                p.normalImpulse[c.lane] = lesser(p.normalImpulse[c.lane], c.start.normal[i]);
                p.tangentImpulse[c.lane] = lesser(p.tangentImpulse[c.lane], c.start.tangent[i]);
            }
        }
    }
}

}  // namespace plumb
