// SPDX-License-Identifier: MIT
#include "kit/dynamics/bad_call.h"

#include <plumb/dynamics/joint_def.h>
#include <plumb/impact/impact.h>
#include <plumb/shapes/decompose.h>
#include <plumb/shapes/hull.h>

namespace plumb::test {

void BadCalls::one(const Argument& of, const std::string& complaint, std::function<void(Bench&)> call) {
    all.push_back({of, std::move(call), of.field.empty() ? of.function + ": " + of.name : of.field, complaint});
}

void BadCalls::numbers(const Argument& of, const BadNumbers& bads, const std::function<void(Bench&, double)>& call) {
    for (const auto& [value, text, complaint] : bads)
        one(of, text + " " + complaint, [call, v = value](Bench& b) { call(b, v); });
}

void BadCalls::vectors(const Argument& of, const BadNumbers& bads,
                       const std::function<void(Bench&, const Vec2&)>& call) {
    for (const auto& [value, text, complaint] : bads) {
        const Vec2 first(value, 1), second(1, value);
        one(of, "(" + text + ", 1) " + complaint, [=](Bench& b) { call(b, first); });
        one(of, "(1, " + text + ") " + complaint, [=](Bench& b) { call(b, second); });
    }
}

void BadCalls::vectors(const Argument& of, const std::function<void(Bench&, const Vec2&)>& call) {
    vectors(of, notFinite, call);
}

void BadCalls::poses(const std::string& function, const std::function<void(Bench&, const Transform&)>& call) {
    vectors({function, "pose", function + ": pose.position"}, [call](Bench& b, const Vec2& v) {
        call(b, Transform{v, {}});
    });
    for (const Rot& rotation : {Rot{nan, 0}, Rot{1, infinity}, Rot{0, 0}, Rot{1, 1}, Rot{2, 0}}) {
        const Transform pose{{0, 0}, rotation};
        const char* complaint = std::isfinite(rotation.cos + rotation.sin) ? "is not the cosine" : "(";
        one({function, "pose", function + ": pose.rotation"}, complaint, [=](Bench& b) { call(b, pose); });
    }
}

void BadCalls::shapes(const std::string& function, const std::function<void(Bench&, const Shape&)>& call) {
    const auto bad = [&](const Shape& shape, const std::string& member, const std::string& complaint) {
        one({function, "shape", function + ": shape." + member}, complaint, [=](Bench& b) { call(b, shape); });
    };
    bad(Circle{.radius = -1}, "radius", "-1 is not positive");
    bad(Capsule{{0, 0}, {1, 0}, nan}, "radius", "nan is not finite");
    bad(Polygon{{{0, 0}, {1, 0}}}, "vertices", "2 corners are fewer than 3");
    bad(Segment{{0, 0}, {0, 0}}, "end", "(0, 0) is the same point as start");
    bad(Chain{}, "points", "0 points are fewer than 2");
}

void BadCalls::bodyIds(const Argument& of, const std::function<void(Bench&, BodyId)>& call) {
    one(of, "names no body: it was never set", [=](Bench& b) { call(b, {}); });
    otherBodyIds(of, call);
}

void BadCalls::otherBodyIds(const Argument& of, const std::function<void(Bench&, BodyId)>& call) {
    one(of, "it was removed", [=](Bench& b) { call(b, b.gone); });
    one(of, "belongs to another world", [=](Bench& b) { call(b, b.foreign); });
    one(of, "{index 12345,", [=](Bench& b) { call(b, BodyId{12345, 0, b.ball.world}); });
}

void BadCalls::shapeIds(const Argument& of, const std::function<void(Bench&, ShapeId)>& call) {
    Argument part = of;
    part.field = of.field + ".body";
    bodyIds(part, [call](Bench& b, BodyId id) { call(b, ShapeId{id, 0}); });
    part.field = of.field + ".number";
    one(part, "2 ", [call](Bench& b) { call(b, b.goneShape); });
    one(part, "7 ", [call](Bench& b) { call(b, ShapeId{b.ball, 7}); });
}

void BadCalls::jointIds(const std::string& function, const std::function<void(Bench&, JointId)>& call) {
    const Argument of{function, "joint", "JointId"};
    one(of, "names no joint: it was never set", [=](Bench& b) { call(b, {}); });
    one(of, "it was removed", [=](Bench& b) { call(b, b.goneJoint); });
    one(of, "belongs to another world", [=](Bench& b) { call(b, b.foreignJoint); });
    one(of, "{index 999,", [=](Bench& b) { call(b, JointId{999, 0, b.ball.world}); });
}

namespace {

void addImpactCalls(BadCalls& c) {
    static const ImpactSide sound{.velocity = {0, -1}, .inverseMass = 1};
    static const Vec2 up{0, 1};
    const auto sides = [&](const std::string& member, const BadNumbers& bads, auto&& put) {
        c.numbers({"impact", "a", "ImpactSide a." + member}, bads,
                  [=](Bench&, double v) { impact(put(v), sound, up, {}); });
        c.numbers({"impact", "b", "ImpactSide b." + member}, bads,
                  [=](Bench&, double v) { impact(sound, put(v), up, {}); });
    };
    const auto spoilt = [](auto&& spoil) {
        ImpactSide side = sound;
        spoil(side);
        return side;
    };
    sides("inverseMass", negative, [=](double v) { return spoilt([v](ImpactSide& s) { s.inverseMass = v; }); });
    sides("inverseInertia", negative, [=](double v) { return spoilt([v](ImpactSide& s) { s.inverseInertia = v; }); });
    BadNumbers arms = notFinite;
    for (BadNumber& bad : arms) bad.text = "(" + bad.text + ", 0)";
    sides("arm", arms, [=](double v) { return spoilt([v](ImpactSide& s) { s.arm = Vec2(v, 0); }); });
    for (const Vec2& normal : {Vec2(0, 0), Vec2(1, 1), Vec2(0, 2), Vec2(0, infinity)})
        c.one({"impact", "normal"}, "is not a unit vector", [=](Bench&) { impact(sound, sound, normal, {}); });
    const auto law = [&](const std::string& member, const ImpactLaw& bad, const std::string& complaint) {
        c.one({"impact", "law", "ImpactLaw." + member}, complaint, [=](Bench&) { impact(sound, sound, up, bad); });
    };
    for (const double restitution : {-0.1, 1.1, nan, infinity}) law("restitution", {restitution, 0}, "is not");
    for (const double friction : {-1.0, -infinity, nan}) law("friction", {1, friction}, "is");
    law("surfaceSpeed", {.surfaceSpeed = nan}, "nan is not finite");
}

void addOutlineCalls(BadCalls& c) {
    const Vec2 unit{1, 1};
    const auto halfSizes = [&](const std::string& function, const std::function<void(Bench&, const Vec2&)>& call) {
        c.vectors({function, "halfSize", "box.halfSize"}, notPositive, call);
    };
    halfSizes("boxPolygon", [](Bench&, const Vec2& v) { boxPolygon(v); });
    halfSizes("box", [](Bench&, const Vec2& v) { box(v); });
    halfSizes("roundedBox", [](Bench&, const Vec2& v) { roundedBox(v, 1); });
    c.vectors({"boxPolygon", "center", "box.center"}, [=](Bench&, const Vec2& v) { boxPolygon(unit, v); });
    const std::vector<Vec2> corners{{0, 0}, {2, 0}, {nan, 2}}, line{{0, 0}, {1, 0}, {2, 0}};
    const std::string third = "(nan, 2) is not finite", pieces = "convexPieces.outline", few = "fewer than 3";
    c.one({"hullOf", "points", "hullOf.points[2]"}, third, [=](Bench&) { hullOf(corners); });
    c.one({"hullOf", "points", "hullOf.points"}, few, [=](Bench&) { hullOf(line); });
    c.one({pieces.substr(0, 12), "outline", pieces + "[2]"}, third, [=](Bench&) { convexPieces(corners); });
    c.one({pieces.substr(0, 12), "outline", pieces + "[0]"}, "(0, 0) folds", [=](Bench&) { convexPieces(line); });
    c.one({"outline", "points", pieces + "[2]"}, third, [=](Bench&) { (void)outline(corners); });
    c.one({"outline", "points", pieces}, "0 points are " + few, [](Bench&) { (void)outline({}); });
}

void addMassCalls(BadCalls& c) {
    c.numbers({"massOf", "density"}, negative, [](Bench&, double v) { massOf(Circle{}, v); });
    c.shapes("massOf", [](Bench&, const Shape& s) { massOf(s, 1); });
    const auto combined = [&](const Mass& bad, const std::string& member, const std::string& complaint) {
        const std::vector<Mass> parts{{}, bad};
        c.one({"combine", "parts", "combine: parts[1]." + member}, complaint, [=](Bench&) { combine(parts); });
    };
    for (const double bad : {nan, -1.0, infinity}) {
        combined({bad, {0, 0}, 1}, "mass", "is");
        combined({1, {0, 0}, bad}, "inertia", "is");
    }
    combined({1, {nan, 0}, 1}, "center", "(nan, 0) is not finite");
}

}  // namespace

void addCallsWithoutWorld(BadCalls& c) {
    addImpactCalls(c);
    c.numbers({"springOf", "frequency"}, negative, [](Bench&, double v) { springOf(v, 1, 1); });
    c.numbers({"springOf", "dampingRatio"}, negative, [](Bench&, double v) { springOf(1, v, 1); });
    c.numbers({"springOf", "mass"}, negative, [](Bench&, double v) { springOf(1, 1, v); });
    c.one({"springOf", "frequency"}, "1e+200", [](Bench&) { springOf(1e200, 1, 1); });
    c.one({"springOf", "mass", "springOf: frequency"}, "10", [](Bench&) { springOf(10, 1e200, 1e200); });
    addOutlineCalls(c);
    addMassCalls(c);
}

}  // namespace plumb::test
