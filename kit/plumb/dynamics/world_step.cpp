// SPDX-License-Identifier: MIT
// How does a world move forward by one step? The phases in their order. Each phase belongs to one folder, and takes the
// stores that it reads and writes. README.md lists them.
#include <algorithm>
#include <chrono>

#include <plumb/dynamics/contacts/bounds.h>
#include <plumb/dynamics/contacts/narrow_phase.h>
#include <plumb/dynamics/edit/edits.h>
#include <plumb/dynamics/edit/joint_edits.h>
#include <plumb/dynamics/edit/step_edits.h>
#include <plumb/dynamics/fields/field_flight.h>
#include <plumb/dynamics/impacts/chain_slides.h>
#include <plumb/dynamics/impacts/flight_stops.h>
#include <plumb/dynamics/impacts/isolated_impacts.h>
#include <plumb/dynamics/islands/sleep.h>
#include <plumb/dynamics/islands/wake.h>
#include <plumb/dynamics/ledger/step_audit.h>
#include <plumb/dynamics/loads/push_apart.h>
#include <plumb/dynamics/meetings/wall_impact.h>
#include <plumb/dynamics/sensors/sensors.h>
#include <plumb/dynamics/solver/solver.h>
#include <plumb/dynamics/world.h>
#include <plumb/math/check.h>

namespace plumb {

namespace {

/// The shortest step that is solved [s]. In less time no contact or joint makes a difference, and 1/dt may leave the
/// range of the solver's floats. In a shorter step bodies only move on. Test: "a step of 1 s is taken, and one of 1.001
/// s refused; one of 0.9 ns meets nothing, one of 1.1 ns does"
constexpr double shortestSolved = 1e-9;

/// Impulses of the last step are the first guess of this one; if the step's length has changed, they change with it.
void noteSolved(BodyStore& bodies, double dt) {
    bodies.stepRatio = bodies.lastSolved > 0 ? dt / bodies.lastSolved : 1;
    bodies.lastSolved = dt;
}

/// Runs the phases of one step, measures their times, and keeps account of energy and momentum.
class Step {
public:
    Step(WorldState& world, double dt) : world(world), dt(dt), watch_(world.profile) {
        // Events and trajectories are those of the last step only. What edits have changed since then is closed in the
        // account before any phase changes more.
        world.events.clear();
        world.sensors.begins.clear();
        world.sensors.ends.clear();
        world.trajectories.clear();
        if (world.account) audit_.emplace(*world.account, viewOf(world));
        if (world.account) world.account->close(viewOf(world), &EnergyLedger::edits, &MomentumLedger::edits);
        if (dt > 0) world.bodies.lastStep = dt;
        if (dt >= shortestSolved) noteSolved(world.bodies, dt);
        if (dt > 0) world.profile = {};
    }

    /// Runs one phase, with its time and its change of energy noted around it, so that phases need know nothing of
    /// either. time: the entry to which the phase's time is added. energy: the entry for the energy change without a
    /// noted cause.
    template <class Phase>
    void run(Phase&& phase, double StepProfile::*time, double EnergyLedger::*energy) {
        watch_.start(time);
        phase(*this);
        if (world.account) world.account->close(viewOf(world), energy, &MomentumLedger::solver);
    }

    /// Forces act for one step; flights and notes of placed bodies are those of one step, too.
    void end() {
        watch_.stop();
        if (dt > 0) clearForces(world.bodies);
        if (dt >= shortestSolved) clearPlaced(world.bodies);
        if (dt > 0) clearFlights(world.fields, world.bodies);
        WorldEvents& events = world.events;
        events.movers = world.bodies.awake;
        events.movers.insert(events.movers.end(), events.sleepers.begin(), events.sleepers.end());
        events.gone.clear();
        events.reportedEnds = events.ends.size();
    }

    static LedgerView viewOf(const WorldState& w) {
        return {w.bodies, w.fields, w.graph, w.joints, w.space, *w.jointSolver};
    }
    StepObserver* observer() { return audit_ ? &*audit_ : nullptr; }
    MeetingStores meetingStores() { return {world.graph, world.contacts, world.bodies, world.space, observer()}; }
    void wake(std::span<const BodyIndex> named) { wakeIslands(world.bodies, world.contacts, world.joints, named); }
    void report(const TouchEvents& touches) { world.events.add(touches, world.bodies, world.space, world.tiles); }

    WorldState& world;
    double dt;

private:
    /// Measures the time of the phases. Nothing else depends on it.
    class Stopwatch {
    public:
        explicit Stopwatch(StepProfile& profile) : profile_(profile) {}
        void start(double StepProfile::*phase) {
            if (phase == phase_) return;
            stop();
            phase_ = phase;
        }
        void stop() {
            const Clock::time_point now = Clock::now();
            if (phase_ != nullptr) {
                const double time = std::chrono::duration<double>(now - last_).count();
                profile_.*phase_ += time;
                profile_.total += time;
            }
            phase_ = nullptr;
            last_ = now;
        }

    private:
        using Clock = std::chrono::steady_clock;
        StepProfile& profile_;
        double StepProfile::*phase_ = nullptr;
        Clock::time_point last_;
    };

