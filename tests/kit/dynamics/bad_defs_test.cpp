// SPDX-License-Identifier: MIT
#include <plumb/record/state_hash.h>
#include "catch.h"
#include "kit/dynamics/bad_input.h"

namespace plumb::test {

namespace {

BadNumbers outOf(const std::vector<std::pair<double, std::string>>& values, const std::string& range) {
    BadNumbers bads;
    for (const auto& [value, text] : values) bads.push_back({value, text, "is not within " + range});
    return bads;
}

const Fields<SolverSettings> solverFields{
    with(Field<SolverSettings>{"subSteps"},
         {{[](SolverSettings& s) { s.subSteps = 0; }, "", "0 is not within 1 to 64"},
          {[](SolverSettings& s) { s.subSteps = 65; }, "", "65 is not within 1 to 64"},
          {[](SolverSettings& s) { s.subSteps = -4; }, "", "-4 is not within 1 to 64"}}),
    number("contactFrequency", &SolverSettings::contactFrequency, notPositive),
    number("contactDampingRatio", &SolverSettings::contactDampingRatio, notPositive),
    number("contactPushSpeed", &SolverSettings::contactPushSpeed, notPositive),
    number("sleepSpeed", &SolverSettings::sleepSpeed, negative),
    number("sleepTime", &SolverSettings::sleepTime, negative),
    with(Field<SolverSettings>{"lanes"}, {{[](SolverSettings& s) { s.lanes = 0; }, "", "0 is not 1, 4, 8 or 16"},
                                          {[](SolverSettings& s) { s.lanes = 5; }, "", "5 is not 1, 4, 8 or 16"},
                                          {[](SolverSettings& s) { s.lanes = -1; }, "", "-1 is not 1, 4, 8 or 16"}}),
};

const Fields<WorldDef> worldFields{
    number("gravity", &WorldDef::gravity, notFinite),
    anything<WorldDef>("sleeping"),
    anything<WorldDef>("wrap"),  // refused as wrap_test.cpp shows
    anything<WorldDef>("ledger"),
    number("hitSpeed", &WorldDef::hitSpeed, negativeBound),
    nested("solver", &WorldDef::solver, solverFields),
};

const std::string noMass = "is not a positive finite mass", noInertia = "is not a positive finite moment of inertia";

BadNumbers saying(const std::string& complaint) {
    BadNumbers bads;
    for (const BadNumber& bad : notPositive) bads.push_back({bad.value, bad.text, complaint});
    return bads;
}

const Fields<Mass> massFields{
    number("mass", &Mass::mass, joined(saying(noMass), outOf({{1e-13, "1e-13"}, {1e13, "10000000000000"}}, "1e-12"))),
    with(number("center", &Mass::center, notFinite),
         {{[](Mass& m) {
               m.center = {0, -2e5};
           },
           "", "(0, -200000) is more than 100000 m from the body's origin"}}),
    with(number("inertia", &Mass::inertia, saying(noInertia)),
         {{[](Mass& m) { m.inertia = 1e-13; }, ", its radius of gyration", "is not within 1e-06 to 1000000"},
          {[](Mass& m) { m.inertia = 1e13; }, ", its radius of gyration", "is not within 1e-06 to 1000000"}}),
};

const Fields<Circle> circleFields{
    number("radius", &Circle::radius, notPositive),
    number("center", &Circle::center, notFinite),
};
const Fields<Capsule> capsuleFields{
    number("start", &Capsule::start, notFinite),
    with(number("end", &Capsule::end, notFinite),
         {{[](Capsule& c) { c.end = c.start; }, "", "(-0.5, 0) is the same point as start"}}),
    number("radius", &Capsule::radius, notPositive),
};

/// All corners wrong in turn, and all that no corner can help.
const std::vector<Spoil<Polygon>> cornerSpoils{
    {[](Polygon& p) { p.vertices.clear(); }, "", "0 corners are fewer than 3"},
    {[](Polygon& p) { p.vertices.resize(2); }, "", "2 corners are fewer than 3"},
    {[](Polygon& p) {
         p.vertices.assign(65, {0, 0});
     },
     "", "65 corners are more than 64"},
    {[](Polygon& p) { p.vertices[0].x() = nan; }, "[0]", "(nan, -1) is not finite"},
    {[](Polygon& p) { p.vertices[3].y() = infinity; }, "[3]", "(-1, inf) is not finite"},
    {[](Polygon& p) { p.vertices[2] = p.vertices[1]; }, "[2]", "(1, -1) repeats the corner before it"},
    {[](Polygon& p) {
         p.vertices = {{-1, -1}, {0, -1}, {1, -1}, {1, 1}};
     },
     "[1]", "(0, -1) lies in line with the corners beside it"},
    {[](Polygon& p) {
         p.vertices[2] = {0, -0.5};
     },
     "[2]", "(0, -0.5) makes the polygon not convex"},
    {[](Polygon& p) { std::swap(p.vertices[0], p.vertices[2]); }, "", "run clockwise, not counter-clockwise"},
};
const Fields<Polygon> polygonFields{
    with(Field<Polygon>{"vertices",
                        {},
                        {[](Polygon& p, double v) {
                             p = boxPolygon({std::fabs(v), 1});
                         },
                         [](Polygon& p, double v) {
                             p = boxPolygon({std::fabs(v), std::fabs(v)});
                         }}},
         cornerSpoils),
    number("radius", &Polygon::radius, negative),
};
const Fields<Segment> segmentFields{
    number("start", &Segment::start, notFinite),
    with(number("end", &Segment::end, notFinite),
         {{[](Segment& s) { s.end = s.start; }, "", "(0, 0) is the same point as start"}}),
    with(number("before", &Segment::before, notFinite),
         {{[](Segment& s) { s.before = s.start; }, "", "(0, 0) is the end of the segment"},
          {[](Segment& s) { s.before = Vec2(0.5, 0); }, "", "(0.5, 0) folds the line straight back on itself"}}),
    with(number("after", &Segment::after, notFinite),
         {{[](Segment& s) { s.after = s.end; }, "", "(1, 0) is the end of the segment"},
          {[](Segment& s) { s.after = Vec2(0.5, 0); }, "", "(0.5, 0) folds the line straight back on itself"}}),
};
const Fields<Chain> chainFields{
    with(Field<Chain>{"points", {}, {[](Chain& c, double v) { c.points[2].x() = v; }}},
         {{[](Chain& c) { c.points.clear(); }, "", "0 points are fewer than 2"},
          {[](Chain& c) { c.points.resize(1); }, "", "1 points are fewer than 2"},
          {[](Chain& c) { c.points.resize(2), c.closed = true; }, "", "2 points are fewer than 3 of a closed chain"},
          {[](Chain& c) { c.points[1].x() = nan; }, "[1]", "(nan, 0) is not finite"},
          {[](Chain& c) { c.points[2].y() = -infinity; }, "[2]", "(2, -inf) is not finite"},
          {[](Chain& c) { c.points[2] = c.points[1]; }, "[2]", "(1, 0) repeats the point before it"},
          {[](Chain& c) {
               c.points[2] = {0.5, 0};
           },
           "[1]", "(1, 0) folds the line straight back on itself"}}),
    anything<Chain>("closed"),
};

Field<Material> mixture(const std::string& name, Mix Material::*at) {
    const std::string wanted = " is none of Average, GeometricMean, Minimum, Product and Maximum";
    return with(Field<Material>{name}, {{[at](Material& m) { m.*at = static_cast<Mix>(5); }, "", "5" + wanted},
                                        {[at](Material& m) { m.*at = static_cast<Mix>(-1); }, "", "-1" + wanted}});
}

const Fields<Material> materialFields{
    number("density", &Material::density, negative),
    number("friction", &Material::friction, negative),
    number("restitution", &Material::restitution, joined(notFinite, outOf({{-0.1, "-0.1"}, {1.1, "1.1"}}, "0 to 1"))),
    number("rollingResistance", &Material::rollingResistance, negative),
    number("surfaceSpeed", &Material::surfaceSpeed, notFinite),
    mixture("frictionMix", &Material::frictionMix),
    mixture("restitutionMix", &Material::restitutionMix),
};

const Fields<Filter> filterFields{anything<Filter>("category"), anything<Filter>("mask"), anything<Filter>("group")};

/// One of each kind, sound, put into the def.
template <class Kind>
Field<ShapeDef> outlineField(const Kind& sound, const Fields<Kind>& fields) {
    return nested<ShapeDef, Kind>(
        "shape", "",
        [sound](ShapeDef& def) -> Kind& {
            if (!std::holds_alternative<Kind>(def.shape)) def.shape = sound;
            return std::get<Kind>(def.shape);
        },
        fields);
}

Field<ShapeDef> anyOutline() {
    Field<ShapeDef> field{"shape"};
    field = with(field, outlineField(Circle{.radius = 0.4}, circleFields));
    field = with(field, outlineField(Capsule{}, capsuleFields));
    field = with(field, outlineField(Polygon{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}, polygonFields));
    field = with(field, outlineField(Segment{}, segmentFields));
    return with(field, outlineField(Chain{{{0, 0}, {1, 0}, {2, 0}}}, chainFields));
}

/// What one body can have: beyond that, the shape is sound but too far out.
const std::vector<Spoil<ShapeDef>> farAway{
    {[](ShapeDef& d) {
         d.shape = Circle{.radius = 1, .center = {2e5, 0}};
     },
     "", "200001 m from the body's origin"},
    {[](ShapeDef& d) { d.shape = Circle{.radius = 1e6}; }, "", "1000000 m from the body's origin"},
};

const Fields<ShapeDef> shapeFields{
    with(anyOutline(), farAway),
    nested("material", &ShapeDef::material, materialFields),
    nested("filter", &ShapeDef::filter, filterFields),
    anything<ShapeDef>("sensor"),
    with(number("oneWay", &ShapeDef::oneWay, notFinite),
         {{[](ShapeDef& d) { d.oneWay = Vec2(0, 0); }, "", "(0, 0) is no direction"}}),
    anything<ShapeDef>("rule"),
    anything<ShapeDef>("tag"),
};

Field<BodyDef> bodyShapes() {
    const std::string why = "is not a positive finite mass (a dynamic body needs a shape with area and density";
    Field<BodyDef> field = nested<BodyDef, ShapeDef>(
        "shapes", "[1]", [](BodyDef& def) -> ShapeDef& { return def.shapes[1]; }, shapeFields);
    return with(field, {{[](BodyDef& d) { d.shapes.clear(); }, ".mass", "0 " + why},
                        {[](BodyDef& d) {
                             d.shapes = {segment({0, 0}, {1, 0})};
                         },
                         ".mass", "0 " + why},
                        {[](BodyDef& d) { d.shapes[0].material.density = d.shapes[1].material.density = 0; }, ".mass",
                         "0 " + why},
                        {[](BodyDef& d) { d.shapes[0].material.density = 1e20; }, ".mass", "is not within 1e-12"}});
}

void asStatic(BodyDef& def) {
    def = {.type = BodyType::Static, .shapes = def.shapes};
}

const Fields<BodyDef> bodyFields{
    with(Field<BodyDef>{"type"},
         {{[](BodyDef& d) { d.type = static_cast<BodyType>(3); }, "", "3 is none of Static, Kinematic and Dynamic"},
          {[](BodyDef& d) { d.type = static_cast<BodyType>(-1); }, "", "-1 is none of Static, Kinematic and Dynamic"}}),
    number("position", &BodyDef::position, notFinite),
    number("angle", &BodyDef::angle, notFinite),
    with(number("velocity", &BodyDef::velocity, notFinite), {{[](BodyDef& d) {
                                                                  asStatic(d), d.velocity = {0, 2};
                                                              },
                                                              "", "(0, 2) on a static body, not (0, 0)"}}),
    with(number("angularVelocity", &BodyDef::angularVelocity, notFinite),
         {{[](BodyDef& d) { asStatic(d), d.angularVelocity = 2; }, "", "2 on a static body, not 0"},
          {[](BodyDef& d) { d.fixedRotation = true, d.angularVelocity = 2; }, "", "2 on a body of fixed rotation"}}),
    number("gravityScale", &BodyDef::gravityScale, notFinite),
    number("linearDamping", &BodyDef::linearDamping, negative),
    number("angularDamping", &BodyDef::angularDamping, negative),
    anything<BodyDef>("fixedRotation"),
    anything<BodyDef>("lockX"),
    anything<BodyDef>("lockY"),
    anything<BodyDef>("canSleep"),
    anything<BodyDef>("awake"),
    anything<BodyDef>("enabled"),
    anything<BodyDef>("tag"),
    with(nested<BodyDef, Mass>(
             "mass", "",
             [](BodyDef& d) -> Mass& {
                 return d.mass.emplace(Mass{1, {0, 0}, 1});
             },
             massFields),
         {{[](BodyDef& d) {
               asStatic(d), d.mass = Mass{2, {0, 0}, 1};
           },
           "", "2 kg given to a body that is not dynamic"}}),
    bodyShapes(),
};

const BodyDef soundBody{.position = {2, 8}, .velocity = {1, 0}, .shapes = {box({0.5, 0.5}), circle(0.4)}};

/// Where it falls on the floor, and other things lie on it.
void takeBody(Bench& bench, const BodyDef& def) {
    BodyDef placed = def;
    bench.world.add(placed);
    bench.world.add({.position = {2.1, 9.5}, .shapes = {circle(0.4)}});
}

void takeShape(Bench& bench, const ShapeDef& def) {
    bench.world.add(bench.crate, def);
}

void replaceShape(Bench& bench, const ShapeDef& def) {
    bench.world.shape(bench.liftShape).set(def);
}

void takeWorld(Bench& bench, const WorldDef& def) {
    World world(def);
    const BodyId floor = world.add({.type = BodyType::Static, .shapes = {box({20, 0.5})}});
    for (int i = 0; i < 3; ++i) world.add({.position = {0.1 * i, 1.0 + i}, .shapes = {box({0.5, 0.5})}});
    const BodyId bob = world.add({.position = {3, 2}, .shapes = {circle(0.5)}});
    world.join(RevoluteJointDef{.bodyA = floor, .bodyB = bob, .anchor = {2, 2}});
    bench.world = std::move(world);
}

const ShapeDef soundShape = circle(0.3);

}  // namespace

Covered coveredDefs() {
    Covered covered;
    cover(covered, "SolverSettings", solverFields);
    cover(covered, "WorldDef", worldFields);
    cover(covered, "Mass", massFields);
    cover(covered, "Circle", circleFields);
    cover(covered, "Capsule", capsuleFields);
    cover(covered, "Polygon", polygonFields);
    cover(covered, "Segment", segmentFields);
    cover(covered, "Chain", chainFields);
    cover(covered, "Material", materialFields);
    cover(covered, "Filter", filterFields);
    cover(covered, "ShapeDef", shapeFields);
    cover(covered, "BodyDef", bodyFields);
    return covered;
}

TEST_CASE("each field of a WorldDef is refused by name, value and wish when it is wrong", "[dynamics][errors]") {
    for (const std::string& fault : faultsOf("WorldDef", worldFields, WorldDef{}, takeWorld)) CHECK(fault == "");
}

TEST_CASE("each field of a BodyDef and its mass, shapes and materials is refused when it is wrong",
          "[dynamics][errors]") {
    for (const std::string& fault : faultsOf("BodyDef", bodyFields, soundBody, takeBody)) CHECK(fault == "");
}

TEST_CASE("each field of a ShapeDef that is added or set is refused when it is wrong", "[dynamics][errors]") {
    for (const std::string& fault : faultsOf("ShapeDef", shapeFields, soundShape, takeShape)) CHECK(fault == "");
    for (const std::string& fault : faultsOf("ShapeDef", shapeFields, soundShape, replaceShape)) CHECK(fault == "");
}

TEST_CASE("numbers from 1e-320 to 1.7e308 in a WorldDef are refused, or leave every body finite or quarantined",
          "[dynamics][errors]") {
    for (const std::string& fault : unsoundWith("WorldDef", worldFields, WorldDef{}, takeWorld)) CHECK(fault == "");
}

TEST_CASE(
    "numbers from 1e-320 to 1.7e308 in a BodyDef or ShapeDef are refused, or leave every body finite or "
    "quarantined",
    "[dynamics][errors]") {
    for (const std::string& fault : unsoundWith("BodyDef", bodyFields, soundBody, takeBody)) CHECK(fault == "");
    BodyDef weighed = soundBody;
    weighed.mass = Mass{1, {0, 0}, 1};
    for (const std::string& fault : unsoundWith("BodyDef", bodyFields, weighed, takeBody)) CHECK(fault == "");
    for (const std::string& fault : unsoundWith("ShapeDef", shapeFields, soundShape, takeShape)) CHECK(fault == "");
    for (const std::string& fault : unsoundWith("ShapeDef", shapeFields, soundShape, replaceShape)) CHECK(fault == "");
}

}  // namespace plumb::test
