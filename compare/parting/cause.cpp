// SPDX-License-Identifier: MIT
#include <compare/parting/cause.h>

#include <algorithm>
#include <cmath>

#include <compare/engine/engine_settings.h>
#include <compare/metric/conserved.h>
#include <compare/metric/mechanics.h>
#include <compare/parting/stretch.h>
#include <compare/parting/touch_cause.h>

namespace plumb::compare {
namespace {

constexpr double partOfIts = 0.5;      // a cause must explain at least this part of the distance [-]
constexpr double alike = 0.01;         // two speeds that differ by less, relative to the larger, are the same [-]
constexpr double partOfItsPull = 0.2;  // the same for gaps if the joints are what pulls [-]

class CauseFinder {
public:
    CauseFinder(const Parted& parted, Parting& parting)
        : parted_(parted), parting_(parting), joints_(parted.scene), touching_(parted.scene) {
        distance_ = parted.offset.norm();
    }

    void find() {
        if (isTrack(parted_.a) || isTrack(parted_.b)) return addSpeeds(Difference::Track);
        if (!isFinite(stateIn(parted_.a)) || !isFinite(stateIn(parted_.b))) return;
        const std::vector<Share> shares = sharesOf(parted_, joints_, touching_);
        if (parted_.scene.bodies[parted_.body].def.type == BodyType::Kinematic)
            return isBySteps(shares) ? addSteps(shares) : addSpeeds(Difference::Driven);
        if (foundBreak() || foundPassed() || foundGap(partOfIts) || shares.empty()) return;
        switch (shares.front().agent) {
            case Agent::Across:
            case Agent::Along: return addTouch(shares.front());
            case Agent::Joints: return addHeld();
            case Agent::Nothing: return addSpeeds(Difference::Flight);
            case Agent::Steps: return addSteps(shares);
        }
    }

private:
    const BodyState& stateIn(const Observation& run) const { return run.states[parted_.tick][parted_.body]; }
    double timeOf(std::size_t tick) const { return static_cast<double>(tick) * parted_.a.dt; }
    const std::string& nameOf(std::size_t body) const { return parted_.scene.bodies[body].name; }

    void add(Difference quantity, const std::string& at, double valueA, double valueB, std::size_t tick) {
        parting_.quantity = quantity;
        parting_.at = at;
        parting_.valueA = valueA;
        parting_.valueB = valueB;
        parting_.when = timeOf(tick);
    }

    bool foundBreak() {
        const std::optional<Widest> broken = firstBreak(parted_, joints_, touching_);
        if (!broken) return false;
        add(Difference::Break, parted_.scene.joints[broken->joint].name, broken->valueA, broken->valueB, broken->tick);
        return true;
    }

    bool foundPassed() {
        const std::optional<Crossing> passed = firstPassed(parted_, joints_, touching_);
        if (!passed) return false;
        add(Difference::Passed, nameOf(passed->body) + ", " + nameOf(passed->obstacle), passed->inA ? 1 : 0,
            passed->inA ? 0 : 1, passed->tick);
        return true;
    }

    bool foundGap(double part) {
        if (parted_.a.partial || parted_.b.partial) return false;
        const std::optional<Widest> gap = widestGap(parted_, joints_);
        if (!gap || gap->together < part * distance_) return false;
        add(Difference::Gap, parted_.scene.joints[gap->joint].name, gap->valueA, gap->valueB, gap->tick);
        return true;
    }

    bool foundOverlap() {
        if (parted_.a.partial || parted_.b.partial) return false;
        const std::optional<Widest> overlap = deepestOverlap(parted_, joints_, touching_);
        if (!overlap || overlap->together < partOfIts * distance_) return false;
        add(Difference::Overlap, nameOf(overlap->bodyA) + ", " + nameOf(overlap->bodyB), overlap->valueA,
            overlap->valueB, overlap->tick);
        return true;
    }

    /// A sudden change says more than the depth of overlaps at that time.
    void addTouch(const Share& share) {
        const TouchCause cause(parted_, share, touching_);
        if (cause.isSudden() || share.agent == Agent::Along || !foundOverlap()) cause.add(parting_);
    }

    static bool isTouch(const Share& share) { return share.agent == Agent::Across || share.agent == Agent::Along; }