    Stopwatch watch_;
    std::optional<StepAudit> audit_;
};

void partOverlaps(Step& s) {
    const WorldState& w = s.world;
    pushApart(w.graph, w.contacts, s.world.bodies, w.solver, s.dt);
}

void predict(Step& s) {
    WorldState& w = s.world;
    if (w.fields.empty() || s.dt < shortestFieldStep) return;
    for (FieldIndex field = 0; field < w.fields.records.size(); ++field)
        s.wake(w.fields.solver->gatherAttracted(w.fields, field, w.bodies, w.space));
    w.fields.solver->predictFlights(w.fields, w.bodies, w.space, s.dt);
}

/// Bounds are placed for the motion that is predicted now; which shapes leave them is found out when a query first asks
/// after the step.
void load(Step& s) {
    WorldState& w = s.world;
    w.staleBounds.reset();
    loadBodies(w.bodies, w.space, w.contacts, s.dt);
}

/// Bounds contain the whole predicted motion, so this one search serves all sub-steps.
void findPairs(Step& s) {
    addNewPairs(s.world);
}

/// Near contacts are collided batch by batch: what touches a sleeping body wakes its island, whose contacts are then
/// collided, too.
void collide(Step& s) {
    WorldState& w = s.world;
    NarrowPhase narrow(w.graph, w.contacts, w.bodies, w.space, w.solver.lanes, s.dt);
    narrow.collideSolved();
    while (!narrow.isDone()) s.wake(narrow.collideNear());
    narrow.finish();
    w.events.addEnds(narrow.ends(), w.bodies, w.space);
}

/// After collide, which says which contacts there are, and before solve, from which it takes those that are impacts.
void solveImpacts(Step& s) {
    WorldState& w = s.world;
    ImpactStores stores{s.meetingStores(), w.fields};
    TouchEvents touches = solveIsolatedImpacts(stores, w.trajectories, s.dt, w.hitSpeed);
    if (w.walls > 0)
        for (const WallImpact& impact : stopFlights(stores, w.trajectories, s.dt))
            reportWallImpact(stores, impact, s.dt, w.hitSpeed, touches);
    s.report(touches);
}

/// Slides are found before the solver moves their discs, and placed after it, over what it computed.
void solve(Step& s) {
    WorldState& w = s.world;
    w.graph.sortOverflow(w.contacts);
    StepList<ChainSlideEnd> slides;
    if (w.chainPieces > 0) slides = findChainSlides(w.bodies, w.contacts, w.space, s.dt);
    s.report(solveConstraints(
        {s.meetingStores(), w.fields, w.joints, *w.jointSolver, w.solver, w.walls > 0, w.hitSpeed}, s.dt));
    moveAlongChains(w.bodies, slides, s.dt, s.observer());
}

/// Only now it is known which bodies got no impulse: they go along their closed form, exactly.
void moveFree(Step& s) {
    moveFreeBodies(s.world.bodies, s.dt, s.observer());
}

/// After the solver, which has measured the loads of this step.
void breakOverloaded(Step& s) {
    breakJoints(s.world);
}

void reportTouches(Step& s) {
    WorldState& w = s.world;
    s.report(findTouchEvents(w.graph, w.contacts, w.bodies, w.hitSpeed));
}

/// Puts bodies in quarantine that have left the range of numbers.
void takeOut(Step& s) {
    quarantine(s.world);
}

/// Nearly last, because paths through sensors are those that bodies took in the end.
void watch(Step& s) {
    WorldState& w = s.world;
    watchSensors(w.sensors, w.bodies, w.space, w.trajectories, s.dt);
}

/// Last: a body falls asleep with the state that it has when the step ends.
void sleep(Step& s) {
    WorldState& w = s.world;
    if (w.sleeping)
        for (const BodyIndex body : sleepIslands({w.bodies, w.graph, w.contacts, w.joints, w.space}, w.solver, s.dt))
            w.events.sleepers.push_back(body);
}

/// Seconds are wanted. 16.67 is a frame in milliseconds, and nobody's step.
void requireStep(double dt) {
    constexpr double longest = 1;
    requireNotNegative(dt, "World.step: dt");
    if (dt > longest)
        refuse("World.step: dt", toText(dt) + " s is longer than 1 s: wanted are seconds, not milliseconds; " +
                                     "for a longer time make several steps");
}

}  // namespace

void World::step(double dt) {
    requireStep(dt);
    Step step(*state_, dt);
    const bool moves = dt > 0, solves = dt >= shortestSolved;
    if (solves) step.run(partOverlaps, &StepProfile::pairs, &EnergyLedger::solver);
    if (moves) step.run(predict, &StepProfile::pairs, &EnergyLedger::solver);
    if (moves) step.run(load, &StepProfile::pairs, &EnergyLedger::solver);
    if (moves) step.run(takeOut, &StepProfile::pairs, &EnergyLedger::solver);
    if (solves) step.run(findPairs, &StepProfile::pairs, &EnergyLedger::solver);
    if (solves) step.run(collide, &StepProfile::collide, &EnergyLedger::solver);
    if (solves) step.run(solveImpacts, &StepProfile::impacts, &EnergyLedger::impacts);
    if (solves) step.run(solve, &StepProfile::solve, &EnergyLedger::solver);
    if (moves) step.run(moveFree, &StepProfile::finish, &EnergyLedger::solver);
    if (moves) step.run(breakOverloaded, &StepProfile::finish, &EnergyLedger::breaking);
    if (moves) step.run(reportTouches, &StepProfile::finish, &EnergyLedger::solver);
    if (moves) step.run(takeOut, &StepProfile::finish, &EnergyLedger::solver);
    if (solves) step.run(watch, &StepProfile::finish, &EnergyLedger::solver);
    if (moves) step.run(sleep, &StepProfile::finish, &EnergyLedger::solver);
    step.end();
}

}  // namespace plumb
