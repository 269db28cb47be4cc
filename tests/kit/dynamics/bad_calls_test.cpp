// SPDX-License-Identifier: MIT
// Is each call with a wrong argument refused, by name, value and wish?
#include "catch.h"
#include "kit/dynamics/bad_call.h"

namespace plumb::test {

namespace {

// Not written as braces in the calls, so that each of them stays on its line.
const Vec2 nowhere{0, 0}, right1{1, 0};
const Circle disc1{.radius = 1};

Body ball(Bench& b) {
    return b.world.body(b.ball);
}
Body lift(Bench& b) {
    return b.world.body(b.lift);
}
Body crate(Bench& b) {
    return b.world.body(b.crate);
}
Body floorOf(Bench& b) {
    return b.world.body(b.floor);
}
const World& asConst(Bench& b) {
    return b.world;
}

void addWorldCalls(BadCalls& c) {
    c.numbers({"World.step", "dt"}, negative, [](Bench& b, double v) { b.world.step(v); });
    c.vectors({"World.setGravity", "gravity"}, [](Bench& b, const Vec2& v) { b.world.setGravity(v); });
    c.bodyIds({"World.add", "body", "BodyId"}, [](Bench& b, BodyId id) { b.world.add(id, circle(1)); });
    c.bodyIds({"World.remove", "body", "BodyId"}, [](Bench& b, BodyId id) { b.world.remove(id); });
    c.shapeIds({"World.remove", "shape", "ShapeId"}, [](Bench& b, ShapeId id) { b.world.remove(id); });
    c.jointIds("World.remove", [](Bench& b, JointId id) { b.world.remove(id); });
    c.bodyIds({"World.body", "body", "BodyId"}, [](Bench& b, BodyId id) { b.world.body(id); });
    c.bodyIds({"World.body", "body", "BodyId"}, [](Bench& b, BodyId id) { asConst(b).body(id); });
    c.jointIds("World.joint", [](Bench& b, JointId id) { b.world.joint(id); });
    c.jointIds("World.joint", [](Bench& b, JointId id) { asConst(b).joint(id); });
    c.shapeIds({"World.shape", "shape", "ShapeId"}, [](Bench& b, ShapeId id) { b.world.shape(id); });
    c.shapeIds({"World.shape", "shape", "ShapeId"}, [](Bench& b, ShapeId id) { asConst(b).shape(id); });
    c.shapeIds({"World.tiles", "shape", "World.tiles: ShapeId"}, [](Bench& b, ShapeId id) { b.world.tiles(id); });
    c.shapeIds({"World.setTile", "shape", "World.setTile: ShapeId"},
               [](Bench& b, ShapeId id) { b.world.setTile(id, Cell{}, {}); });
    constexpr std::size_t tooMany = ~std::size_t{0};
    for (const auto& [member, capacity] :
         std::vector<std::pair<std::string, Capacity>>{{"bodies", {.bodies = tooMany}},
                                                       {"shapes", {.shapes = tooMany}},
                                                       {"contacts", {.contacts = tooMany}},
                                                       {"joints", {.joints = tooMany}}})
        c.one({"World.reserve", "capacity", "Capacity." + member}, std::to_string(tooMany) + " is more than",
              [most = capacity](Bench& b) { b.world.reserve(most); });
}

void addCasts(BadCalls& c) {
    using Ray = std::function<void(World&, const Vec2&, const Vec2&, BodyId)>;
    const auto ray = [&](const std::string& name, const Ray& cast) {
        c.vectors({name, "from"}, [=](Bench& b, const Vec2& v) { cast(b.world, v, nowhere, {}); });
        c.vectors({name, "to"}, [=](Bench& b, const Vec2& v) { cast(b.world, nowhere, v, {}); });
        c.otherBodyIds({name, "ignored", name + ": ignored"},
                       [=](Bench& b, BodyId id) { cast(b.world, nowhere, right1, id); });
    };
    ray("World.castRay", [](World& w, const Vec2& from, const Vec2& to, BodyId no) { w.castRay(from, to, {}, no); });
    ray("World.castRayAll",
        [](World& w, const Vec2& from, const Vec2& to, BodyId no) { w.castRayAll(from, to, {}, no); });
    using Cast = std::function<void(World&, const Shape&, const Transform&, const Vec2&, BodyId)>;
    const auto shape = [&](const std::string& name, const Cast& cast) {
        c.shapes(name, [=](Bench& b, const Shape& s) { cast(b.world, s, {}, right1, {}); });
        c.poses(name, [=](Bench& b, const Transform& t) { cast(b.world, disc1, t, right1, {}); });
        c.vectors({name, "shift"}, [=](Bench& b, const Vec2& v) { cast(b.world, disc1, {}, v, {}); });
        c.otherBodyIds({name, "ignored", name + ": ignored"},
                       [=](Bench& b, BodyId id) { cast(b.world, disc1, {}, right1, id); });
    };
    shape("World.castShape", [](World& w, const Shape& s, const Transform& t, const Vec2& shift, BodyId no) {
        w.castShape(s, t, shift, {}, no);
    });
    shape("World.castShapeAll", [](World& w, const Shape& s, const Transform& t, const Vec2& shift, BodyId no) {
        w.castShapeAll(s, t, shift, {}, no);
    });
    shape("World.castShapePieces", [](World& w, const Shape& s, const Transform& t, const Vec2& shift, BodyId no) {
        w.castShapePieces(s, t, shift, {}, no);
    });
}

void addOtherQueries(BadCalls& c) {
    c.shapes("World.overlapShape", [](Bench& b, const Shape& s) { b.world.overlapShape(s, {}); });
    c.poses("World.overlapShape", [](Bench& b, const Transform& t) { b.world.overlapShape(disc1, t); });
    c.vectors({"World.overlapPoint", "point"}, [](Bench& b, const Vec2& v) { b.world.overlapPoint(v); });
    c.vectors({"World.nearest", "point"}, [](Bench& b, const Vec2& v) { b.world.nearest(v, 1); });
    c.numbers({"World.nearest", "within"}, {{nan, "nan", "is not a distance"}, {-1, "-1", "is not a distance"}},
              [](Bench& b, double v) { b.world.nearest(nowhere, v); });
    const std::string box = "World.overlapBox", upper = box + ": box.upper";
    c.vectors({box, "box", box + ": box.lower"}, [](Bench& b, const Vec2& v) {
        b.world.overlapBox(Aabb{v, Vec2(2, 2)});
    });
    c.vectors({box, "box", upper}, [](Bench& b, const Vec2& v) { b.world.overlapBox(Aabb{nowhere, v}); });
    for (const Vec2& lower : {Vec2(2, 0), Vec2(0, 2)})
        c.one({box, "box", upper},
              lower.x() > 0 ? "(1, 1) is below box.lower (2, 0)" : "(1, 1) is below box.lower (0, 2)", [=](Bench& b) {
                  b.world.overlapBox(Aabb{lower, Vec2(1, 1)});
              });
    c.shapeIds({"World.distance", "a", "World.distance: a"},
               [](Bench& b, ShapeId id) { (void)b.world.distance(id, b.liftShape); });
    c.shapeIds({"World.distance", "b", "World.distance: b"},
               [](Bench& b, ShapeId id) { (void)b.world.distance(b.liftShape, id); });
}

void addBodyCalls(BadCalls& c) {
    c.vectors({"BodyView.velocityAt", "point"}, [](Bench& b, const Vec2& v) { (void)ball(b).velocityAt(v); });
    c.vectors({"Body.setVelocity", "velocity"}, [](Bench& b, const Vec2& v) { ball(b).setVelocity(v); });
    c.numbers({"Body.setAngularVelocity", "angularVelocity"}, notFinite,
              [](Bench& b, double v) { ball(b).setAngularVelocity(v); });
    c.vectors({"Body.setPose", "position"}, [](Bench& b, const Vec2& v) { ball(b).setPose(v, 0); });
    c.numbers({"Body.setPose", "angle"}, notFinite, [](Bench& b, double v) { ball(b).setPose(nowhere, v); });
    c.vectors({"Body.moveTo", "position"}, [](Bench& b, const Vec2& v) { lift(b).moveTo(v, 0, 1); });
    c.numbers({"Body.moveTo", "angle"}, notFinite, [](Bench& b, double v) { lift(b).moveTo(nowhere, v, 1); });
    c.numbers({"Body.moveTo", "dt"}, notPositive, [](Bench& b, double v) { lift(b).moveTo(nowhere, 0, v); });
    c.vectors({"Body.applyForce", "force"}, [](Bench& b, const Vec2& v) { ball(b).applyForce(v); });
    c.vectors({"Body.applyForce", "force"}, [](Bench& b, const Vec2& v) { ball(b).applyForce(v, nowhere); });
    c.vectors({"Body.applyForce", "at"}, [](Bench& b, const Vec2& v) { ball(b).applyForce(right1, v); });
    c.numbers({"Body.applyTorque", "torque"}, notFinite, [](Bench& b, double v) { ball(b).applyTorque(v); });
    c.vectors({"Body.applyImpulse", "impulse"}, [](Bench& b, const Vec2& v) { ball(b).applyImpulse(v); });
    c.vectors({"Body.applyImpulse", "impulse"}, [](Bench& b, const Vec2& v) { ball(b).applyImpulse(v, nowhere); });
    c.vectors({"Body.applyImpulse", "at"}, [](Bench& b, const Vec2& v) { ball(b).applyImpulse(right1, v); });
    c.numbers({"Body.applyAngularImpulse", "impulse"}, notFinite,
              [](Bench& b, double v) { ball(b).applyAngularImpulse(v); });
    c.numbers({"Body.setGravityScale", "scale"}, notFinite, [](Bench& b, double v) { ball(b).setGravityScale(v); });
    c.numbers({"Body.setLinearDamping", "damping"}, negative, [](Bench& b, double v) { ball(b).setLinearDamping(v); });
    c.numbers({"Body.setAngularDamping", "damping"}, negative,
              [](Bench& b, double v) { ball(b).setAngularDamping(v); });
}

/// What a body of this type, or of this mass, cannot take.
void addCallsOfWrongBodies(BadCalls& c) {
    const std::string none = " is none of Static, Kinematic and Dynamic";
    c.one({"Body.setType", "type"}, "3" + none, [](Bench& b) { ball(b).setType(static_cast<BodyType>(3)); });
    c.one({"Body.setType", "type"}, "-1" + none, [](Bench& b) { lift(b).setType(static_cast<BodyType>(-1)); });
    const auto mass = [&](const Mass& bad, const std::string& member, const std::string& complaint) {
        c.one({"Body.setMass", "mass", "Body.setMass: mass" + member}, complaint,
              [=](Bench& b) { ball(b).setMass(bad); });
    };
    mass({0, {0, 0}, 1}, ".mass", "0 is not");
    mass({nan, {0, 0}, 1}, ".mass", "nan is not");
    mass({1, {nan, 0}, 1}, ".center", "(nan, 0)");
    mass({1, {0, 0}, -1}, ".inertia", "-1 is not");
    const Mass one{1, {0, 0}, 1};
    c.one({"Body.setMass", "mass", "Body.setMass"}, "static", [=](Bench& b) { floorOf(b).setMass(one); });
    c.one({"Body.setMassFromShapes", "", "Body.setMassFromShapes"}, "kinematic",
          [](Bench& b) { lift(b).setMassFromShapes(); });
    c.one({"Body.setVelocity", "velocity"}, "(1, 2)", [](Bench& b) { floorOf(b).setVelocity(Vec2(1, 2)); });
    c.one({"Body.setAngularVelocity", "angularVelocity"}, "3", [](Bench& b) { floorOf(b).setAngularVelocity(3); });
    c.one({"Body.moveTo", "position", "Body.moveTo"}, "dynamic", [](Bench& b) { ball(b).moveTo(nowhere, 0, 1); });
    c.one({"Body.moveTo", "position", "Body.moveTo: position, for the velocity it takes"}, "(inf, ",
          [](Bench& b) { lift(b).moveTo(Vec2(1e308, 0), 0, 1e-9); });
    c.one({"Body.moveTo", "angle", "Body.moveTo: angle, for the angular velocity it takes"}, "inf is",
          [](Bench& b) { lift(b).moveTo(nowhere, 1e308, 1e-9); });
    const std::string spin = ": impulse, for the angular velocity it would give";
    c.one({"Body.applyImpulse", "impulse", "Body.applyImpulse" + spin}, "inf is",
          [](Bench& b) { crate(b).applyImpulse(Vec2(1e308, 0), Vec2(0, 1e3)); });
    c.one({"Body.applyAngularImpulse", "impulse", "Body.applyAngularImpulse" + spin}, "inf is",
          [](Bench& b) { crate(b).applyAngularImpulse(1.7e308); });
    // A speed is refused by the name of the def's field.
    const BadNumbers beyond{{1e16, "1e+16", "is beyond 1e+15"}, {-1e16, "-1e+16", "is beyond 1e+15"}};
    for (const auto& [kind, joint] : std::vector<std::pair<std::string, JointId Bench::*>>{
             {"Revolute", &Bench::hinge}, {"Prismatic", &Bench::slide}, {"Distance", &Bench::rod}})
        c.numbers({"Joint.setMotorSpeed", "speed", kind + "JointDef.motorSpeed"}, joined(notFinite, beyond),
                  [at = joint](Bench& b, double v) { b.world.joint(b.*at).setMotorSpeed(v); });
}

std::vector<BadCall> allCalls() {
    BadCalls calls;
    for (auto* add :
         {addWorldCalls, addCasts, addOtherQueries, addBodyCalls, addCallsOfWrongBodies, addCallsWithoutWorld})
        add(calls);
    return calls.all;
}

/// A call with numbers of any size, of which none may leave a body that is neither finite nor in quarantine.
struct ExtremeCall {
    const char* name;
    std::function<void(Bench&, double)> call;
};

void runMotor(Bench& b, double speed) {
    Joint hinge = b.world.joint(b.hinge);
    auto def = std::get<RevoluteJointDef>(hinge.def());
    def.maxMotorTorque = 1;
    hinge.set(def), hinge.setMotorSpeed(speed);
}

void castShapes(Bench& b, double v) {
    b.world.castShapeAll(Circle{.radius = std::fabs(v)}, {}, right1);
    b.world.castShape(Circle{}, Transform{Vec2(v, v), {}}, Vec2(-v, -v));
}

void overlap(Bench& b, double v) {
    b.world.overlapBox({{-std::fabs(v), -1}, {std::fabs(v), 1}});
    b.world.overlapPoint({v, v});
    b.world.overlapShape(Circle{.radius = std::fabs(v)}, {{v, v}, {}});
}

const std::vector<ExtremeCall> extremeCalls{
    {"World.setGravity", [](Bench& b, double v) { b.world.setGravity(Vec2(v, -v)); }},
    {"World.step", [](Bench& b, double v) { b.world.step(v); }},
    {"Body.setVelocity", [](Bench& b, double v) { ball(b).setVelocity(Vec2(v, -v)); }},
    {"Body.setVelocity of a lift", [](Bench& b, double v) { lift(b).setVelocity(Vec2(-v, v)); }},
    {"Body.setAngularVelocity", [](Bench& b, double v) { ball(b).setAngularVelocity(v); }},
    {"Body.setAngularVelocity of a lift", [](Bench& b, double v) { lift(b).setAngularVelocity(v); }},
    {"Body.setPose", [](Bench& b, double v) { ball(b).setPose(Vec2(v, -v), 0); }},
    {"Body.setPose of a floor", [](Bench& b, double v) { floorOf(b).setPose(Vec2(v, -v), v); }},
    {"Body.setPose, angle", [](Bench& b, double v) { ball(b).setPose(Vec2(0, 4), v); }},
    {"Body.moveTo", [](Bench& b, double v) { lift(b).moveTo(Vec2(v, v), v, 1); }},
    {"Body.moveTo, dt", [](Bench& b, double v) { lift(b).moveTo(Vec2(1, 1), 1, v); }},
    {"Body.applyForce", [](Bench& b, double v) { ball(b).applyForce(Vec2(v, v)); }},
    {"Body.applyForce twice",
     [](Bench& b, double v) { ball(b).applyForce(Vec2(v, v)), ball(b).applyForce(Vec2(v, v)); }},
    {"Body.applyForce, at", [](Bench& b, double v) { ball(b).applyForce(Vec2(1, 2), Vec2(v, v)); }},
    {"Body.applyTorque", [](Bench& b, double v) { ball(b).applyTorque(v); }},
    {"Body.applyImpulse",
     [](Bench& b, double v) { ball(b).applyImpulse(Vec2(v, v)), ball(b).applyImpulse(Vec2(v, v)); }},
    {"Body.applyImpulse, at", [](Bench& b, double v) { ball(b).applyImpulse(Vec2(1, 2), Vec2(v, v)); }},
    {"Body.applyAngularImpulse",
     [](Bench& b, double v) { ball(b).applyAngularImpulse(v), ball(b).applyAngularImpulse(v); }},
    {"Body.setMass",
     [](Bench& b, double v) {
         ball(b).setMass(Mass{v, nowhere, v});
     }},
    {"Body.setMass, center",
     [](Bench& b, double v) {
         ball(b).setMass(Mass{1, Vec2(v, -v), 1});
     }},
    {"Body.setGravityScale", [](Bench& b, double v) { ball(b).setGravityScale(v); }},
    {"Body.setLinearDamping", [](Bench& b, double v) { ball(b).setLinearDamping(v); }},
    {"Body.setAngularDamping", [](Bench& b, double v) { ball(b).setAngularDamping(v); }},
    {"Joint.setMotorSpeed", runMotor},
    {"World.castRay",
     [](Bench& b, double v) { b.world.castRayAll(Vec2(v, 1), Vec2(-v, 1)), b.world.castRay(nowhere, Vec2(v, v)); }},
    {"World.castShape", castShapes},
    {"World.overlapBox", overlap},
    {"World.nearest", [](Bench& b, double v) { b.world.nearest(Vec2(v, v), infinity), b.world.nearest(nowhere, v); }},
};

}  // namespace

Covered coveredCalls() {
    Covered covered;
    for (const BadCall& call : allCalls()) covered[call.argument.function].push_back(call.argument.name);
    return covered;
}

TEST_CASE("each argument of a call is refused by name, value and wish when it is wrong", "[dynamics][errors]") {
    Bench bench;
    for (const BadCall& bad : allCalls()) {
        INFO(bad.argument.function << " " << bad.argument.name);
        CHECK(faultOf(
                  bench, [&] { bad.call(bench); }, bad.field, bad.complaint) == "");
    }
}

TEST_CASE("a world that has refused 400 calls goes on as one that was never asked", "[dynamics][errors]") {
    Bench asked, left;
    for (const BadCall& bad : allCalls()) CHECK(refusalOf([&] { bad.call(asked); }) != "");
    for (Bench* bench : {&asked, &left}) {
        CHECK(unsoundAfter(bench->world) == "");
        const BodyId added = bench->world.add({.position = {5, 5}, .shapes = {circle(0.5)}});
        bench->world.join(RevoluteJointDef{.bodyA = bench->ball, .bodyB = added, .anchor = {5, 5}});
        bench->world.add(bench->ball, circle(0.2));
        CHECK(unsoundAfter(bench->world) == "");
    }
    CHECK(stateOf(asked.world) == stateOf(left.world));
}

TEST_CASE("calls with numbers from 1e-320 to 1.7e308 are refused, or leave every body finite or quarantined",
          "[dynamics][errors]") {
    for (const ExtremeCall& extreme : extremeCalls) {
        for (const double size : extremes) {
            for (const double value : {size, -size}) {
                INFO(extreme.name << " " << value);
                Bench bench;
                if (refusalOf([&] { extreme.call(bench, value); }).empty()) CHECK(unsoundAfter(bench.world) == "");
            }
        }
    }
}

}  // namespace plumb::test
