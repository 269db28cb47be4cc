// SPDX-License-Identifier: MIT
#include <plumb/dynamics/sensors/sensors.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include <plumb/collide/distance.h>
#include <plumb/collide/sweep.h>
#include <plumb/dynamics/bodies/shape_radii.h>
#include <plumb/math/trig.h>

namespace plumb {

namespace {

auto keyOf(const ShapeId& id) {
    return std::tuple(id.body.index, id.body.generation, id.number);
}

bool isBefore(const SensorBegin& a, const SensorBegin& b) {
    return std::tuple_cat(keyOf(a.sensor), keyOf(a.visitor)) < std::tuple_cat(keyOf(b.sensor), keyOf(b.visitor));
}

bool isSame(const SensorBegin& a, const SensorBegin& b) {
    return a.sensor == b.sensor && a.visitor == b.visitor;
}

void sortOnce(std::vector<SensorBegin>& visits) {
    std::sort(visits.begin(), visits.end(), isBefore);
    visits.erase(std::unique(visits.begin(), visits.end(), isSame), visits.end());
}

bool contains(const std::vector<SensorBegin>& sorted, const SensorBegin& visit) {
    return std::binary_search(sorted.begin(), sorted.end(), visit, isBefore);
}

SensorBegin visitOf(const BodyStore& bodies, const Space& space, const SensorPair& pair) {
    return {idOfShape(bodies, space[pair.sensor]), idOfShape(bodies, space[pair.visitor])};
}

Sweep shifted(Sweep way, const Vec2& shift) {
    way.start += shift;
    return way;
}

/// The straight sweep from a body's place at the step's start to its present place.
Sweep chordOf(const BodyStore& bodies, BodyIndex body) {
    const BodyPlace& place = bodies.place[body];
    const BodyMotion& now = bodies.motion[body];
    Sweep way;
    way.localCenter = bodies.record[body].localCenter;
    way.start = {static_cast<double>(place.highX) + static_cast<double>(place.lowX),
                 static_cast<double>(place.highY) + static_cast<double>(place.lowY)};
    way.shift = now.center - way.start;
    const Vec2 before(static_cast<double>(place.cos), static_cast<double>(place.sin));
    const Vec2 after(now.rotation.cos, now.rotation.sin);
    way.turn = arcTangent(cross(before, after), before.dot(after));
    way.angle = now.angle - way.turn;
    return way;
}

/// Do the two shapes meet during their sweeps?
bool meet(const Proxy& sensor, const Sweep& sensorWay, const Proxy& visitor, const Sweep& visitorWay) {
    const Shape& shape = visitor.def.shape;
    const SweptShape swept{&shape, visitorWay, turningRadiusOf(shape, visitorWay.localCenter)};
    return timeOfApproach({&sensor.def.shape, sensorWay, 0}, swept, 0, 0).has_value();
}

/// An upper bound on how far the two shapes have moved relative to each other [m].
double travelOf(const Sweep& sensor, const Sweep& visitor, const Shape& shape) {
    const Vec2 apart = visitor.start - sensor.start, shift = visitor.shift - sensor.shift;
    const double reach = turningRadiusOf(shape, visitor.localCenter);
    return shift.norm() + std::fabs(visitor.turn) * reach +
           std::fabs(sensor.turn) * (apart.norm() + shift.norm() + reach);
}

/// Checks the pairs one after the other.
class SensorSearch {
public:
    SensorSearch(SensorStore& sensors, const BodyStore& bodies, const Space& space, const Trajectories& trajectories,
                 double dt)
        : sensors_(sensors), bodies_(bodies), space_(space), trajectories_(trajectories), dt_(dt) {}

