// SPDX-License-Identifier: MIT
// What must a world refuse whenever it is asked? Ids of what was removed or never was, and numbers that are none.
#include <functional>
#include <limits>

#include "kit/dynamics/random_editor.h"

namespace plumb::test {

namespace {

/// A call that takes an id is refused, and says why.
class Refusal {
public:
    Refusal(RandomEditor& editor, std::string why) : e_(editor), why_(std::move(why)) {}

    template <class Call>
    void operator()(Call&& call) const {
        const std::string said = e_.refusalOf(std::forward<Call>(call));
        ++e_.tally.refusals;
        if (said.find(why_) != std::string::npos) return;
        INFO("it said: " << said);
        FAIL("what should be refused as \"" << why_ << "\" was not");
    }

private:
    RandomEditor& e_;
    std::string why_;
};

void refuseBody(RandomEditor& e, const BodyId& id, const std::string& why) {
    if (e.world.contains(id) || e.world.contains(ShapeId{id, 0})) FAIL("a wrong id is taken for a live one");
    const Refusal refused(e, why);
    const BodyId other = e.someBody();
    const World& world = e.world;
    refused([&] { e.world.remove(id); });
    refused([&] { e.world.body(id); });
    refused([&] { world.body(id); });
    refused([&] { e.world.add(id, circle(1)); });
    refused([&] { e.world.join(RevoluteJointDef{.bodyA = id, .bodyB = other}); });
    refused([&] { e.world.join(PrismaticJointDef{.bodyA = id, .bodyB = other}); });
    refused([&] { e.world.join(DistanceJointDef{.bodyA = id, .bodyB = other}); });
    refused([&] { e.world.join(WeldJointDef{.bodyA = other, .bodyB = id}); });
    refused([&] { e.world.join(WheelJointDef{.bodyA = other, .bodyB = id}); });
    refused([&] { e.world.join(PulleyJointDef{.bodyA = other, .bodyB = id}); });
    refused([&] { e.world.join(MotorJointDef{.bodyA = id, .bodyB = id}); });
    refused([&] { e.world.join(FilterJointDef{.bodyA = other, .bodyB = id}); });
    refused([&] { e.world.join(TargetJointDef{.body = id}); });
}

void refuseShape(RandomEditor& e, const ShapeId& id, const std::string& why) {
    if (e.world.contains(id)) FAIL("a wrong id is taken for a live one");
    const Refusal refused(e, why);
    const World& world = e.world;
    refused([&] { e.world.remove(id); });
    refused([&] { (void)world.shape(id).def(); });
    refused([&] { e.world.shape(id).set(circle(1)); });
    refused([&] { (void)world.distance(id, id); });
    const ShapeId other = e.someShape();
    if (e.world.contains(other)) refused([&] { (void)world.distance(other, id); });
}

void refuseJoint(RandomEditor& e, const JointId& id, const std::string& why) {
    if (e.world.contains(id)) FAIL("a wrong id is taken for a live one");
    const Refusal refused(e, why);
    const World& world = e.world;
    refused([&] { e.world.remove(id); });
    refused([&] { e.world.joint(id); });
    refused([&] { world.joint(id); });
    refused([&] { e.world.join(GearJointDef{.jointA = id, .jointB = id}); });
    for (const RandomEditor::Joined& joint : e.joints) {
        if (!std::holds_alternative<RevoluteJointDef>(world.joint(joint.id).def())) continue;
        refused([&] { e.world.join(GearJointDef{.jointA = joint.id, .jointB = id}); });
    }
}

void useStaleIds(RandomEditor& e) {
    if (!e.removed.empty()) {
        const BodyId body = e.oneOf(e.removed);
        refuseBody(e, body, "was removed");
        refuseShape(e, {body, 0}, "was removed");
    }
    if (!e.removedShapes.empty()) refuseShape(e, e.oneOf(e.removedShapes), "was removed");
    if (!e.unjoined.empty()) refuseJoint(e, e.oneOf(e.unjoined), "was removed");
}

/// Of this world, but of a slot or a use of it that nobody has had; of no world; of another.
template <class Id>
void useWrong(RandomEditor& e, const Id& live, void (*refuse)(RandomEditor&, const Id&, const std::string&)) {
    const auto far = static_cast<std::uint32_t>(e.random.integer(1'000'000, 2'000'000'000));
    refuse(e, {far, live.generation, live.world}, "there never was");
    refuse(e, {live.index, live.generation + far, live.world}, "there never was");
    refuse(e, {live.index, live.generation + 1, live.world}, "there never was");
    refuse(e, {live.index, live.generation, 0}, "never set");
    refuse(e, {live.index, live.generation, live.world + 1}, "another world");
}

void useNeverMade(RandomEditor& e) {
    const BodyId body = e.someBody();
    useWrong<BodyId>(e, body, refuseBody);
    refuseBody(e, {0, 0, body.world}, "there never was");
    useWrong<BodyId>(e, body, [](RandomEditor& editor, const BodyId& wrong, const std::string& why) {
        refuseShape(editor, {wrong, 0}, why);
    });
    refuseShape(e, {body, 1'000'000}, "there never was");
    const JointId joint = e.joints.empty() ? JointId{0, 0, body.world} : e.oneOf(e.joints).id;
    if (!e.joints.empty()) useWrong<JointId>(e, joint, refuseJoint);
}

void useNonsense(RandomEditor& e) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    Body body = e.some();
    const World& world = e.world;
    if (e.tryTo([&] { body.setVelocity({nan, 0}); })) FAIL("nan was taken in");
    if (e.tryTo([&] { body.setPose({0, nan}, 0); })) FAIL("nan was taken in");
    if (e.tryTo([&] { e.world.add({.position = {nan, 0}}); })) FAIL("nan was taken in");
    if (e.tryTo([&] { e.world.step(-1.0); })) FAIL("a negative step was taken");
    if (e.tryTo([&] { (void)world.castRay({0, nan}, {0, 0}); })) FAIL("nan was asked");
    if (e.tryTo([&] { (void)world.castShape(Circle{}, {}, {nan, 0}); })) FAIL("nan was asked");
    if (e.tryTo([&] { (void)world.overlapBox({{0, 0}, {0, nan}}); })) FAIL("nan was asked");
    if (e.tryTo([&] { (void)world.nearest({0, 0}, nan); })) FAIL("nan was asked");
    if (e.joints.empty()) return;
    Joint joint = e.world.joint(e.oneOf(e.joints).id);
    JointDef def = joint.def();
    const bool spoiled = std::visit(
        [&](auto& d) {
            if constexpr (requires { d.breaking; }) d.breaking.force = nan;
            return requires {
                d.breaking;
            };
        },
        def);
    if (spoiled && e.tryTo([&] { joint.set(def); })) FAIL("nan was taken in");
}

}  // namespace

std::vector<RandomEditor::Action> refusedActions() {
    return {{2, useStaleIds}, {1, useNeverMade}, {1, useNonsense}};
}

}  // namespace plumb::test
