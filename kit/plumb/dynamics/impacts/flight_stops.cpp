// SPDX-License-Identifier: MIT
#include <plumb/dynamics/impacts/flight_stops.h>

#include <algorithm>
#include <utility>

namespace plumb {

namespace {

/// Most impacts of a body with walls in a step [-]; after that it stays where it is. The queue of impacts usually sees
/// walls first, so few paths change here.
constexpr int mostFlightStops = 8;

class FlightStops {
public:
    FlightStops(ImpactStores& stores, double dt)
        : stores_(stores), view_{stores.bodies, stores.contacts, stores.space}, dt_(dt) {}

    /// Searches a segment. If its body meets a wall, the segment ends there, the impact is solved, and a new segment
    /// follows to the step's end, which is searched in turn. True if the path has changed; path then replaces the
    /// segment.
    bool stop(const TrajectorySegment& segment, StepList<TrajectorySegment>& path) {
        path = {segment};
        for (int impacts = 0; impacts <= mostFlightStops; ++impacts) {
            TrajectorySegment& last = path.back();
            WallHit hit;
            if (!meets(last, hit)) break;
            const double duration = last.end - last.start, left = (1 - hit.time) * duration;
            last.end -= left;
            // A body that waits stays where it is, though it has kept its velocity: the closed form would move it on.
            if (!isStay(last))
                last.to = moveFreely(last.from, flightLawOf(stores_.bodies, last.body), last.end - last.start);
            const BodyMotion wall = wallMotionAt(hit, duration);
            const BodyRecord& record = stores_.bodies.record[last.body];
            LooseBodies both({velocityOf(wall)}, {velocityOf(last.to), record.inverseMass, record.inverseInertia});
            const WallImpact impact = solveWallImpact(view_, hit, wall, last.to, both);
            if (impact.normalImpulse > 0) impacts_.push_back(impact);
            if (impacts == mostFlightStops || hit.manifold.count == 0) return true;
            BodyMotion on = last.to;
            setVelocity(on, both.b.velocity);
            const FlightLaw law = flightLawOf(stores_.bodies, last.body);
            const TrajectorySegment next{last.body, on, moveFreely(on, law, dt_ - last.end), last.end, dt_};
            path.push_back(next);
        }
        return path.size() > 1;
    }

    StepList<WallImpact> takeImpacts() { return std::move(impacts_); }

private:
    /// Static walls are searched only if the body moved far enough to pass one; kinematic ones always, as they may move
    /// themselves. The sweep is the straight line between the segment's ends.
    bool meets(const TrajectorySegment& segment, WallHit& hit) const {
        const BodyRecord& record = stores_.bodies.record[segment.body];
        const Sweep sweep = sweepBetween(segment.from, segment.to, record);
        const double far = farShare * record.inradius;
        WallSearch search(view_, segment.body, sweep, {segment.start, segment.end}, far);
        if (travelOf(sweep.shift, sweep.turn, record) > far) search.searchStatic();
        search.searchKinematic();
        if (search.first()) hit = *search.first();
        return search.first().has_value();
    }

    ImpactStores& stores_;
    WallView view_;
    double dt_;
    StepList<WallImpact> impacts_;
};

}  // namespace

/// Once a body was stopped, the rest of its segments belongs to a path that it did not take, so they are dropped. What
/// it hit on that path keeps the impulse: to undo that, all later impacts would have to be solved anew.
StepList<WallImpact> stopFlights(ImpactStores& stores, Trajectories& trajectories, double dt) {
    FlightStops stops(stores, dt);
    StepList<TrajectorySegment> all, path;
    StepList<BodyIndex> stopped;
    for (const TrajectorySegment& segment : trajectories) {
        if (std::find(stopped.begin(), stopped.end(), segment.body) != stopped.end()) continue;
        if (stops.stop(segment, path)) {
            storeMotion(stores.bodies, segment.body, path.back().to);
            stopped.push_back(segment.body);
        }
        all.insert(all.end(), path.begin(), path.end());
    }
    trajectories.assign(all.begin(), all.end());
    return stops.takeImpacts();
}

}  // namespace plumb