    /// Updates whether the visitor is inside. Adds to passed if it has only passed through. False if the pair is no
    /// longer near and must be removed.
    bool search(SensorPair& pair) {
        if (!pair.fresh && !isAwake(pair.sensor) && !isAwake(pair.visitor)) return true;
        const bool near = space_.boxesOverlap(pair.sensor, pair.visitor, pair.shift);
        const bool was = pair.inside;
        pair.inside = false;
        pair.fresh = false;
        if (near) {
            const Proxy& sensor = space_[pair.sensor];
            const Proxy& visitor = space_[pair.visitor];
            const Distance apart = distance(sensor.def.shape, bodies_.pose(sensor.owner), visitor.def.shape,
                                            shifted(bodies_.pose(visitor.owner), pair.shift));
            pair.inside = apart.separation <= 0;
            if (!pair.inside && !was && hasPassed(pair, apart.separation))
                passed.push_back(visitOf(bodies_, space_, pair));
        }
        sensors_.changed = sensors_.changed || pair.inside != was;
        return near;
    }

    std::vector<SensorBegin> passed;

private:
    /// Has a visitor that is outside now been inside during the step?
    bool hasPassed(const SensorPair& pair, double separation) const {
        const Proxy& sensor = space_[pair.sensor];
        const Proxy& visitor = space_[pair.visitor];
        const Sweep sensorWay = chordOf(bodies_, sensor.owner);
        if (!bodies_.isMovedBy(visitor.owner, MovedBy::Impacts)) {
            const Sweep way = shifted(chordOf(bodies_, visitor.owner), pair.shift);
            return travelOf(sensorWay, way, visitor.def.shape) >= separation && meet(sensor, sensorWay, visitor, way);
        }
        return std::any_of(trajectories_.begin(), trajectories_.end(), [&](const TrajectorySegment& segment) {
            if (segment.body != visitor.owner) return false;
            const Sweep way{segment.from.center, segment.to.center - segment.from.center, segment.from.angle,
                            segment.to.angle - segment.from.angle, bodies_.record[visitor.owner].localCenter};
            return meet(sensor, partOf(sensorWay, segment.start / dt_, segment.end / dt_), visitor,
                        shifted(way, pair.shift));
        });
    }

    bool isAwake(ProxyId proxy) const { return bodies_.record[space_[proxy].owner].awake; }

    SensorStore& sensors_;
    const BodyStore& bodies_;
    const Space& space_;
    const Trajectories& trajectories_;
    double dt_;
};

void makeEvents(SensorStore& store, std::vector<SensorBegin> now, std::vector<SensorBegin> passed) {
    sortOnce(now);
    sortOnce(passed);
    std::erase_if(passed, [&](const SensorBegin& v) { return contains(now, v) || contains(store.inside, v); });
    std::vector<SensorBegin> ended = passed;
    store.begins = std::move(passed);
    std::set_difference(now.begin(), now.end(), store.inside.begin(), store.inside.end(),
                        std::back_inserter(store.begins), isBefore);
    std::set_difference(store.inside.begin(), store.inside.end(), now.begin(), now.end(), std::back_inserter(ended),
                        isBefore);
    for (const SensorBegin& visit : ended) store.ends.push_back({visit.sensor, visit.visitor});
    store.inside = std::move(now);
}

}  // namespace

void addSensorPair(SensorStore& sensors, const Space& space, const Pair& pair, const Vec2& shift) {
    const bool first = space[pair.a].def.sensor;
    sensors.pairs.push_back({first ? pair.a : pair.b, first ? pair.b : pair.a, first ? shift : Vec2(-shift)});
}

void removeSensorPairs(SensorStore& sensors, ProxyId proxy) {
    std::erase_if(sensors.pairs, [&](const SensorPair& pair) {
        const bool goes = pair.sensor == proxy || pair.visitor == proxy;
        sensors.changed = sensors.changed || (goes && pair.inside);
        return goes;
    });
}

void watchSensors(SensorStore& sensors, const BodyStore& bodies, const Space& space, const Trajectories& trajectories,
                  double dt) {
    SensorSearch search(sensors, bodies, space, trajectories, dt);
    std::size_t kept = 0;
    for (SensorPair& pair : sensors.pairs)
        if (search.search(pair)) sensors.pairs[kept++] = pair;
    sensors.pairs.resize(kept);
    if (!sensors.changed && search.passed.empty()) return;
    sensors.changed = false;
    std::vector<SensorBegin> now;
    for (const SensorPair& pair : sensors.pairs)
        if (pair.inside) now.push_back(visitOf(bodies, space, pair));
    makeEvents(sensors, std::move(now), std::move(search.passed));
}

}  // namespace plumb
