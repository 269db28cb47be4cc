// SPDX-License-Identifier: MIT
#include <plumb/movers/path_mover.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <plumb/math/check.h>
#include <plumb/math/trig.h>
#include <plumb/stepping/interpolate.h>

namespace plumb {

namespace {

void requireStops(const std::vector<PathStop>& stops, double length) {
    for (std::size_t i = 0; i < stops.size(); ++i) {
        const std::string field = "PathMoverDef.stops[" + std::to_string(i) + "]";
        requireWithin(stops[i].along, 0, length, field, ".along");
        requireNotNegative(stops[i].pause, field, ".pause");
        if (i > 0 && !(stops[i].along > stops[i - 1].along))
            refuse(field + ".along", toText(stops[i].along) + " is not beyond the one before");
    }
}

}  // namespace

PathMover::PathMover(PathMoverDef def) : def_(std::move(def)) {
    const double length = def_.path.length();
    requirePositive(length, "PathMoverDef.path: length");
    requireStops(def_.stops, length);
    if (def_.repeat == PathRepeat::Loop && !def_.path.closed())
        refuse("PathMoverDef.repeat", "Loop needs a closed path; this one ends at " + toText(def_.path.end()));
    double along = 0;
    for (const PathStop& stop : def_.stops) {
        addRun(along, stop.along);
        addRest(stop.along, stop.pause);
        along = stop.along;
    }
    addRun(along, length);
    if (def_.repeat == PathRepeat::BackAndForth) addWayBack();
    requirePositive(period_, "PathMoverDef: time of a lap");
}

void PathMover::addRun(double from, double to) {
    if (from == to) return;
    legs_.push_back({period_, from, to});
    period_ += timeOf(std::fabs(to - from), def_.timing);
}

void PathMover::addRest(double at, double pause) {
    if (pause == 0) return;
    legs_.push_back({period_, at, at});
    period_ += pause;
}

/// Pauses at both ends are made once per lap.
void PathMover::addWayBack() {
    double along = def_.path.length();
    for (auto stop = def_.stops.rbegin(); stop != def_.stops.rend(); ++stop) {
        if (stop->along == 0 || stop->along == def_.path.length()) continue;
        addRun(along, stop->along);
        addRest(stop->along, stop->pause);
        along = stop->along;
    }
    addRun(along, 0);
}

PathState PathMover::at(double time) const {
    requireNotNegative(time, "PathMover.at: time");
    const double laps = std::floor(time / period_);
    requireWithin(laps, 0, 0x1p53, "PathMover.at: laps");
    if (def_.repeat == PathRepeat::Once && time >= period_) {
        const PathPlace end = def_.path.at(def_.path.length());
        return {end.position, end.tangent, {0, 0}, def_.path.length(), 1, true};
    }
    const double inLap = std::fmod(time, period_);  // exact, unlike most functions of the C library
    const auto after = std::upper_bound(legs_.begin() + 1, legs_.end(), inLap,
                                        [](double moment, const Leg& leg) { return moment < leg.start; });
    PathState state = stateIn(*(after - 1), inLap);
    state.lap = static_cast<std::int64_t>(std::floor((time - inLap) / period_ + 0.5));
    return state;
}

PathState PathMover::stateIn(const Leg& leg, double time) const {
    const double distance = std::fabs(leg.to - leg.from), side = leg.to < leg.from ? -1 : 1;
    const Progress run = distance > 0 ? progressAt(distance, def_.timing, time - leg.start) : Progress{};
    const double along = leg.from + side * run.along;
    const PathPlace point = def_.path.at(along);
    return {point.position, point.tangent, side * run.speed * point.tangent, along, 0, false};
}

PathPose PathMover::poseAfter(std::int64_t tick, double dt, double angle) const {
    requirePositive(dt, "PathMover.poseAfter: dt");
    requireFinite(angle, "PathMover.poseAfter: angle");
    const PathState state = atTick(tick + 1, dt);
    return {state.position, angle + shortestTurn(angle, arcTangent(state.tangent.y(), state.tangent.x()))};
}

}  // namespace plumb
