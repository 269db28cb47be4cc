// SPDX-License-Identifier: MIT
// Does what a world says of itself add up?
#include <algorithm>

#include <plumb/collide/distance.h>

#include "kit/dynamics/random_editor.h"

namespace plumb::test {

namespace {

bool filtersAllow(const ShapeDef& a, const ShapeDef& b) {
    return !a.sensor && !b.sensor && RandomEditor::passes(a.filter, b.filter);
}

}  // namespace

/// All that is awake has been told, in order, and what fell asleep is not.
void RandomEditor::checkMoves() const {
    std::uint32_t last = 0;
    std::size_t awake = 0;
    for (const BodyMoved& move : world.moves()) {
        if (move.body.index <= last) FAIL("moves out of order");
        last = move.body.index;
        const BodyView body = world.body(move.body);
        if (move.fellAsleep == body.awake()) FAIL("asleep and awake at once");
        if (!(move.pose.position == body.position())) FAIL("moved to where it is not");
        awake += body.awake() ? std::size_t{1} : 0;
    }
    if (awake != world.counts().awakeBodies) FAIL("something is awake and was not told");
}

/// What sensors have told is what overlaps; but for what was pushed aside in this step, and is found in the next.
void RandomEditor::checkSensors() const {
    struct Placed {
        ShapeId id;
        ShapeDef def;
        Aabb box;
        BodyView body;
    };
    std::vector<Placed> all;
    for (const BodyId id : world.bodies()) {
        const BodyView body = world.body(id);
        if (!body.enabled()) continue;
        for (const ShapeId& shape : body.shapes()) {
            const ShapeDef def = world.shape(shape).def();
            all.push_back({shape, def, aabbOf(def.shape, body.pose()), body});
        }
    }
    const auto movedBy = [&](const BodyView& body) {
        const Place& before = placesBefore_.at(body.id().index);
        const double round = world.wrap().any() ? body.velocity().norm() * lastStep_ : 0;
        return round + world.wrap().shortest(before.position, body.position()).norm() +
               3 * std::fabs(body.angle() - before.angle);
    };
    for (const Placed& sensor : all) {
        if (!sensor.def.sensor) continue;
        for (const Placed& other : all) {
            if (other.id.body == sensor.id.body || other.def.sensor) continue;
            const auto told = inside_.find(keyOf(sensor.id, other.id));
            const bool inside = told != inside_.end() && told->second > 0;
            const bool wraps = world.wrap().any();
            if (!inside && !wraps && !overlap(sensor.box, other.box)) continue;
            const bool fixed = sensor.body.type() == BodyType::Static && other.body.type() == BodyType::Static;
            const double apart =
                wraps ? world.distance(sensor.id, other.id).separation
                      : distance(sensor.def.shape, sensor.body.pose(), other.def.shape, other.body.pose()).separation;
            const bool truth = !fixed && passes(sensor.def.filter, other.def.filter) && apart <= 0;
            const double lag = 0.02 + 2 * (movedBy(sensor.body) + movedBy(other.body));
            if (inside != truth && !(std::fabs(apart) < lag)) FAIL("who is in a sensor is not who was told");
        }
    }
}

void RandomEditor::followEvents() {
    for (const ContactEnd& end : world.contactEnds())
        if (--touching_[keyOf(end.shapeA, end.shapeB)] < 0) FAIL("a touch ended that had not begun");
    for (const ContactBegin& begin : world.contactBegins()) {
        ++touching_[keyOf(begin.shapeA, begin.shapeB)];
        if (!begin.point.allFinite() || std::fabs(begin.normal.norm() - 1) > 1e-5) FAIL("a begin of no place");
    }
    for (const SensorBegin& begin : world.sensorBegins())
        if (++inside_[keyOf(begin.sensor, begin.visitor)] > 1) FAIL("a visitor came in twice");
    for (const SensorEnd& end : world.sensorEnds())
        if (--inside_[keyOf(end.sensor, end.visitor)] < 0) FAIL("a visitor left that was not in");
    for (const ContactHit& hit : world.contactHits())
        if (!(hit.approachSpeed > 0.5)) FAIL("a hit that is too slow");
    tally.begins += static_cast<long long>(world.contactBegins().size());
    tally.hits += static_cast<long long>(world.contactHits().size());
    tally.visits += static_cast<long long>(world.sensorBegins().size());
    tally.quarantines += static_cast<long long>(world.quarantines().size());
}

/// What touches is what events have told, and may.
void RandomEditor::checkContacts() {
    std::map<Key, int> now;
    for (const BodyId id : world.bodies()) {
        for (const Contact& contact : world.body(id).contacts()) {
            if (contact.shapeA.body != id) continue;
            ++now[keyOf(contact.shapeA, contact.shapeB)];
            if (!filtersAllow(world.shape(contact.shapeA).def(), world.shape(contact.shapeB).def()))
                FAIL("what may not touch does");
            const Body a = world.body(contact.shapeA.body), b = world.body(contact.shapeB.body);
            if (!a.enabled() || !b.enabled()) FAIL("what is disabled touches");
            if (a.type() != BodyType::Dynamic && b.type() != BodyType::Dynamic) FAIL("two that nothing moves touch");
            for (const ContactPoint& point : contact.points)
                if (!point.position.allFinite() || !std::isfinite(point.normalForce) || point.normalForce < 0)
                    FAIL("a contact of no force or place");
        }
    }
    std::erase_if(touching_, [](const auto& entry) { return entry.second == 0; });
    std::erase_if(inside_, [](const auto& entry) { return entry.second == 0; });
    if (now != touching_) FAIL("what touches is not what events have told");
}

void RandomEditor::check() {
    std::vector<BodyId> sorted = bodies;
    std::sort(sorted.begin(), sorted.end(), [](const BodyId& a, const BodyId& b) { return a.index < b.index; });
    if (world.bodies() != sorted) FAIL("bodies are not those that were made");
    std::size_t awake = 0, shapes = 0;
    for (const BodyId id : bodies) {
        const Body body = world.body(id);
        if (!world.contains(id)) FAIL("a body is gone");
        if (!body.position().allFinite() || !body.velocity().allFinite()) FAIL("a body is nowhere");
        if ((body.mass() > 0) != (body.type() == BodyType::Dynamic)) FAIL("a mass that no body has");
        const bool still = body.velocity().isZero(0) && body.angularVelocity() == 0;
        if (body.type() == BodyType::Static && (body.awake() || !still)) FAIL("a static body moves");
        if (body.awake() && !body.enabled()) FAIL("a disabled body is awake");
        for (const ShapeId& shape : body.shapes())
            if (!world.contains(shape)) FAIL("a shape is gone");
        awake += body.awake() ? std::size_t{1} : 0;
        shapes += body.shapes().size();
    }
    for (const BodyId& id : removed)
        if (world.contains(id)) FAIL("a removed body is there");
    const WorldCounts counts = world.counts();
    if (counts.bodies != bodies.size() || counts.awakeBodies != awake || counts.shapes != shapes)
        FAIL("counts are not of what is there");
    checkJoints();
    checkFields();
}

/// Each entry is a number, and together they are what is there. Rounding is of all that came and went: joints that
/// contradict each other, or were torn apart by a jump, bring in and take out far more than there ever is at once.
void RandomEditor::checkLedger() {
    const Ledger ledger = world.ledger();
    const EnergyLedger& e = ledger.energy;
    const MomentumLedger& m = ledger.momentum;
    double energy = std::fabs(e.kinetic) + std::fabs(e.gravitational) + std::fabs(e.spring) + std::fabs(e.fields);
    double momentum = m.momentum.norm();
    for (const double entry :
         {e.edits, e.forces, e.drivers, e.motors, e.friction, e.impacts, e.damping, e.breaking, e.solver}) {
        if (!std::isfinite(entry)) FAIL("an entry of the energy is no number");
        energy += std::fabs(entry);
    }
    for (const Vec2& entry : {m.edits, m.gravity, m.fields, m.forces, m.ground, m.damping, m.solver}) {
        if (!entry.allFinite()) FAIL("an entry of the momentum is no number");
        momentum += entry.norm();
    }
    INFO(e.kinetic << " " << e.gravitational << " " << e.spring << " " << e.fields << ": edits " << e.edits
                   << " forces " << e.forces << " drivers " << e.drivers << " motors " << e.motors << " friction "
                   << e.friction << " impacts " << e.impacts << " damping " << e.damping << " breaking " << e.breaking
                   << " solver " << e.solver);
    if (!std::isfinite(energy) || !std::isfinite(momentum)) FAIL("what is there is no number");
    mostEnergy_ = std::max(mostEnergy_, energy);
    mostMomentum_ = std::max(mostMomentum_, momentum);
    INFO("step " << tally.steps << " of " << lastStep_ << " s: stored " << e.stored() << " J, gained " << e.gained()
                 << " J, at most " << mostEnergy_ << " J; momentum " << m.momentum.transpose() << ", gained "
                 << m.gained().transpose() << ", at most " << mostMomentum_ << " N s");
    if (!(std::fabs(e.stored() - e.gained()) <= 1e-6 * mostEnergy_)) FAIL("the energy does not close");
    if (!((m.momentum - m.gained()).norm() <= 1e-6 * mostMomentum_)) FAIL("the momentum does not close");
}

}  // namespace plumb::test
