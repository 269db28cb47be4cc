// SPDX-License-Identifier: MIT
// Which fields may come, change and go, and which blasts?
#include <algorithm>

#include "kit/dynamics/random_editor.h"

namespace plumb::test {

namespace {

constexpr std::size_t mostFields = 4;

Attractor anyAttractor(RandomEditor& e) {
    Attractor attractor;
    attractor.center = e.vector(8) + Vec2(0, 5);
    attractor.strength = e.eitherWay(100);
    attractor.power = e.random.integer(0, 9);
    attractor.softening = e.chance(3) ? 0 : e.amount(2);
    if (e.chance(2)) attractor.range = e.amount(10);
    return attractor;
}

Pool anyPool(RandomEditor& e) {
    Pool pool;
    pool.fluid = {.density = e.amount(10), .surface = e.vector(8), .gravity = e.vector(10)};
    pool.drag = e.amount(5);
    pool.flow = e.vector(3);
    return pool;
}

Drag anyDrag(RandomEditor& e) {
    Drag drag;
    drag.linear = e.chance(2) ? 0 : e.amount(5);
    drag.quadratic = e.chance(2) ? 0 : e.amount(1);
    drag.wind = e.vector(e.chance(10) ? 100 : 5);
    return drag;
}

GroundFriction anyGround(RandomEditor& e) {
    GroundFriction ground;
    ground.friction = e.amount(1);
    ground.lever = e.chance(2) ? 0 : e.amount(1);
    return ground;
}

FieldLaw anyLaw(RandomEditor& e) {
    switch (e.random.integer(0, 6)) {
        case 0: return UniformGravity{e.vector(e.goesWild() ? 1e9 : 5)};
        case 1: {
            const double constant = e.eitherWay(10);
            return MutualGravity{constant, e.chance(4) ? 0 : e.amount(1)};
        }
        case 2: return anyAttractor(e);
        case 3: {
            const BodyId body = e.someBody();
            return Magnet{body, anyAttractor(e)};
        }
        case 4: return anyPool(e);
        case 5: return anyGround(e);
        default: return anyDrag(e);
    }
}

FieldDef anyField(RandomEditor& e) {
    FieldDef field{.law = anyLaw(e)};
    if (e.chance(3)) field.region = e.anyShape().shape;
    if (e.chance(3)) field.region = Circle{e.amount(8), e.vector(8)};
    field.filter = e.anyFilter();
    return field;
}

bool isOfTheKind(const World& world, const FieldId& field, const FieldDef& def) {
    return world.field(field).def().law.index() == def.law.index() && world.field(field).def().region == def.region;
}

void removeField(RandomEditor& e) {
    if (e.fields.empty()) return;
    const FieldId field = e.oneOf(e.fields);
    e.world.remove(field);
    std::erase(e.fields, field);
    e.ended.push_back(field);
}

void addField(RandomEditor& e) {
    if (e.fields.size() >= mostFields) return removeField(e);
    const FieldDef def = anyField(e);
    FieldId field;
    if (!e.tryTo([&] { field = e.world.addField(def); })) return;
    if (!e.world.contains(field) || !isOfTheKind(e.world, field, def)) FAIL("a field is not what was given");
    e.fields.push_back(field);
    ++e.tally.fields;
}

void setField(RandomEditor& e) {
    if (e.fields.empty()) return;
    const FieldId field = e.oneOf(e.fields);
    const FieldDef def = anyField(e);
    if (e.tryTo([&] { e.world.field(field).set(def); }) && !isOfTheKind(e.world, field, def))
        FAIL("a field is not what it was set to");
}

void explode(RandomEditor& e) {
    Explosion blast;
    blast.center = e.vector(8) + Vec2(0, 5);
    blast.radius = e.amount(3);
    blast.falloff = e.amount(3);
    blast.impulsePerLength = e.eitherWay(20);
    const Filter filter = e.anyFilter();
    if (e.tryTo([&] { e.world.explode(blast, filter); })) ++e.tally.blasts;
}

/// Those that were removed, and those that no world ever had.
void useStaleField(RandomEditor& e) {
    if (e.ended.empty()) return;
    const FieldId stale = e.oneOf(e.ended);
    const FieldId neverMade{stale.index, stale.generation + 1'000'000, stale.world};
    for (const FieldId& field : {stale, neverMade, FieldId{}}) {
        if (e.world.contains(field)) FAIL("a wrong id is taken for a live one");
        const std::string why = field == stale ? "was removed" : field == neverMade ? "there never was" : "never set";
        for (const std::string& said :
             {e.refusalOf([&] { e.world.remove(field); }), e.refusalOf([&] { e.world.field(field).set({}); }),
              e.refusalOf([&] { (void)e.world.field(field).def(); })}) {
            INFO("it said: " << said);
            if (said.find(why) == std::string::npos) FAIL("what should be refused as \"" << why << "\" was not");
            ++e.tally.refusals;
        }
    }
}

}  // namespace

void RandomEditor::checkFields() const {
    std::vector<FieldId> made = fields;
    std::sort(made.begin(), made.end(), [](const FieldId& a, const FieldId& b) { return a.index < b.index; });
    if (world.fields() != made) FAIL("fields are not those that were made");
}

std::vector<RandomEditor::Action> fieldActions() {
    return {{4, addField}, {2, setField}, {4, removeField}, {4, explode}, {1, useStaleField}};
}

}  // namespace plumb::test
