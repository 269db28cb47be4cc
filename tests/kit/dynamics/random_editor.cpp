// SPDX-License-Identifier: MIT
#include "kit/dynamics/random_editor.h"

#include <algorithm>
#include <limits>

#include <plumb/collide/distance.h>

namespace plumb::test {

namespace {

constexpr std::size_t mostBodies = 60;

bool fromFast(const ContactQuestion& question) {
    return question.velocity.dot(question.normal) < -1;
}

bool evenOnly(const ContactQuestion& question) {
    return (question.tag + question.otherTag) % 2 == 0;
}

Material anyMaterial(RandomEditor& e) {
    Material material;
    material.density = e.chance(8) ? 0 : e.number(0.1, 5);
    material.friction = e.number(0, 1);
    material.restitution = e.chance(2) ? 0 : e.number(0, 1);
    material.rollingResistance = e.chance(4) ? 0.1 : 0;
    material.surfaceSpeed = e.chance(6) ? e.number(-3, 3) : 0;
    material.restitutionMix = e.chance(3) ? Mix::Minimum : Mix::Maximum;
    return material;
}

Filter anyFilter(RandomEditor& e) {
    Filter filter;
    if (e.chance(3)) filter.category = e.chance(2) ? 2 : 3;
    if (e.chance(3)) filter.mask = e.chance(2) ? 1 : 3;
    if (e.chance(8)) filter.group = e.chance(2) ? 1 : -1;
    return filter;
}

ShapeId someShape(RandomEditor& e) {
    const std::vector<ShapeId> shapes = e.some().shapes();
    if (shapes.empty()) return {};
    return shapes[static_cast<std::size_t>(e.random.integer(0, static_cast<int>(shapes.size()) - 1))];
}

void removeBody(RandomEditor& e) {
    const BodyId body = e.someBody();
    e.world.remove(body);
    std::erase(e.bodies, body);
    e.removed.push_back(body);
}

void makeOrRemove(RandomEditor& e) {
    if (e.bodies.size() < mostBodies)
        e.makeBody();
    else
        removeBody(e);
}

void addShape(RandomEditor& e) {
    const BodyId body = e.someBody();
    const ShapeDef shape = e.anyShape();
    if (e.world.body(body).shapes().size() < 6) e.tryTo([&] { e.world.add(body, shape); });
}

void removeShape(RandomEditor& e) {
    const ShapeId shape = someShape(e);
    if (e.tryTo([&] { e.world.remove(shape); }) && e.world.contains(shape)) FAIL("a removed shape is there");
}

void setShape(RandomEditor& e) {
    const ShapeId shape = someShape(e);
    if (!e.world.contains(shape)) return;
    ShapeDef def = e.world.shape(shape);
    switch (e.random.integer(0, 6)) {
        case 0: def.material = anyMaterial(e); break;
        case 1: def.filter = anyFilter(e); break;
        case 2: def.tag = e.random.bits(); break;
        case 3: def.sensor = !def.sensor; break;
        case 4: def.oneWay = def.oneWay ? std::nullopt : std::optional<Vec2>(e.vector(1)); break;
        case 5: def.rule = def.rule == nullptr ? evenOnly : nullptr; break;
        default: def = e.anyShape(); break;
    }
    if (e.tryTo([&] { e.world.set(shape, def); }) && !(e.world.shape(shape).shape == def.shape))
        FAIL("a shape is not what it was set to");
}

void setType(RandomEditor& e) {
    Body body = e.some();
    const BodyType type = static_cast<BodyType>(e.random.integer(0, 2));
    e.tryTo([&] { body.setType(type); });
}

void setMass(RandomEditor& e) {
    Body body = e.some();
    const Mass mass{e.number(-0.5, 5), e.vector(0.5), e.number(0.1, 3)};
    const bool given = !e.chance(3);
    e.tryTo([&] { given ? body.setMass(mass) : body.setMassFromShapes(); });
}

void setMotion(RandomEditor& e) {
    Body body = e.some();
    const double speed = e.chance(10) ? 300 : 5;
    const Vec2 velocity = e.chance(200) ? Vec2(1e300, 0) : e.vector(speed);
    const double spin = e.number(-10, 10);
    e.tryTo([&] { body.setVelocity(velocity); });
    if (e.chance(2)) e.tryTo([&] { body.setAngularVelocity(spin); });
}

void setPose(RandomEditor& e) {
    const Vec2 position = e.vector(8);
    e.some().setPose(position, e.number(-3, 3));
}

void moveTo(RandomEditor& e) {
    Body body = e.some();
    const Vec2 position = e.vector(8);
    const double angle = body.angle() + e.number(-1, 1), dt = e.number(-0.1, 2);
    e.tryTo([&] { body.moveTo(position, angle, dt); });
}

void push(RandomEditor& e) {
    Body body = e.some();
    const Vec2 push = e.vector(20), at = body.position() + e.vector(1);
    switch (e.random.integer(0, 5)) {
        case 0: body.applyForce(push); break;
        case 1: body.applyForce(push, at); break;
        case 2: body.applyTorque(push.x()); break;
        case 3: body.applyImpulse(push); break;
        case 4: body.applyImpulse(push, at); break;
        default: body.applyAngularImpulse(push.x()); break;
    }
}

void setManner(RandomEditor& e) {
    Body body = e.some();
    const double value = e.number(-1, 2);
    const bool yes = e.chance(2);
    switch (e.random.integer(0, 6)) {
        case 0: body.setGravityScale(value); break;
        case 1: e.tryTo([&] { body.setLinearDamping(value); }); break;
        case 2: e.tryTo([&] { body.setAngularDamping(value); }); break;
        case 3: body.setFixedRotation(yes); break;
        case 4: body.setCanSleep(yes || value > -0.5); break;
        case 5: body.setTag(e.random.bits()); break;
        default: e.world.setGravity(e.chance(3) ? e.vector(10) : Vec2(0, -10)); break;
    }
}

void setEnabled(RandomEditor& e) {
    Body body = e.some();
    body.setEnabled(!body.enabled() || !e.chance(3));
}

void rest(RandomEditor& e) {
    Body body = e.some();
    if (e.chance(3))
        body.wake();
    else
        body.sleep();
}

void useStale(RandomEditor& e) {
    if (e.removed.empty()) return;
    const BodyId id = e.removed[static_cast<std::size_t>(e.random.integer(0, static_cast<int>(e.removed.size()) - 1))];
    if (e.world.contains(id) || e.world.contains(ShapeId{id, 0})) FAIL("a stale id is taken for a live one");
    if (e.tryTo([&] { e.world.remove(id); })) FAIL("a stale body was removed");
    if (e.tryTo([&] { e.world.add(id, circle(1)); })) FAIL("a stale body got a shape");
    if (e.tryTo([&] { (void)e.world.shape({id, 0}); })) FAIL("a stale shape was read");
}

void useNonsense(RandomEditor& e) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Body body = e.some();
    if (e.tryTo([&] { body.setVelocity({nan, 0}); })) FAIL("nan was taken in");
    if (e.tryTo([&] { body.setPose({0, nan}, 0); })) FAIL("nan was taken in");
    if (e.tryTo([&] { e.world.add({.position = {nan, 0}}); })) FAIL("nan was taken in");
    if (e.tryTo([&] { e.world.step(-1); })) FAIL("a negative step was taken");
}

void passTime(RandomEditor& e) {
    const int kind = e.random.integer(0, 19);
    e.step(kind == 0 ? 0 : kind == 1 ? 1e-12 : kind == 2 ? e.number(0, 0.3) : 1.0 / 60);
}

void passMoreTime(RandomEditor& e) {
    for (int i = 0; i < 40; ++i) e.step(1.0 / 60);
}

bool passes(const Filter& a, const Filter& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

bool mayMeet(const ShapeDef& a, const ShapeDef& b) {
    return !a.sensor && !b.sensor && passes(a.filter, b.filter);
}

}  // namespace

ShapeDef RandomEditor::anyShape() {
    ShapeDef def;
    const Vec2 at = vector(0.6), other = at + Vec2(number(0.2, 1.5), 0);
    const double size = number(0.1, 0.7);
    switch (random.integer(0, 7)) {
        case 0: def.shape = Circle{size, at}; break;
        case 1: def.shape = Capsule{at, other, size}; break;
        case 2: def.shape = boxPolygon({size, 0.3}, at); break;
        case 3: def.shape = Polygon{{at, at + Vec2(1, 0), at + Vec2(0.5, size)}, 0.05}; break;
        case 4: def.shape = Segment{at, other}; break;
        case 5: def.shape = Chain{{at, other, other + Vec2(0.5, size)}, chance(2)}; break;
        default: def.shape = boxPolygon({0.5, 0.5}); break;
    }
    def.material = anyMaterial(*this);
    def.filter = anyFilter(*this);
    def.sensor = chance(6);
    if (chance(6)) def.oneWay = vector(1);
    if (chance(8)) def.rule = chance(2) ? fromFast : evenOnly;
    def.tag = random.bits();
    return def;
}

BodyId RandomEditor::makeBody() {
    BodyDef def;
    const int kind = random.integer(0, 9);
    def.type = kind == 0 ? BodyType::Static : kind == 1 ? BodyType::Kinematic : BodyType::Dynamic;
    def.position = vector(8) + Vec2(0, 8);
    def.angle = chance(2) ? 0 : number(-3, 3);
    def.fixedRotation = chance(6);
    if (def.type != BodyType::Static && chance(2)) {
        def.velocity = vector(5);
        if (!def.fixedRotation) def.angularVelocity = number(-5, 5);
    }
    def.canSleep = !chance(10);
    def.awake = !chance(6);
    def.enabled = !chance(10);
    if (def.type == BodyType::Dynamic && chance(4)) def.mass = Mass{number(0.5, 5), vector(0.3), number(0.1, 2)};
    const int count = random.integer(1, 3);
    for (int i = 0; i < count; ++i) def.shapes.push_back(anyShape());
    if (def.type == BodyType::Dynamic) def.shapes.push_back(circle(0.3));
    bodies.push_back(world.add(def));
    return bodies.back();
}

void RandomEditor::step(double dt) {
    world.step(dt);
    ++steps;
    lastStep_ = dt;
    followEvents();
    checkContacts();
    checkMoves();
    if (steps % 16 != 0) return;
    check();
    if (dt >= 1e-9) checkSensors();
}

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
            const ShapeDef def = world.shape(shape);
            all.push_back({shape, def, aabbOf(def.shape, body.pose()), body});
        }
    }
    const auto speedOf = [](const BodyView& b) { return b.velocity().norm() + 3 * std::fabs(b.angularVelocity()); };
    for (const Placed& sensor : all) {
        if (!sensor.def.sensor) continue;
        for (const Placed& other : all) {
            if (other.id.body == sensor.id.body || other.def.sensor) continue;
            const auto told = inside_.find(keyOf(sensor.id, other.id));
            const bool inside = told != inside_.end() && told->second > 0;
            if (!inside && !overlap(sensor.box, other.box)) continue;
            const bool fixed = sensor.body.type() == BodyType::Static && other.body.type() == BodyType::Static;
            const double apart =
                distance(sensor.def.shape, sensor.body.pose(), other.def.shape, other.body.pose()).separation;
            const bool truth = !fixed && passes(sensor.def.filter, other.def.filter) && apart <= 0;
            const double lag = 0.02 + 2 * lastStep_ * (speedOf(sensor.body) + speedOf(other.body));
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
    begins += static_cast<long long>(world.contactBegins().size());
    hits += static_cast<long long>(world.contactHits().size());
    visits += static_cast<long long>(world.sensorBegins().size());
    quarantines += static_cast<long long>(world.quarantines().size());
}

/// What touches is what events have told, and may.
void RandomEditor::checkContacts() {
    std::map<Key, int> now;
    for (const BodyId id : world.bodies()) {
        for (const Contact& contact : world.body(id).contacts()) {
            if (contact.shapeA.body != id) continue;
            ++now[keyOf(contact.shapeA, contact.shapeB)];
            if (!mayMeet(world.shape(contact.shapeA), world.shape(contact.shapeB))) FAIL("what may not touch does");
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
}

std::vector<RandomEditor::Action> bodyActions() {
    return {{20, makeOrRemove}, {4, removeBody}, {6, addShape}, {6, removeShape}, {20, setShape}, {6, setType},
            {6, setMass},       {10, setMotion}, {6, setPose},  {4, moveTo},      {10, push},     {6, setManner},
            {8, setEnabled},    {6, rest},       {2, useStale}, {1, useNonsense}, {60, passTime}, {1, passMoreTime}};
}

}  // namespace plumb::test
