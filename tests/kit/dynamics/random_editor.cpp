// SPDX-License-Identifier: MIT
#include "kit/dynamics/random_editor.h"

#include <algorithm>

namespace plumb::test {

namespace {

constexpr std::size_t mostBodies = 30;

bool fromFast(const ContactCandidate& question) {
    return question.velocity.dot(question.normal) < -1;
}

bool evenOnly(const ContactCandidate& question) {
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

void removeBody(RandomEditor& e) {
    e.removeBody(e.someBody());
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
    const ShapeId shape = e.someShape();
    if (!e.tryTo([&] { e.world.remove(shape); })) return;
    if (e.world.contains(shape)) FAIL("a removed shape is there");
    e.removedShapes.push_back(shape);
}

void setShape(RandomEditor& e) {
    const ShapeId shape = e.someShape();
    if (!e.world.contains(shape)) return;
    ShapeDef def = e.world.shape(shape).def();
    switch (e.random.integer(0, 6)) {
        case 0: def.material = anyMaterial(e); break;
        case 1: def.filter = e.anyFilter(); break;
        case 2: def.tag = e.random.bits(); break;
        case 3: def.sensor = !def.sensor; break;
        case 4: def.oneWay = def.oneWay ? std::nullopt : std::optional<Vec2>(e.vector(1)); break;
        case 5: def.rule = def.rule == nullptr ? evenOnly : nullptr; break;
        default: def = e.anyShape(); break;
    }
    if (e.tryTo([&] { e.world.shape(shape).set(def); }) && !(e.world.shape(shape).def().shape == def.shape))
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
    const Vec2 position = e.vector(e.chance(100) ? 1e100 : 8);
    e.some().setPose(position, e.number(-3, 3));
}

void moveTo(RandomEditor& e) {
    Body body = e.some();
    const Vec2 position = e.vector(8);
    const double angle = body.angle() + e.number(-1, 1), tick = e.number(-0.1, 2);
    e.tryTo([&] { body.moveTo(position, angle, tick); });
}

void push(RandomEditor& e) {
    Body body = e.some();
    const Vec2 push = e.vector(20), at = body.position() + e.vector(1);
    const bool done = e.tryTo([&] {
        switch (e.random.integer(0, 5)) {
            case 0: body.applyForce(push); break;
            case 1: body.applyForce(push, at); break;
            case 2: body.applyTorque(push.x()); break;
            case 3: body.applyImpulse(push); break;
            case 4: body.applyImpulse(push, at); break;
            default: body.applyAngularImpulse(push.x()); break;
        }
    });
    if (done != (body.type() == BodyType::Dynamic)) FAIL("what can be pushed is not what is dynamic");
}

void setManner(RandomEditor& e) {
    Body body = e.some();
    const double value = e.number(-1, 2);
    const bool yes = e.chance(2);
    switch (e.random.integer(0, 7)) {
        case 0: body.setGravityScale(value); break;
        case 1: e.tryTo([&] { body.setLinearDamping(value); }); break;
        case 2: e.tryTo([&] { body.setAngularDamping(value); }); break;
        case 3: body.setFixedRotation(yes); break;
        case 4: body.setCanSleep(yes || value > -0.5); break;
        case 5: body.setTag(e.random.bits()); break;
        case 6: body.setLocks(yes, e.chance(2)); break;
        default: e.world.setGravity(e.chance(3) ? e.vector(10) : Vec2(0, -10)); break;
    }
}

void setEnabled(RandomEditor& e) {
    Body body = e.some();
    body.setEnabled(!body.enabled() || !e.chance(3));
}

/// What has flown off meets nothing any more.
void fetchStrays(RandomEditor& e) {
    const std::vector<BodyId> all = e.bodies;
    for (const BodyId& body : all)
        if (!(e.world.body(body).position().norm() < 300)) e.removeBody(body);
}

void rest(RandomEditor& e) {
    Body body = e.some();
    if (e.chance(3))
        body.wake();
    else
        body.sleep();
}

void passTime(RandomEditor& e) {
    const int kind = e.random.integer(0, 19);
    e.step(kind == 0 ? 0 : kind == 1 ? 1e-12 : kind == 2 ? e.number(0, 0.3) : 1.0 / 60);
}

void passMoreTime(RandomEditor& e) {
    for (int i = 0; i < 20; ++i) e.step(1.0 / 60);
}

}  // namespace

RandomEditor::RandomEditor(std::uint64_t seed, const Manner& how)
    : manner(how),
      world({.hitSpeed = 0.5, .wrap = how.wrap, .ledger = how.ledger, .solver = {.lanes = how.lanes}}),
      random(seed),
      asker(~seed) {
    BodyDef ground{.type = BodyType::Static, .shapes = {segment({-12, 0}, {12, 0}), chain({{-12, 8}, {-12, 0}})}};
    ground.shapes.push_back(box({1, 1}));
    bodies.push_back(world.add(ground));
}

void RandomEditor::run(const std::vector<Action>& actions, int calls) {
    int whole = 0;
    for (const Action& action : actions) whole += action.weight;
    for (int call = 0; call < calls; ++call) {
        int left = random.integer(0, whole - 1);
        for (const Action& action : actions) {
            left -= action.weight;
            if (left >= 0) continue;
            action.act(*this);
            break;
        }
    }
}

double RandomEditor::amount(double usual) {
    if (!goesWild()) return number(0, usual);
    return oneOf<double>({0, 1e-12, 1e-6, 1e-3, 1e3, 1e6, 1e9, 1e15, 1e30, infinity}) * usual;
}

bool RandomEditor::passes(const Filter& a, const Filter& b) {
    if (a.group != 0 && a.group == b.group) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

Filter RandomEditor::anyFilter() {
    Filter filter;
    if (chance(3)) filter.category = chance(2) ? 2 : 3;
    if (chance(3)) filter.mask = chance(2) ? 1 : 3;
    if (chance(8)) filter.group = chance(2) ? 1 : -1;
    return filter;
}

ShapeId RandomEditor::someShape() {
    const std::vector<ShapeId> shapes = some().shapes();
    return shapes.empty() ? ShapeId{} : oneOf(shapes);
}

void RandomEditor::removeBody(BodyId body) {
    world.remove(body);
    forgetJointsOf(body);
    std::erase(bodies, body);
    removed.push_back(body);
}

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
    def.filter = anyFilter();
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
    def.lockX = chance(16);
    def.lockY = chance(16);
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

void RandomEditor::step(double tick) {
    placesBefore_.clear();
    for (const BodyId& id : bodies) placesBefore_[id.index] = {world.body(id).position(), world.body(id).angle()};
    world.step(tick);
    ++tally.steps;
    lastStep_ = tick;
    followEvents();
    followBreaks();
    if (manner.ledger) checkLedger();
    checkContacts();
    checkMoves();
    if (tally.steps % 16 != 0) return;
    check();
    if (tick >= 1e-9) checkSensors();
}

std::vector<RandomEditor::Action> bodyActions() {
    return {{20, makeOrRemove}, {4, removeBody}, {6, addShape},  {6, removeShape},  {20, setShape},  {6, setType},
            {6, setMass},       {10, setMotion}, {6, setPose},   {4, moveTo},       {10, push},      {6, setManner},
            {8, setEnabled},    {6, rest},       {36, passTime}, {1, passMoreTime}, {4, fetchStrays}};
}

namespace {

using Family = std::vector<RandomEditor::Action> (*)();

std::vector<RandomEditor::Action> together(std::initializer_list<Family> families) {
    std::vector<RandomEditor::Action> all;
    for (const Family family : families) {
        const std::vector<RandomEditor::Action> some = family();
        all.insert(all.end(), some.begin(), some.end());
    }
    return all;
}

}  // namespace

std::vector<RandomEditor::Action> wrappedActions() {
    return together({bodyActions, jointActions, refusedActions, worldActions, fieldActions, copyActions});
}

std::vector<RandomEditor::Action> allActions() {
    return together({bodyActions, jointActions, queryActions, refusedActions, worldActions, fieldActions, copyActions});
}

}  // namespace plumb::test
