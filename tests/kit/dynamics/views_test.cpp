// SPDX-License-Identifier: MIT
// Are bodies, shapes, joints and fields read and changed in one way, and only where the world may be changed?
#include <concepts>
#include <utility>

#include <plumb/plumb.h>

#include "catch.h"

using namespace plumb;
using namespace plumb::test;

namespace {

template <class T>
concept CanSet = requires(T view) {
    view.set(view.def());
};
template <class T>
concept CanBeTagged = requires(T view) {
    view.setTag(1);
};
template <class T>
concept CanBePushed = requires(T view) {
    view.setVelocity({1, 0}), view.applyImpulse({1, 0}), view.wake();
};

auto viewOf(auto& world, BodyId id) {
    return world.body(id);
}
auto viewOf(auto& world, ShapeId id) {
    return world.shape(id);
}
auto viewOf(auto& world, JointId id) {
    return world.joint(id);
}
auto viewOf(auto& world, FieldId id) {
    return world.field(id);
}

template <class Id>
concept NamesView = requires(World& world, const World& still, Id id) {
    { world.contains(id) } -> std::same_as<bool>;
    { viewOf(world, id).id() } -> std::same_as<Id>;
    { viewOf(still, id).id() } -> std::same_as<Id>;
    world.remove(id);
};

template <class Id>
using View = decltype(viewOf(std::declval<World&>(), Id{}));
template <class Id>
using ConstView = decltype(viewOf(std::declval<const World&>(), Id{}));

/// A crate on a rope, in wind.
struct Crate {
    World world{{.gravity = {0, -10}}};
    BodyId wall = world.add({.type = BodyType::Static, .shapes = {box({0.1, 0.1})}});
    BodyId lift = world.add({.type = BodyType::Kinematic, .position = {9, 0}, .shapes = {box({1, 0.1})}});
    BodyId crate = world.add({.position = {0, -2}, .shapes = {box({0.5, 0.5}), circle(0.2)}});
    JointId rope = world.join(RevoluteJointDef{.bodyA = wall, .bodyB = crate});
    FieldId wind = world.addField({.law = Drag{.linear = 1}});
};

}  // namespace

TEST_CASE("what has an id has a view that tells the id, and a world that is const gives one that cannot write",
          "[dynamics][editing]") {
    STATIC_REQUIRE((NamesView<BodyId> && NamesView<ShapeId> && NamesView<JointId> && NamesView<FieldId>));
    STATIC_REQUIRE((CanBePushed<View<BodyId>> && CanBeTagged<View<BodyId>>));
    STATIC_REQUIRE((CanSet<View<ShapeId>> && CanBeTagged<View<ShapeId>>));
    STATIC_REQUIRE((CanSet<View<JointId>> && CanSet<View<FieldId>>));
    STATIC_REQUIRE_FALSE((CanBePushed<ConstView<BodyId>> || CanBeTagged<ConstView<BodyId>>));
    STATIC_REQUIRE_FALSE((CanSet<ConstView<ShapeId>> || CanBeTagged<ConstView<ShapeId>>));
    STATIC_REQUIRE_FALSE((CanSet<ConstView<JointId>> || CanSet<ConstView<FieldId>>));
    STATIC_REQUIRE_FALSE((std::convertible_to<ConstView<BodyId>, View<BodyId>> ||
                          std::convertible_to<ConstView<ShapeId>, View<ShapeId>> ||
                          std::convertible_to<ConstView<JointId>, View<JointId>> ||
                          std::convertible_to<ConstView<FieldId>, View<FieldId>>));
}

TEST_CASE("shapes, joints and fields are listed and read through their views", "[dynamics][editing]") {
    Crate c;
    CHECK(c.world.shapes() == std::vector<ShapeId>{{c.wall, 0}, {c.lift, 0}, {c.crate, 0}, {c.crate, 1}});
    for (const ShapeId shape : c.world.shapes()) CHECK(c.world.shape(shape).id() == shape);
    for (const JointId joint : c.world.joints()) CHECK(c.world.joint(joint).id() == joint);
    for (const FieldId field : c.world.fields()) CHECK(c.world.field(field).id() == field);
    CHECK(c.world.shape({c.crate, 1}).body() == c.crate);
    c.world.remove(ShapeId{c.crate, 0});
    c.world.remove(c.wall);
    CHECK(c.world.shapes() == std::vector<ShapeId>{{c.lift, 0}, {c.crate, 1}});
}

TEST_CASE("a view that is kept beyond its body, shape, joint or field is refused, not read as 0",
          "[dynamics][editing]") {
    Crate c;
    Body body = c.world.body(c.crate);
    BodyShape shape = c.world.shape({c.crate, 1});
    Joint joint = c.world.joint(c.rope);
    Field field = c.world.field(c.wind);
    const BodyId id = c.crate;
    c.world.remove(c.wind);
    c.world.remove(c.crate);
    // The slot is used again: the view must not show another body.
    const BodyId next = c.world.add({.position = {7, 7}, .shapes = {circle(1)}});
    REQUIRE(next.index == id.index);
    for (int again = 0; again < 2; ++again) {
        CHECK_THROWS_WITH(body.position(), containsText("names no body of this world any more: it was removed"));
        CHECK_THROWS_WITH(body.contacts(), containsText("names no body of this world any more: it was removed"));
        CHECK_THROWS_WITH(body.setVelocity({1, 0}),
                          containsText("names no body of this world any more: it was removed"));
        CHECK_THROWS_WITH(body.wake(), containsText("names no body of this world any more: it was removed"));
        CHECK_THROWS_WITH(shape.material(), containsText("names no body of this world any more: it was removed"));
        CHECK_THROWS_WITH(shape.setTag(3), containsText("names no body of this world any more: it was removed"));
        CHECK_THROWS_WITH(joint.reaction(), containsText("names no joint of this world any more: it was removed"));
        CHECK_THROWS_WITH(joint.setMotorSpeed(1),
                          containsText("names no joint of this world any more: it was removed"));
        CHECK_THROWS_WITH(field.def(), containsText("names no field of this world any more: it was removed"));
        c.world.step(1.0 / 60);
    }
    CHECK(body.id() == id);
    CHECK(c.world.body(next).velocity().x() == 0);
}