    static bool isBySteps(const std::vector<Share>& shares) {
        return !shares.empty() && shares.front().agent == Agent::Steps;
    }

    /// Different speeds are not from where steps place the body: another share must have made them.
    void addSteps(const std::vector<Share>& shares) {
        const double a = stateIn(parted_.a).velocity.norm(), b = stateIn(parted_.b).velocity.norm();
        if (std::abs(a - b) > alike * std::max(a, b)) {
            const auto touch = std::ranges::max_element(
                shares, {}, [](const Share& share) { return isTouch(share) ? std::abs(share.length) : -1; });
            return isTouch(*touch) ? addTouch(*touch) : addSpeeds(Difference::Flight);
        }
        if (!jointOf(parted_.body) || !foundEnergy())
            add(Difference::Steps, nameOf(parted_.body), shares.front().length, 0, parted_.tick);
    }

    void addHeld() {
        if (foundGap(partOfItsPull) || foundEnergy()) return;
        addSpeeds(Difference::Pull);
        if (const std::optional<std::size_t> joint = jointOf(parted_.body))
            parting_.at = parted_.scene.joints[*joint].name;
    }

    /// Of the joints that hold the body itself, the one whose gap differs most; the first of equals.
    std::optional<std::size_t> jointOf(std::size_t body) const {
        std::optional<std::size_t> found;
        double most = -1;
        for (std::size_t i = 0; i < joints_.joints().size(); ++i) {
            const std::vector<std::size_t> held = bodiesOf(joints_.joints(), i);
            if (std::ranges::find(held, body) == held.end()) continue;
            const double a = joints_.gap(i, parted_.a.states[parted_.tick]);
            const double apart = std::abs(a - joints_.gap(i, parted_.b.states[parted_.tick]));
            if (apart <= most) continue;
            most = apart;
            found = i;
        }
        return found;
    }

    /// The length of the body's way in a run so far [m].
    double wayIn(const Observation& run) const {
        double way = 0;
        for (std::size_t tick = 0; tick < parted_.tick; ++tick)
            way += (centerIn(parted_, run, tick + 1) - centerIn(parted_, run, tick)).norm();
        return way;
    }

    struct Gain {
        double gained = 0, size = 0;  ///< gained so far; the largest kinetic or potential energy in the run [J]
    };
    std::optional<Gain> gainIn(const MassModel& masses, const Observation& run) const {
        const std::optional<Mechanics> start = masses.at(run.states[0]);
        if (!start) return {};
        Gain gain;
        for (std::size_t tick = 1; tick < run.states.size(); ++tick) {
            const std::optional<Mechanics> now = masses.at(run.states[tick]);
            if (!now) return {};
            const double stored = now->lifted - start->lifted + now->elastic - start->elastic;
            if (tick == parted_.tick) gain.gained = now->kinetic - start->kinetic + stored;
            gain.size = std::max({gain.size, now->kinetic, std::abs(stored)});
        }
        return gain;
    }

    bool foundEnergy() {
        for (const Observation* run : {&parted_.a, &parted_.b})
            if (!keepsEnergy(sceneFor(run->engine, parted_.scene))) return false;
        const MassModel masses(parted_.scene);
        const std::optional<Gain> a = gainIn(masses, parted_.a), b = gainIn(masses, parted_.b);
        if (!a || !b || !(a->size > 0) || !(b->size > 0)) return false;
        const double gainA = a->gained / a->size, gainB = b->gained / b->size;
        if (std::abs(gainA - gainB) * wayIn(parted_.a) < partOfIts * distance_) return false;
        add(Difference::Energy, nameOf(parted_.body), gainA, gainB, parted_.tick);
        return true;
    }

    void addSpeeds(Difference quantity) {
        add(quantity, nameOf(parted_.body), stateIn(parted_.a).velocity.norm(), stateIn(parted_.b).velocity.norm(),
            parted_.tick);
    }

    const Parted& parted_;
    Parting& parting_;
    JointStates joints_;
    Touching touching_;
    double distance_ = 0;
};

}  // namespace

void addCause(const Parted& parted, Parting& parting) {
    CauseFinder(parted, parting).find();
}

}  // namespace plumb::compare
