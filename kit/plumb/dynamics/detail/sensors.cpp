// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/sensors.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

#include <plumb/collide/distance.h>
#include <plumb/collide/sweep.h>
#include <plumb/dynamics/detail/shape_measure.h>
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

SensorBegin visitOf(const WorldState& world, const SensorPair& pair) {
    return {world.idOfShape(pair.sensor), world.idOfShape(pair.visitor)};
}

Way shifted(Way way, const Vec2& shift) {
    way.start += shift;
    return way;
}

/// Straight from where a body was loaded at the step's start to where it is now.
Way chordOf(const WorldState& world, BodyIndex body) {
    const BodyPlace& place = world.bodies.place[body];
    const BodyMotion& now = world.bodies.motion[body];
    Way way;
    way.localCenter = world.bodies.record[body].localCenter;
    way.start = {static_cast<double>(place.highX) + static_cast<double>(place.lowX),
                 static_cast<double>(place.highY) + static_cast<double>(place.lowY)};
    way.shift = now.center - way.start;
    const Vec2 before(static_cast<double>(place.cos), static_cast<double>(place.sin));
    const Vec2 after(now.rotation.cos, now.rotation.sin);
    way.turn = arcTangent(cross(before, after), before.dot(after));
    way.angle = now.angle - way.turn;
    return way;
}

/// A part of a way, in shares of it.
Way partOf(const Way& way, double from, double to) {
    return {way.start + way.shift * from, way.shift * (to - from), way.angle + way.turn * from, way.turn * (to - from),
            way.localCenter};
}

/// Do the two meet on their ways?
bool meet(const Proxy& sensor, const Way& sensorWay, const Proxy& visitor, const Way& visitorWay) {
    const Shape& shape = visitor.def.shape;
    const SweptShape swept{&shape, visitorWay, reachOf(shape, visitorWay.localCenter)};
    return timeWithin({&sensor.def.shape, sensorWay, 0}, swept, 0, 0).has_value();
}

/// No farther than this can the two have been moved against each other [m].
double travelOf(const Way& sensor, const Way& visitor, const Shape& shape) {
    const Vec2 apart = visitor.start - sensor.start, shift = visitor.shift - sensor.shift;
    const double reach = reachOf(shape, visitor.localCenter);
    return shift.norm() + std::fabs(visitor.turn) * reach +
           std::fabs(sensor.turn) * (apart.norm() + shift.norm() + reach);
}

/// Has what is outside now been inside on its way through the step?
bool hasPassed(const WorldState& world, const SensorPair& pair, double separation, double dt) {
    const Proxy& sensor = world.space[pair.sensor];
    const Proxy& visitor = world.space[pair.visitor];
    const Way sensorWay = chordOf(world, sensor.owner);
    if (!world.bodies.record[visitor.owner].flown) {
        const Way way = shifted(chordOf(world, visitor.owner), pair.shift);
        return travelOf(sensorWay, way, visitor.def.shape) >= separation && meet(sensor, sensorWay, visitor, way);
    }
    return std::any_of(world.legs.begin(), world.legs.end(), [&](const Leg& leg) {
        if (leg.body != visitor.owner) return false;
        const Way way{leg.from.center, leg.to.center - leg.from.center, leg.from.angle, leg.to.angle - leg.from.angle,
                      world.bodies.record[visitor.owner].localCenter};
        return meet(sensor, partOf(sensorWay, leg.start / dt, leg.end / dt), visitor, shifted(way, pair.shift));
    });
}

bool isAwake(const WorldState& world, ProxyId proxy) {
    return world.bodies.record[world.space[proxy].owner].awake;
}

/// False for a pair that is to be forgotten. What has only passed through is noted.
bool look(WorldState& world, SensorPair& pair, std::vector<SensorBegin>& passed, double dt) {
    if (!pair.fresh && !isAwake(world, pair.sensor) && !isAwake(world, pair.visitor)) return true;
    const bool near = world.space.boxesOverlap(pair.sensor, pair.visitor, pair.shift);
    const bool was = pair.inside;
    pair.inside = false;
    pair.fresh = false;
    if (near) {
        const Proxy& sensor = world.space[pair.sensor];
        const Proxy& visitor = world.space[pair.visitor];
        const Distance apart = distance(sensor.def.shape, world.bodies.pose(sensor.owner), visitor.def.shape,
                                        shifted(world.bodies.pose(visitor.owner), pair.shift));
        pair.inside = apart.separation <= 0;
        if (!pair.inside && !was && hasPassed(world, pair, apart.separation, dt))
            passed.push_back(visitOf(world, pair));
    }
    world.sensors.changed = world.sensors.changed || pair.inside != was;
    return near;
}

void tell(SensorStore& store, std::vector<SensorBegin> now, std::vector<SensorBegin> passed) {
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

void addSensorPair(WorldState& world, const Pair& pair, const Vec2& shift) {
    const bool first = world.space[pair.a].def.sensor;
    world.sensors.pairs.push_back({first ? pair.a : pair.b, first ? pair.b : pair.a, first ? shift : Vec2(-shift)});
}

void removeSensorPairs(WorldState& world, ProxyId proxy) {
    SensorStore& store = world.sensors;
    std::erase_if(store.pairs, [&](const SensorPair& pair) {
        const bool goes = pair.sensor == proxy || pair.visitor == proxy;
        store.changed = store.changed || (goes && pair.inside);
        return goes;
    });
}

void watchSensors(WorldState& world, double dt) {
    SensorStore& store = world.sensors;
    std::vector<SensorBegin> passed, now;
    std::size_t kept = 0;
    for (SensorPair& pair : store.pairs)
        if (look(world, pair, passed, dt)) store.pairs[kept++] = pair;
    store.pairs.resize(kept);
    if (!store.changed && passed.empty()) return;
    store.changed = false;
    for (const SensorPair& pair : store.pairs)
        if (pair.inside) now.push_back(visitOf(world, pair));
    tell(store, std::move(now), std::move(passed));
}

}  // namespace plumb
