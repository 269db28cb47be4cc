// SPDX-License-Identifier: MIT
#include <plumb/dynamics/sensors/sensors.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include <plumb/collide/distance.h>
#include <plumb/dynamics/sensors/body_paths.h>
#include <plumb/dynamics/sensors/sensor_pairs.h>
#include <plumb/math/detail/sorting.h>

namespace plumb {

namespace {

/// Ids have no order of their own that means anything; by body, generation and shape, lists are the same in every run.
auto keyOf(const ShapeId& id) {
    return std::tuple(id.body.index, id.body.generation, id.number);
}

auto rankOf(const SensorBegin& visit) {
    return std::tuple_cat(keyOf(visit.sensor), keyOf(visit.visitor));
}

bool isBefore(const SensorBegin& a, const SensorBegin& b) {
    return rankOf(a) < rankOf(b);
}

/// A chain or a tile map is many proxies and one shape: its pieces make one visit. Test: "a chain of a hundred pieces
/// that moves across a sensor is one visitor, in once and out once"
void sortOnce(std::vector<SensorBegin>& visits) {
    sortOnceBy(visits, rankOf);
}

bool contains(const std::vector<SensorBegin>& sorted, const SensorBegin& visit) {
    return std::binary_search(sorted.begin(), sorted.end(), visit, isBefore);
}

SensorBegin visitOf(const BodyStore& bodies, const Space& space, const SensorPair& pair) {
    return {idOfShape(bodies, space[pair.sensor]), idOfShape(bodies, space[pair.visitor])};
}

/// Checks the pairs one after the other.
class SensorSearch {
public:
    SensorSearch(SensorStore& sensors, const BodyStore& bodies, const Space& space, BodyPaths& paths)
        : sensors_(sensors), bodies_(bodies), space_(space), paths_(paths) {}

    /// Updates whether the visitor is inside. Adds to passed if it has only passed through. False if the pair is no
    /// longer near and must be removed.
    bool search(SensorPair& pair) {
        // What sleeps stays where it was, and inside or outside: no distance, no event.
        if (!pair.fresh && !isAwake(pair.sensor) && !isAwake(pair.visitor)) return true;
        const bool near = space_.boxesOverlap(pair.sensor, pair.visitor, pair.shift);
        const bool was = pair.inside;
        pair.inside = false;
        pair.fresh = false;
        if (near) check(pair, was);
        sensors_.changed = sensors_.changed || pair.inside != was;
        return near;
    }

    /// The same for a pair that is not near.
    void searchDeflected(SensorPair& pair) {
        check(pair, false);
        sensors_.changed = sensors_.changed || pair.inside;
    }

    std::vector<SensorBegin> passed;

private:
    void check(SensorPair& pair, bool was) {
        const Proxy& sensor = space_[pair.sensor];
        const Proxy& visitor = space_[pair.visitor];
        const Distance apart = distance(sensor.def.shape, bodies_.pose(sensor.owner), visitor.def.shape,
                                        shifted(bodies_.pose(visitor.owner), pair.shift));
        pair.inside = apart.separation <= 0;
        // Only what was outside before and after can have passed. What was inside ends by the distance alone.
        if (!pair.inside && !was && haveMet(pair, apart.separation, space_, paths_))
            passed.push_back(visitOf(bodies_, space_, pair));
    }

    bool isAwake(ProxyId proxy) const { return bodies_.record[space_[proxy].owner].awake; }

    SensorStore& sensors_;
    const BodyStore& bodies_;
    const Space& space_;
    BodyPaths& paths_;
};

/// Begins are what is inside now and was not, ends what was and is not; what has only passed within the step is both.
/// The lists are sorted, so the order of events is that of the shapes.
void makeEvents(SensorStore& store, std::vector<SensorBegin> now, std::vector<SensorBegin> passed) {
    sortOnce(now);
    sortOnce(passed);
    // A shape of several pieces may pass with one while another one is inside: then it has not left.
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

void addSensor(SensorStore& sensors, ProxyId sensor) {
    std::vector<ProxyId>& all = sensors.sensors;
    all.insert(std::lower_bound(all.begin(), all.end(), sensor), sensor);
}

void forgetSensor(SensorStore& sensors, ProxyId proxy) {
    std::vector<ProxyId>& all = sensors.sensors;
    const auto at = std::lower_bound(all.begin(), all.end(), proxy);
    if (at != all.end() && *at == proxy) all.erase(at);
}

void addSensorPair(SensorStore& sensors, const Space& space, const Pair& pair, const Vec2& shift) {
    const bool first = space[pair.a].def.sensor;
    sensors.pairs.push_back({first ? pair.a : pair.b, first ? pair.b : pair.a, first ? shift : Vec2(-shift)});
}

/// No event here: edits are between steps, and events are of a step.
void removeSensorPairs(SensorStore& sensors, ProxyId proxy) {
    std::erase_if(sensors.pairs, [&](const SensorPair& pair) {
        const bool goes = pair.sensor == proxy || pair.visitor == proxy;
        sensors.changed = sensors.changed || (goes && pair.inside);
        return goes;
    });
}

/// O(pairs), and O(awake bodies) for what was deflected; distances only for pairs of which one is awake. Events are
/// made only if some visit has changed.
void watchSensors(SensorStore& sensors, const BodyStore& bodies, const Space& space, const Trajectories& trajectories,
                  double dt) {
    BodyPaths paths(bodies, trajectories, dt);
    SensorSearch search(sensors, bodies, space, paths);
    std::size_t kept = 0;
    for (SensorPair& pair : sensors.pairs)
        if (search.search(pair)) sensors.pairs[kept++] = pair;
    // The space reports a pair again when its bounds meet again.
    sensors.pairs.resize(kept);
    std::vector<SensorPair> deflected = findDeflectedPairs(sensors, bodies, space, paths);
    for (SensorPair& pair : deflected) search.searchDeflected(pair);
    if (!sensors.changed && search.passed.empty()) return;
    std::vector<SensorBegin> now;
    const auto note = [&](const std::vector<SensorPair>& pairs) {
        for (const SensorPair& pair : pairs)
            if (pair.inside) now.push_back(visitOf(bodies, space, pair));
    };
    note(sensors.pairs);
    note(deflected);
    makeEvents(sensors, std::move(now), std::move(search.passed));
    // The next step knows the deflected that are inside only if it finds them again.
    sensors.changed =
        std::any_of(deflected.begin(), deflected.end(), [](const SensorPair& pair) { return pair.inside; });
}

}  // namespace plumb
