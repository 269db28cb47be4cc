// SPDX-License-Identifier: MIT
#include <plumb/dynamics/joint_def.h>
#include <plumb/impact/impact.h>
#include <plumb/shapes/decompose.h>
#include <plumb/shapes/hull.h>
#include "catch.h"
#include "kit/dynamics/bad_input.h"

namespace plumb::test {

namespace {

using Call = std::function<void(Bench&)>;

/// A call with a wrong argument, and what is then said.
struct BadCall {
    std::string function, argument;
    Call call;
    std::string field, complaint;
};
using BadCalls = std::vector<BadCall>;

void add(BadCalls& calls, const BadCalls& more) {
    calls.insert(calls.end(), more.begin(), more.end());
}

/// A number, each way that it can be wrong.
BadCalls numbers(const std::string& function, const std::string& argument, const BadNumbers& bads,
                 const std::function<void(Bench&, double)>& call) {
    BadCalls calls;
    for (const BadNumber& bad : bads)
        calls.push_back({function, argument, [call, value = bad.value](Bench& b) { call(b, value); },
                         function + ": " + argument, bad.text + " " + bad.complaint});
    return calls;
}

/// A vector, each coordinate.
BadCalls vectors(const std::string& function, const std::string& argument,
                 const std::function<void(Bench&, const Vec2&)>& call, const BadNumbers& bads = notFinite) {
    BadCalls calls;
    for (const BadNumber& bad : bads) {
        const Vec2 first(bad.value, 1), second(1, bad.value);
        const std::string field = function + ": " + argument;
        calls.push_back({function, argument, [call, first](Bench& b) { call(b, first); }, field,
                         "(" + bad.text + ", 1) " + bad.complaint});
        calls.push_back({function, argument, [call, second](Bench& b) { call(b, second); }, field,
                         "(1, " + bad.text + ") " + bad.complaint});
    }
    return calls;
}

/// All that can be wrong with a pose, but for what makes no direction.
BadCalls poses(const std::string& function, const std::function<void(Bench&, const Transform&)>& call) {
    BadCalls calls = vectors(function, "pose", [call](Bench& b, const Vec2& v) { call(b, {v, {}}); });
    for (BadCall& bad : calls) bad.field += ".position";
    for (const Rot& rotation : {Rot{nan, 0}, Rot{1, infinity}, Rot{0, 0}, Rot{1, 1}, Rot{2, 0}})
        calls.push_back({function, "pose",
                         [call, rotation](Bench& b) {
                             call(b, {{0, 0}, rotation});
                         },
                         function + ": pose.rotation", "("});
    return calls;
}

BadCalls shapes(const std::string& function, const std::function<void(Bench&, const Shape&)>& call) {
    const auto bad = [&](const Shape& shape, const std::string& member, const std::string& complaint) {
        return BadCall{function, "shape", [call, shape](Bench& b) { call(b, shape); }, function + ": shape." + member,
                       complaint};
    };
    return {bad(Circle{.radius = -1}, "radius", "-1 is not positive"),
            bad(Capsule{{0, 0}, {1, 0}, nan}, "radius", "nan is not finite"),
            bad(Polygon{{{0, 0}, {1, 0}}}, "vertices", "2 corners are fewer than 3"),
            bad(Segment{{0, 0}, {0, 0}}, "end", "(0, 0) is the same point as start"),
            bad(Chain{}, "points", "0 points are fewer than 2")};
}

template <class Id>
using IdCall = std::function<void(Bench&, const Id&)>;

BadCalls bodyIds(const std::string& function, const std::string& argument, const std::string& field,
                 const IdCall<BodyId>& call) {
    return {{function, argument, [call](Bench& b) { call(b, {}); }, field, "names no body: it was never set"},
            {function, argument, [call](Bench& b) { call(b, b.gone); }, field, "it was removed"},
            {function, argument, [call](Bench& b) { call(b, b.foreign); }, field, "belongs to another world"},
            {function, argument,
             [call](Bench& b) {
                 call(b, {12345, 0, b.ball.world});
             },
             field, "{index 12345,"}};
}
BadCalls shapeIds(const std::string& function, const std::string& argument, const std::string& field,
                  const IdCall<ShapeId>& call) {
    BadCalls calls = bodyIds(function, argument, field + ".body", [call](Bench& b, const BodyId& id) {
        call(b, ShapeId{id, 0});
    });
    add(calls, {{function, argument, [call](Bench& b) { call(b, b.goneShape); }, field + ".number", "2 "},
                {function, argument,
                 [call](Bench& b) {
                     call(b, {b.ball, 7});
                 },
                 field + ".number", "7 "}});
    return calls;
}
BadCalls jointIds(const std::string& function, const std::string& argument, const IdCall<JointId>& call) {
    return {{function, argument, [call](Bench& b) { call(b, {}); }, "JointId", "names no joint: it was never set"},
            {function, argument, [call](Bench& b) { call(b, b.goneJoint); }, "JointId", "it was removed"},
            {function, argument, [call](Bench& b) { call(b, b.foreignJoint); }, "JointId", "belongs to another world"},
            {function, argument,
             [call](Bench& b) {
                 call(b, {999, 0, b.ball.world});
             },
             "JointId", "{index 999,"}};
}

BadCalls worldCalls() {
    BadCalls c;
    add(c, numbers("World.step", "dt", negative, [](Bench& b, double v) { b.world.step(v); }));
    add(c, vectors("World.setGravity", "gravity", [](Bench& b, const Vec2& v) { b.world.setGravity(v); }));
    add(c, bodyIds("World.add", "body", "BodyId", [](Bench& b, BodyId id) { b.world.add(id, circle(1)); }));
    add(c, bodyIds("World.remove", "body", "BodyId", [](Bench& b, BodyId id) { b.world.remove(id); }));
    add(c, shapeIds("World.remove", "shape", "ShapeId", [](Bench& b, ShapeId id) { b.world.remove(id); }));
    add(c, jointIds("World.remove", "joint", [](Bench& b, JointId id) { b.world.remove(id); }));
    add(c, bodyIds("World.body", "body", "BodyId", [](Bench& b, BodyId id) { b.world.body(id); }));
    add(c, bodyIds("World.body", "body", "BodyId", [](Bench& b, BodyId id) { std::as_const(b.world).body(id); }));
    add(c, jointIds("World.joint", "joint", [](Bench& b, JointId id) { b.world.joint(id); }));
    add(c, jointIds("World.joint", "joint", [](Bench& b, JointId id) { std::as_const(b.world).joint(id); }));
    add(c, shapeIds("World.shape", "shape", "ShapeId", [](Bench& b, ShapeId id) { b.world.shape(id); }));
    add(c, shapeIds("World.shape", "shape", "ShapeId", [](Bench& b, ShapeId id) { std::as_const(b.world).shape(id); }));
    add(c, shapeIds("World.tiles", "shape", "World.tiles: ShapeId", [](Bench& b, ShapeId id) { b.world.tiles(id); }));
    add(c, shapeIds("World.setTile", "shape", "World.setTile: ShapeId", [](Bench& b, ShapeId id) {
            b.world.setTile(id, {0, 0}, {});
        }));
    const std::size_t tooMany = ~std::size_t{0};
    const std::string text = std::to_string(tooMany) + " is more than";
    add(c, {{"World.reserve", "capacity", [=](Bench& b) { b.world.reserve({.bodies = tooMany}); }, "Capacity.bodies",
             text},
            {"World.reserve", "capacity", [=](Bench& b) { b.world.reserve({.shapes = tooMany}); }, "Capacity.shapes",
             text},
            {"World.reserve", "capacity", [=](Bench& b) { b.world.reserve({.contacts = tooMany}); },
             "Capacity.contacts", text},
            {"World.reserve", "capacity", [=](Bench& b) { b.world.reserve({.joints = tooMany}); }, "Capacity.joints",
             text}});
    return c;
}

/// Of the body that a cast ignores, one that was never set stands for none.
template <class Call>
BadCalls ignoredBodies(const std::string& query, Call call) {
    BadCalls calls = bodyIds(query, "ignored", query + ": ignored", call);
    calls.erase(calls.begin());
    return calls;
}

BadCalls queryCalls() {
    BadCalls c;
    const Circle disc{.radius = 1};
    for (const bool all : {false, true}) {
        const std::string ray = all ? "World.castRayAll" : "World.castRay";
        const std::string shape = all ? "World.castShapeAll" : "World.castShape";
        const auto castRay = [all](Bench& b, const Vec2& from, const Vec2& to) {
            all ? void(b.world.castRayAll(from, to)) : void(b.world.castRay(from, to));
        };
        const auto castShape = [all](Bench& b, const Shape& s, const Transform& pose, const Vec2& shift) {
            all ? void(b.world.castShapeAll(s, pose, shift)) : void(b.world.castShape(s, pose, shift));
        };
        add(c, vectors(ray, "from", [=](Bench& b, const Vec2& v) { castRay(b, v, {0, 0}); }));
        add(c, vectors(ray, "to", [=](Bench& b, const Vec2& v) { castRay(b, {0, 0}, v); }));
        add(c, shapes(shape, [=](Bench& b, const Shape& s) { castShape(b, s, {}, {1, 0}); }));
        add(c, poses(shape, [=](Bench& b, const Transform& t) { castShape(b, disc, t, {1, 0}); }));
        add(c, vectors(shape, "shift", [=](Bench& b, const Vec2& v) { castShape(b, disc, {}, v); }));
    }
    const char* pieces = "World.castShapePieces";
    add(c, shapes(pieces, [](Bench& b, const Shape& s) { b.world.castShapePieces(s, {}, {1, 0}); }));
    add(c, poses(pieces, [=](Bench& b, const Transform& t) { b.world.castShapePieces(disc, t, {1, 0}); }));
    add(c, vectors(pieces, "shift", [=](Bench& b, const Vec2& v) { b.world.castShapePieces(disc, {}, v); }));
    add(c, ignoredBodies("World.castRay", [](Bench& b, BodyId id) { b.world.castRay({0, 0}, {1, 0}, {}, id); }));
    add(c, ignoredBodies("World.castRayAll", [](Bench& b, BodyId id) { b.world.castRayAll({0, 0}, {1, 0}, {}, id); }));
    add(c, ignoredBodies("World.castShape", [=](Bench& b, BodyId id) { b.world.castShape(disc, {}, {1, 0}, {}, id); }));
    add(c, ignoredBodies("World.castShapeAll", [=](Bench& b, BodyId id) {
            b.world.castShapeAll(disc, {}, {1, 0}, {}, id);
        }));
    add(c, ignoredBodies(pieces, [=](Bench& b, BodyId id) { b.world.castShapePieces(disc, {}, {1, 0}, {}, id); }));
    add(c, shapes("World.overlapShape", [](Bench& b, const Shape& s) { b.world.overlapShape(s, {}); }));
    add(c, poses("World.overlapShape", [=](Bench& b, const Transform& t) { b.world.overlapShape(disc, t); }));
    add(c, vectors("World.overlapPoint", "point", [](Bench& b, const Vec2& v) { b.world.overlapPoint(v); }));
    add(c, vectors("World.nearest", "point", [](Bench& b, const Vec2& v) { b.world.nearest(v, 1); }));
    add(c, {{"World.nearest", "within",
             [](Bench& b) {
                 b.world.nearest({0, 0}, nan);
             },
             "World.nearest: within", "nan is"},
            {"World.nearest", "within",
             [](Bench& b) {
                 b.world.nearest({0, 0}, -1);
             },
             "World.nearest: within", "-1 is"}});
    BadCalls boxes = vectors("World.overlapBox", "box", [](Bench& b, const Vec2& v) {
        b.world.overlapBox({v, {2, 2}});
    });
    for (BadCall& bad : boxes) bad.field += ".lower";
    add(c, boxes);
    boxes = vectors("World.overlapBox", "box", [](Bench& b, const Vec2& v) { b.world.overlapBox({{0, 0}, v}); });
    for (BadCall& bad : boxes) bad.field += ".upper";
    add(c, boxes);
    add(c, {{"World.overlapBox", "box",
             [](Bench& b) {
                 b.world.overlapBox({{2, 0}, {1, 1}});
             },
             "World.overlapBox: box.upper", "(1, 1) is below box.lower (2, 0)"},
            {"World.overlapBox", "box",
             [](Bench& b) {
                 b.world.overlapBox({{0, 2}, {1, 1}});
             },
             "World.overlapBox: box.upper", "(1, 1) is below box.lower (0, 2)"}});
    add(c, shapeIds("World.distance", "a", "World.distance: a",
                    [](Bench& b, ShapeId id) { (void)b.world.distance(id, b.liftShape); }));
    add(c, shapeIds("World.distance", "b", "World.distance: b",
                    [](Bench& b, ShapeId id) { (void)b.world.distance(b.liftShape, id); }));
    return c;
}

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

BadCalls bodyCalls() {
    BadCalls c;
    add(c, vectors("BodyView.velocityAt", "point", [](Bench& b, const Vec2& v) { (void)ball(b).velocityAt(v); }));
    add(c, vectors("Body.setVelocity", "velocity", [](Bench& b, const Vec2& v) { ball(b).setVelocity(v); }));
    add(c, numbers("Body.setAngularVelocity", "angularVelocity", notFinite,
                   [](Bench& b, double v) { ball(b).setAngularVelocity(v); }));
    add(c, vectors("Body.setPose", "position", [](Bench& b, const Vec2& v) { ball(b).setPose(v, 0); }));
    add(c, numbers("Body.setPose", "angle", notFinite, [](Bench& b, double v) { ball(b).setPose({0, 4}, v); }));
    add(c, vectors("Body.moveTo", "position", [](Bench& b, const Vec2& v) { lift(b).moveTo(v, 0, 1); }));
    add(c, numbers("Body.moveTo", "angle", notFinite, [](Bench& b, double v) { lift(b).moveTo({0, 0}, v, 1); }));
    add(c, numbers("Body.moveTo", "dt", notPositive, [](Bench& b, double v) { lift(b).moveTo({0, 0}, 0, v); }));
    add(c, vectors("Body.applyForce", "force", [](Bench& b, const Vec2& v) { ball(b).applyForce(v); }));
    add(c, vectors("Body.applyForce", "force", [](Bench& b, const Vec2& v) { ball(b).applyForce(v, {0, 0}); }));
    add(c, vectors("Body.applyForce", "at", [](Bench& b, const Vec2& v) { ball(b).applyForce({1, 0}, v); }));
    add(c, numbers("Body.applyTorque", "torque", notFinite, [](Bench& b, double v) { ball(b).applyTorque(v); }));
    add(c, vectors("Body.applyImpulse", "impulse", [](Bench& b, const Vec2& v) { ball(b).applyImpulse(v); }));
    add(c, vectors("Body.applyImpulse", "impulse", [](Bench& b, const Vec2& v) { ball(b).applyImpulse(v, {0, 0}); }));
    add(c, vectors("Body.applyImpulse", "at", [](Bench& b, const Vec2& v) { ball(b).applyImpulse({1, 0}, v); }));
    add(c, numbers("Body.applyAngularImpulse", "impulse", notFinite,
                   [](Bench& b, double v) { ball(b).applyAngularImpulse(v); }));
    add(c, numbers("Body.setGravityScale", "scale", notFinite, [](Bench& b, double v) { ball(b).setGravityScale(v); }));
    add(c,
        numbers("Body.setLinearDamping", "damping", negative, [](Bench& b, double v) { ball(b).setLinearDamping(v); }));
    add(c, numbers("Body.setAngularDamping", "damping", negative,
                   [](Bench& b, double v) { ball(b).setAngularDamping(v); }));
    const std::string type = "Body.setType: type", none = "is none of Static, Kinematic and Dynamic";
    const std::string mass = "Body.setMass: mass";
    add(c, {{"Body.setType", "type", [](Bench& b) { ball(b).setType(static_cast<BodyType>(3)); }, type, "3 " + none},
            {"Body.setType", "type", [](Bench& b) { lift(b).setType(static_cast<BodyType>(-1)); }, type, "-1 " + none},
            {"Body.setMass", "mass",
             [](Bench& b) {
                 ball(b).setMass({0, {0, 0}, 1});
             },
             mass + ".mass", "0 is not"},
            {"Body.setMass", "mass",
             [](Bench& b) {
                 ball(b).setMass({nan, {0, 0}, 1});
             },
             mass + ".mass", "nan is not"},
            {"Body.setMass", "mass",
             [](Bench& b) {
                 ball(b).setMass({1, {nan, 0}, 1});
             },
             mass + ".center", "(nan, 0)"},
            {"Body.setMass", "mass",
             [](Bench& b) {
                 ball(b).setMass({1, {0, 0}, -1});
             },
             mass + ".inertia", "-1 is not"},
            {"Body.setMass", "mass",
             [](Bench& b) {
                 floorOf(b).setMass({1, {0, 0}, 1});
             },
             "Body.setMass", "static"},
            {"Body.setMassFromShapes", "", [](Bench& b) { lift(b).setMassFromShapes(); }, "Body.setMassFromShapes",
             "kinematic"},
            {"Body.setVelocity", "velocity",
             [](Bench& b) {
                 floorOf(b).setVelocity({1, 2});
             },
             "Body.setVelocity: velocity", "(1, 2)"},
            {"Body.setAngularVelocity", "angularVelocity", [](Bench& b) { floorOf(b).setAngularVelocity(3); },
             "Body.setAngularVelocity: angularVelocity", "3"},
            {"Body.moveTo", "position",
             [](Bench& b) {
                 ball(b).moveTo({0, 0}, 0, 1);
             },
             "Body.moveTo", "dynamic"},
            {"Body.moveTo", "position",
             [](Bench& b) {
                 lift(b).moveTo({1e308, 0}, 0, 1e-9);
             },
             "Body.moveTo: position, for the velocity it takes", "(inf, "},
            {"Body.moveTo", "angle",
             [](Bench& b) {
                 lift(b).moveTo({0, 0}, 1e308, 1e-9);
             },
             "Body.moveTo: angle, for the angular velocity it takes", "inf is"},
            {"Body.applyImpulse", "impulse",
             [](Bench& b) {
                 crate(b).applyImpulse({1e308, 0}, {0, 1e3});
             },
             "Body.applyImpulse: impulse, for the angular velocity it would give", "inf is"},
            {"Body.applyAngularImpulse", "impulse", [](Bench& b) { crate(b).applyAngularImpulse(1.7e308); },
             "Body.applyAngularImpulse: impulse, for the angular velocity it would give", "inf is"}});
    return c;
}

/// A speed is refused by the name of the def's field.
BadCalls jointCalls() {
    BadCalls c;
    const BadNumbers beyond{{1e16, "1e+16", "is beyond 1e+15"}, {-1e16, "-1e+16", "is beyond 1e+15"}};
    const auto speeds = [&](const std::string& kind, JointId Bench::*joint) {
        BadCalls some = numbers("Joint.setMotorSpeed", "speed", joined(notFinite, beyond),
                                [=](Bench& b, double v) { b.world.joint(b.*joint).setMotorSpeed(v); });
        for (BadCall& bad : some) bad.field = kind + ".motorSpeed";
        add(c, some);
    };
    speeds("RevoluteJointDef", &Bench::hinge);
    speeds("PrismaticJointDef", &Bench::slide);
    speeds("DistanceJointDef", &Bench::rod);
    return c;
}

const ImpactSide soundSide{.velocity = {0, -1}, .inverseMass = 1};

BadCalls impactCalls() {
    BadCalls c;
    const auto sides = [&](const std::string& member, const BadNumbers& bads, double ImpactSide::*at) {
        for (const BadNumber& bad : bads) {
            ImpactSide spoilt = soundSide;
            spoilt.*at = bad.value;
            const std::string text = bad.text + " " + bad.complaint;
            add(c, {{"impact", "a",
                     [=](Bench&) {
                         impact(spoilt, soundSide, {0, 1}, {});
                     },
                     "ImpactSide a." + member, text},
                    {"impact", "b",
                     [=](Bench&) {
                         impact(soundSide, spoilt, {0, 1}, {});
                     },
                     "ImpactSide b." + member, text}});
        }
    };
    sides("inverseMass", negative, &ImpactSide::inverseMass);
    sides("inverseInertia", negative, &ImpactSide::inverseInertia);
    for (const BadNumber& bad : notFinite) {
        ImpactSide spoilt = soundSide;
        spoilt.arm = {bad.value, 0};
        const std::string text = "(" + bad.text + ", 0) " + bad.complaint;
        add(c, {{"impact", "a",
                 [=](Bench&) {
                     impact(spoilt, soundSide, {0, 1}, {});
                 },
                 "ImpactSide a.arm", text},
                {"impact", "b",
                 [=](Bench&) {
                     impact(soundSide, spoilt, {0, 1}, {});
                 },
                 "ImpactSide b.arm", text}});
    }
    for (const Vec2& normal : {Vec2(0, 0), Vec2(1, 1), Vec2(0, 2), Vec2(0, infinity)})
        c.push_back({"impact", "normal", [=](Bench&) { impact(soundSide, soundSide, normal, {}); }, "impact: normal",
                     "is not a unit vector"});
    for (const double restitution : {-0.1, 1.1, nan, infinity})
        c.push_back({"impact", "law",
                     [=](Bench&) {
                         impact(soundSide, soundSide, {0, 1}, {restitution, 0});
                     },
                     "ImpactLaw.restitution", "is not"});
    for (const double friction : {-1.0, -infinity, nan})
        c.push_back({"impact", "law",
                     [=](Bench&) {
                         impact(soundSide, soundSide, {0, 1}, {1, friction});
                     },
                     "ImpactLaw.friction", "is"});
    return c;
}

BadCalls functionCalls() {
    BadCalls c;
    const auto springs = [&](const std::string& argument, auto&& of) {
        add(c, numbers("springOf", argument, negative, [of](Bench&, double v) { of(v); }));
    };
    springs("frequency", [](double v) { springOf(v, 1, 1); });
    springs("dampingRatio", [](double v) { springOf(1, v, 1); });
    springs("mass", [](double v) { springOf(1, 1, v); });
    add(c, {{"springOf", "frequency", [](Bench&) { springOf(1e200, 1, 1); }, "springOf: frequency", "1e+200"},
            {"springOf", "mass", [](Bench&) { springOf(10, 1e200, 1e200); }, "springOf: frequency", "10"}});
    for (BadCall& bad : vectors(
             "boxPolygon", "halfSize", [](Bench&, const Vec2& v) { boxPolygon(v); }, notPositive)) {
        bad.field = "box.halfSize";
        c.push_back(bad);
    }
    for (BadCall& bad : vectors("boxPolygon", "center", [](Bench&, const Vec2& v) { boxPolygon({1, 1}, v); })) {
        bad.field = "box.center";
        c.push_back(bad);
    }
    for (BadCall& bad : vectors(
             "box", "halfSize", [](Bench&, const Vec2& v) { box(v); }, notPositive)) {
        bad.field = "box.halfSize";
        c.push_back(bad);
    }
    for (BadCall& bad : vectors(
             "roundedBox", "halfSize", [](Bench&, const Vec2& v) { roundedBox(v, 1); }, notPositive)) {
        bad.field = "box.halfSize";
        c.push_back(bad);
    }
    const std::vector<Vec2> corners{{0, 0}, {2, 0}, {nan, 2}}, line{{0, 0}, {1, 0}, {2, 0}};
    add(c, {{"hullOf", "points", [=](Bench&) { hullOf(corners); }, "hullOf.points[2]", "(nan, 2) is not finite"},
            {"hullOf", "points", [=](Bench&) { hullOf(line); }, "hullOf.points", "fewer than 3"},
            {"convexPieces", "outline", [=](Bench&) { convexPieces(corners); }, "convexPieces.outline[2]",
             "(nan, 2) is not finite"},
            {"convexPieces", "outline", [=](Bench&) { convexPieces(line); }, "convexPieces.outline[0]", "(0, 0) folds"},
            {"outline", "points", [=](Bench&) { (void)outline(corners); }, "convexPieces.outline[2]",
             "(nan, 2) is not finite"},
            {"outline", "points", [](Bench&) { (void)outline({}); }, "convexPieces.outline",
             "0 points are fewer than 3"}});
    add(c, numbers("massOf", "density", negative, [](Bench&, double v) { massOf(Circle{}, v); }));
    add(c, shapes("massOf", [](Bench&, const Shape& s) { massOf(s, 1); }));
    for (const Mass& bad : {Mass{nan, {0, 0}, 1}, Mass{-1, {0, 0}, 1}, Mass{infinity, {0, 0}, 1}})
        c.push_back({"combine", "parts",
                     [=](Bench&) {
                         combine(std::vector<Mass>{{}, bad});
                     },
                     "combine: parts[1].mass", "is"});
    for (const Mass& bad : {Mass{1, {0, 0}, nan}, Mass{1, {0, 0}, -1}, Mass{1, {0, 0}, infinity}})
        c.push_back({"combine", "parts",
                     [=](Bench&) {
                         combine(std::vector<Mass>{{}, bad});
                     },
                     "combine: parts[1].inertia", "is"});
    c.push_back({"combine", "parts",
                 [](Bench&) {
                     combine(std::vector<Mass>{{1, {nan, 0}, 1}});
                 },
                 "combine: parts[0].center", "(nan, 0) is not finite"});
    return c;
}

BadCalls allCalls() {
    BadCalls all;
    for (const BadCalls& some : {worldCalls(), queryCalls(), bodyCalls(), jointCalls(), impactCalls(), functionCalls()})
        add(all, some);
    return all;
}

/// A call with numbers of any size, of which none may leave a body that is neither finite nor in quarantine.
struct ExtremeCall {
    const char* name;
    std::function<void(Bench&, double)> call;
};

const std::vector<ExtremeCall> extremeCalls{
    {"World.setGravity",
     [](Bench& b, double v) {
         b.world.setGravity({v, -v});
     }},
    {"World.step", [](Bench& b, double v) { b.world.step(v); }},
    {"Body.setVelocity",
     [](Bench& b, double v) {
         ball(b).setVelocity({v, -v});
     }},
    {"Body.setVelocity of a lift",
     [](Bench& b, double v) {
         lift(b).setVelocity({-v, v});
     }},
    {"Body.setAngularVelocity", [](Bench& b, double v) { ball(b).setAngularVelocity(v); }},
    {"Body.setAngularVelocity of a lift", [](Bench& b, double v) { lift(b).setAngularVelocity(v); }},
    {"Body.setPose",
     [](Bench& b, double v) {
         ball(b).setPose({v, -v}, 0);
     }},
    {"Body.setPose of a floor",
     [](Bench& b, double v) {
         floorOf(b).setPose({v, -v}, v);
     }},
    {"Body.setPose, angle",
     [](Bench& b, double v) {
         ball(b).setPose({0, 4}, v);
     }},
    {"Body.moveTo",
     [](Bench& b, double v) {
         lift(b).moveTo({v, v}, v, 1);
     }},
    {"Body.moveTo, dt",
     [](Bench& b, double v) {
         lift(b).moveTo({1, 1}, 1, v);
     }},
    {"Body.applyForce",
     [](Bench& b, double v) {
         ball(b).applyForce({v, v});
     }},
    {"Body.applyForce twice",
     [](Bench& b, double v) {
         ball(b).applyForce({v, v}), ball(b).applyForce({v, v});
     }},
    {"Body.applyForce, at",
     [](Bench& b, double v) {
         ball(b).applyForce({1, 2}, {v, v});
     }},
    {"Body.applyTorque", [](Bench& b, double v) { ball(b).applyTorque(v); }},
    {"Body.applyImpulse",
     [](Bench& b, double v) {
         ball(b).applyImpulse({v, v}), ball(b).applyImpulse({v, v});
     }},
    {"Body.applyImpulse, at",
     [](Bench& b, double v) {
         ball(b).applyImpulse({1, 2}, {v, v});
     }},
    {"Body.applyAngularImpulse",
     [](Bench& b, double v) { ball(b).applyAngularImpulse(v), ball(b).applyAngularImpulse(v); }},
    {"Body.setMass",
     [](Bench& b, double v) {
         ball(b).setMass({v, {0, 0}, v});
     }},
    {"Body.setMass, center",
     [](Bench& b, double v) {
         ball(b).setMass({1, {v, -v}, 1});
     }},
    {"Body.setGravityScale", [](Bench& b, double v) { ball(b).setGravityScale(v); }},
    {"Body.setLinearDamping", [](Bench& b, double v) { ball(b).setLinearDamping(v); }},
    {"Body.setAngularDamping", [](Bench& b, double v) { ball(b).setAngularDamping(v); }},
    {"Joint.setMotorSpeed",
     [](Bench& b, double v) {
         auto def = std::get<RevoluteJointDef>(b.world.joint(b.hinge).def());
         def.maxMotorTorque = 1;
         b.world.joint(b.hinge).set(def), b.world.joint(b.hinge).setMotorSpeed(v);
     }},
    {"World.castRay",
     [](Bench& b, double v) {
         b.world.castRayAll({v, 1}, {-v, 1}), b.world.castRay({0, 0}, {v, v});
     }},
    {"World.castShape",
     [](Bench& b, double v) {
         b.world.castShapeAll(Circle{.radius = std::fabs(v)}, {}, {1, 0});
         b.world.castShape(Circle{}, {{v, v}, {}}, {-v, -v});
     }},
    {"World.overlapBox",
     [](Bench& b, double v) {
         b.world.overlapBox({{-std::fabs(v), -1}, {std::fabs(v), 1}});
         b.world.overlapPoint({v, v});
         b.world.overlapShape(Circle{.radius = std::fabs(v)}, {{v, v}, {}});
     }},
    {"World.nearest",
     [](Bench& b, double v) {
         b.world.nearest({v, v}, infinity), b.world.nearest({0, 0}, v);
     }},
};

}  // namespace

Covered coveredCalls() {
    Covered covered;
    for (const BadCall& call : allCalls()) covered[call.function].push_back(call.argument);
    return covered;
}

TEST_CASE("each argument of a call is refused by name, value and wish when it is wrong", "[dynamics][errors]") {
    Bench bench;
    for (const BadCall& bad : allCalls()) {
        INFO(bad.function << " " << bad.argument);
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