TEST_CASE("a shape's properties are changed one by one, and the rest of it stays", "[dynamics][editing]") {
    Crate c;
    const BodyId hill = c.world.add({.type = BodyType::Static, .shapes = {chain({{0, -9}, {5, -8}, {9, -9}})}});
    const BodyId level = c.world.add(
        {.type = BodyType::Static, .position = {30, 0}, .shapes = {tiles(tileMapOf({"##", "##"}), {.friction = 0.2})}});
    for (const ShapeId id : {ShapeId{c.crate, 0}, ShapeId{hill, 0}, ShapeId{level, 0}}) {
        BodyShape shape = c.world.shape(id);
        const ShapeDef before = shape.def();
        shape.setTag(7);
        shape.setFilter({.category = 4});
        shape.setMaterial({.density = 3, .friction = 0.1});
        CHECK(shape.tag() == 7);
        CHECK(shape.filter() == Filter{.category = 4});
        CHECK(shape.material() == Material{.density = 3, .friction = 0.1});
        CHECK(shape.def().shape == before.shape);
        CHECK(shape.def().tag == 7);
        CHECK(shape.sensor() == before.sensor);
        CHECK_THROWS_WITH(shape.setMaterial({.friction = -1}), containsText("ShapeDef.material.friction: -1"));
        CHECK(shape.material().friction == 0.1);
    }
    CHECK(c.world.body(c.crate).mass() > 3);  // 3 kg of the box, and the disc
}

TEST_CASE("a push that could move nothing is refused, and says why", "[dynamics][editing]") {
    Crate c;
    for (const auto& [id, type] : {std::pair(c.wall, "static"), std::pair(c.lift, "kinematic")}) {
        Body body = c.world.body(id);
        const std::string why = std::string("does nothing to a body that is ") + type + ", not dynamic";
        CHECK_THROWS_WITH(body.applyImpulse({1, 0}), containsText("Body.applyImpulse: impulse: (1, 0) " + why));
        CHECK_THROWS_WITH(body.applyImpulse({1, 0}, {0, 0}), containsText(why));
        CHECK_THROWS_WITH(body.applyForce({1, 0}), containsText("Body.applyForce: force: (1, 0) " + why));
        CHECK_THROWS_WITH(body.applyTorque(2), containsText("Body.applyTorque: torque: 2 " + why));
        CHECK_THROWS_WITH(body.applyAngularImpulse(2), containsText("Body.applyAngularImpulse: impulse: 2 " + why));
    }
}

TEST_CASE("a joint with a number that could do nothing is refused, and says what it lacks", "[dynamics][joints]") {
    Crate c;
    const auto refusal = [&](auto def, const std::string& text) {
        def.bodyA = c.wall;
        def.bodyB = c.crate;
        CHECK_THROWS_WITH(c.world.join(def), containsText(text));
    };
    refusal(DistanceJointDef{.anchorB = {0, -2}, .maxLength = 3},
            "DistanceJointDef.maxLength: 3 does nothing without a spring");
    refusal(DistanceJointDef{.anchorB = {0, -2}, .minLength = 1}, "minLength: 1 does nothing without a spring");
    refusal(DistanceJointDef{.anchorB = {0, -2}, .maxMotorForce = 5}, "maxMotorForce: 5 does nothing without a spring");
    refusal(RevoluteJointDef{.motorSpeed = 2}, "RevoluteJointDef.motorSpeed: 2 does nothing while maxMotorTorque is 0");
    refusal(RevoluteJointDef{.restAngle = 1}, "RevoluteJointDef.restAngle: 1 does nothing without a spring");
    refusal(PrismaticJointDef{.motorSpeed = 2}, "motorSpeed: 2 does nothing while maxMotorForce is 0");
    refusal(PrismaticJointDef{.restShift = 1}, "PrismaticJointDef.restShift: 1 does nothing without a spring");
    refusal(WheelJointDef{.motorSpeed = 2}, "motorSpeed: 2 does nothing while maxMotorTorque is 0");
    CHECK_THROWS_WITH(c.world.joint(c.rope).setMotorSpeed(1),
                      containsText("RevoluteJointDef.motorSpeed: 1 does nothing while maxMotorTorque is 0"));
    CHECK(c.world.joints().size() == 1);

    // A car coasts: its motor is off, and keeps its speed.
    RevoluteJointDef motor{.bodyA = c.wall, .bodyB = c.crate, .motorSpeed = 2, .maxMotorTorque = 5};
    const JointId wheel = c.world.join(motor);
    motor.maxMotorTorque = 0;
    CHECK_NOTHROW(c.world.joint(wheel).set(motor));
}
