// SPDX-License-Identifier: MIT
#include <plumb/dynamics/sensors/sensor_pairs.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/dynamics/contacts/bounds.h>
#include <plumb/math/detail/sorting.h>
#include <plumb/space/detail/shape_radii.h>

namespace plumb {

namespace {

/// An upper bound on how far the two shapes have moved relative to each other [m]: the shift, and each turn times the
/// farthest arm on which it acts. The sensor's turn sweeps the visitor around its centre.
double travelOf(const Sweep& sensor, const Sweep& visitor, const Vec2& image, const Shape& shape) {
    const Vec2 apart = visitor.start + image - sensor.start, shift = visitor.shift - sensor.shift;
    const double reach = turningRadiusOf(shape, visitor.localCenter);
    return shift.norm() + std::fabs(visitor.turn) * reach +
           std::fabs(sensor.turn) * (apart.norm() + shift.norm() + reach);
}

/// The part of a piece of a path between two shares of the step. A piece of no length is a body that stays where it was
/// stopped.
Sweep partBetween(const PathPiece& piece, double start, double end) {
    const double whole = piece.end - piece.start;
    if (whole <= 0) return piece.sweep;
    return partOf(piece.sweep, (start - piece.start) / whole, (end - piece.start) / whole);
}

}  // namespace

/// A sweep costs a search. So a straight path is first compared with the distance at its end: what has moved less than
/// that has not met. Bodies of the impacts have a piece for each flight, and only pieces of the same time are compared.
bool haveMet(const SensorPair& pair, double separation, const Space& space, BodyPaths& paths) {
    const Proxy& sensor = space[pair.sensor];
    const Proxy& visitor = space[pair.visitor];
    const Shape& shape = visitor.def.shape;
    const auto meet = [&](const Sweep& here, Sweep there) {
        there.start += pair.shift;
        const SweptShape swept{&shape, there, turningRadiusOf(shape, there.localCenter)};
        return timeOfApproach({&sensor.def.shape, here, 0}, swept, 0, 0).has_value();
    };
    if (paths.isStraight(sensor.owner) && paths.isStraight(visitor.owner)) {
        const Sweep here = paths.chordOf(sensor.owner), there = paths.chordOf(visitor.owner);
        return travelOf(here, there, pair.shift, shape) >= separation && meet(here, there);
    }
    const std::vector<PathPiece> here = paths.of(sensor.owner), there = paths.of(visitor.owner);
    for (const PathPiece& a : here)
        for (const PathPiece& b : there) {
            const double start = std::max(a.start, b.start), end = std::min(a.end, b.end);
            if (start <= end && meet(partBetween(a, start, end), partBetween(b, start, end))) return true;
        }
    return false;
}

namespace {

/// A shape that has left its bounds, and the box of its path.
struct DeflectedShape {
    ProxyId proxy = 0;
    Aabb box;
};

/// May a shape of the body, other than a sensor, have left its bounds? Free flight is as predicted. Bounds contain all
/// places between the step's start and the prediction, and half a contactMargin more on every side.
bool mayHaveLeft(const BodyStore& bodies, BodyIndex body) {
    if (bodies.step[body].boundsPending || bodies.isMovedBy(body, MovedBy::Impacts)) return true;
    if (!bodies.isMovedBy(body, MovedBy::Solver)) return false;
    const SolverDisplacement& d = bodies.displacement[body];
    const Vec2 moved(static_cast<double>(d.x), static_cast<double>(d.y));
    // A chord is at most two radii long.
    const double angle = std::min(std::fabs(static_cast<double>(bodies.turn[body].angle)), 2.0);
    const double turned = angle * bodies.record[body].turningRadius;
    const double spare = 0.49 * static_cast<double>(contactMargin);
    // Most bodies move so little that the prediction need not be read.
    return std::fabs(moved.x()) + std::fabs(moved.y()) + turned >= spare &&
           excessOfPrediction(bodies, body, moved, turned) >= spare;
}

class DeflectedSearch {
public:
    DeflectedSearch(const BodyStore& bodies, const Space& space, BodyPaths& paths)
        : bodies_(bodies), space_(space), paths_(paths) {}

    /// Finds the shapes that have left their bounds.
    void gather(const std::vector<ProxyId>& sensors) {
        for (const BodyIndex body : bodies_.awake) {
            if (!mayHaveLeft(bodies_, body)) continue;
            for (const ProxyId proxy : bodies_.links[body].proxies)
                if (!space_.filterKey(proxy).sensor && space_.filterKey(proxy).collides) add(proxy, visitors_);
        }
        for (const ProxyId proxy : sensors) {  // a body's radii do not include its sensors
            const BodyRecord& record = bodies_.record[space_[proxy].owner];
            if (record.awake && record.enabled) add(proxy, sensors_);
        }
    }

    std::vector<SensorPair> pairs() {
        for (const DeflectedShape& visitor : visitors_)
            space_.query(visitor.box, [&](ProxyId other, const Vec2& shift) {
                if (space_.filterKey(other).sensor) meet(other, visitor.proxy, -shift);
            });
        for (const DeflectedShape& sensor : sensors_) {
            space_.query(sensor.box, [&](ProxyId other, const Vec2& shift) { meet(sensor.proxy, other, shift); });
            for (const DeflectedShape& visitor : visitors_) {
                const Vec2 shift =
                    bodies_.wrap.any() ? bodies_.wrap.shiftNear(visitor.box.lower, sensor.box.lower) : Vec2(0, 0);
                if (overlap(sensor.box, {visitor.box.lower + shift, visitor.box.upper + shift}))
                    meet(sensor.proxy, visitor.proxy, shift);
            }
        }
        keepOnce();
        return std::move(pairs_);
    }

private:
    void add(ProxyId proxy, std::vector<DeflectedShape>& list) {
        const Proxy& shape = space_[proxy];
        const Aabb box = paths_.boxOf(shape.owner, shape.def.shape);
        if (contains(space_.box(proxy), box) || bodies_.wrap.isExceededBy(box.upper - box.lower)) return;
        list.push_back({proxy, box});
    }

    /// shift: of the visitor [m]. If their bounds overlap, the pair is there already.
    void meet(ProxyId sensor, ProxyId visitor, const Vec2& shift) {
        if (mayPair(space_.filterKey(sensor), space_.filterKey(visitor)) &&
            !space_.boxesOverlap(sensor, visitor, shift))
            pairs_.push_back({sensor, visitor, shift});
    }

    /// The order in which the space finds shapes depends on what is far away.
    void keepOnce() {
        sortOnceBy(pairs_,
                   [](const SensorPair& p) { return std::tuple(p.sensor, p.visitor, p.shift.x(), p.shift.y()); });
    }

    const BodyStore& bodies_;
    const Space& space_;
    BodyPaths& paths_;
    std::vector<DeflectedShape> visitors_, sensors_;
    std::vector<SensorPair> pairs_;
};

}  // namespace

std::vector<SensorPair> findDeflectedPairs(const SensorStore& sensors, const BodyStore& bodies, const Space& space,
                                           BodyPaths& paths) {
    if (sensors.sensors.empty()) return {};
    DeflectedSearch search(bodies, space, paths);
    search.gather(sensors.sensors);
    return search.pairs();
}

}  // namespace plumb
