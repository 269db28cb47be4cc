// SPDX-License-Identifier: MIT
#include <web/module/host.h>

#include <limits>

namespace plumb::web {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Three numbers for each body, at 3 times its index.
template <class Of>
void perBody(const World& world, std::vector<double>& out, Of of) {
    out.clear();
    for (const BodyId& id : world.bodies()) {
        out.resize(3 * std::size_t{id.index}, none);
        of(world.body(id));
    }
}

void put(std::vector<double>& out, const ShapeId& shape) {
    out.insert(out.end(), {static_cast<double>(shape.body.index), static_cast<double>(shape.number)});
}
void put(std::vector<double>& out, const Vec2& vector) {
    out.insert(out.end(), {vector.x(), vector.y()});
}

void addContacts(const World& world, std::vector<double>& out) {
    for (const BodyId& id : world.bodies()) {
        for (const Contact& contact : world.body(id).contacts()) {
            if (contact.shapeA.body != id) continue;  // told by the other body
            for (const ContactPoint& point : contact.points) {
                put(out, contact.shapeA);
                put(out, contact.shapeB);
                put(out, point.position);
                put(out, contact.normal);
                out.insert(out.end(), {point.separation, point.normalForce, point.frictionForce});
            }
        }
    }
}

/// The kinds of events, in the order of eventKinds in runtime.js.
enum Kind { contactBegin, contactEnd, contactHit, sensorBegin, sensorEnd, jointBreak, quarantine };

void addEvent(std::vector<double>& out, Kind kind, const ShapeId& a, const ShapeId& b, const Vec2& point = {none, none},
              const Vec2& normal = {none, none}, double speed = none) {
    out.push_back(kind);
    put(out, a);
    put(out, b);
    put(out, point);
    put(out, normal);
    out.push_back(speed);
}

void addEvents(const World& world, std::vector<double>& out) {
    for (const ContactBegin& e : world.contactBegins())
        addEvent(out, contactBegin, e.shapeA, e.shapeB, e.point, e.normal, e.approachSpeed);
    for (const ContactEnd& e : world.contactEnds()) addEvent(out, contactEnd, e.shapeA, e.shapeB);
    for (const ContactHit& e : world.contactHits())
        addEvent(out, contactHit, e.shapeA, e.shapeB, e.point, e.normal, e.approachSpeed);
    for (const SensorBegin& e : world.sensorBegins()) addEvent(out, sensorBegin, e.sensor, e.visitor);
    for (const SensorEnd& e : world.sensorEnds()) addEvent(out, sensorEnd, e.sensor, e.visitor);
    for (const JointBroke& e : world.jointBreaks()) addEvent(out, jointBreak, {e.bodyA, 0}, {e.bodyB, 0});
    for (const Quarantined& e : world.quarantines()) addEvent(out, quarantine, {e.body, 0}, {});
}

}  // namespace

void allRows(const World& world, Rows rows, std::vector<double>& out) {
    out.clear();
    switch (rows) {
        case Rows::Poses:
            return perBody(world, out, [&](const BodyView& body) {
                put(out, body.position());
                out.push_back(body.angle());
            });
        case Rows::Velocities:
            return perBody(world, out, [&](const BodyView& body) {
                put(out, body.velocity());
                out.push_back(body.angularVelocity());
            });
        case Rows::Contacts: return addContacts(world, out);
        case Rows::Events: return addEvents(world, out);
    }
}

}  // namespace plumb::web
