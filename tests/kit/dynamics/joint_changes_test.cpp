// SPDX-License-Identifier: MIT
// Is every change of a jointed body or of a joint noticed?
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <plumb/plumb.h>
#include "catch.h"
#include "kit/usual_world.h"
using namespace plumb;
using namespace plumb::test;

namespace {

/// Bodies in a row that are joined by a hinge, a slide, a rod and a spring; the first one hangs on a fixed body, and
/// the last one is locked.
struct Row {
    World world;
    BodyId body[5];
    JointId hook, hinge, slide, rod, pull;

    Row() {
        const BodyId fixed = world.add({.type = BodyType::Static});
        for (int i = 0; i < 5; ++i)
            body[i] = world.add({.position = {i, -0.1 * i}, .lockX = i == 4, .shapes = {box({0.2, 0.1 + 0.1 * i})}});
        hook = world.join(RevoluteJointDef{.bodyA = fixed, .bodyB = body[0]});
        hinge = world.join(RevoluteJointDef{
            .bodyA = body[0], .bodyB = body[1], .anchor = {0.5, 0}, .spring = Spring{20, 1}, .maxMotorTorque = 0.01});
        slide = world.join(PrismaticJointDef{
            .bodyA = body[1], .bodyB = body[2], .anchor = {1.5, 0}, .axis = {1, 1}, .limit = Limit{-0.2, 0.1}});
        rod = world.join(DistanceJointDef{.bodyA = body[2], .bodyB = body[3], .anchorA = {2, 0}, .anchorB = {3, 0}});
        pull = world.join(DistanceJointDef{
            .bodyA = body[3], .bodyB = body[4], .anchorA = {3, 0}, .anchorB = {4, 0}, .spring = Spring{300, 1}});
        run();
    }
    void run() {
        for (int tick = 0; tick < 20; ++tick) world.step(dt);
    }
    template <class Def, class Change>
    void set(JointId joint, Change&& change) {
        Def def = std::get<Def>(world.joint(joint).def());
        change(def);
        world.joint(joint).set(def);
    }
    /// Nothing changes, but each joint has been set.
    void setAll() {
        for (const JointId joint : world.joints()) world.joint(joint).set(world.joint(joint).def());
    }
};

}  // namespace

TEST_CASE("joined bodies go on after a change of one of them as if all their joints had been set anew",
          "[dynamics][joints][editing]") {
    const std::vector<std::pair<std::string, std::function<void(Row&)>>> changes{
        {"nothing", [](Row&) {}},
        {"spring", [](Row& r) { r.set<RevoluteJointDef>(r.hinge, [](auto& d) { d.spring->stiffness = 90; }); }},
        {"limit", [](Row& r) { r.set<PrismaticJointDef>(r.slide, [](auto& d) {
                                   d.limit = Limit{-1, -0.3};
                               }); }},
        {"length", [](Row& r) { r.set<DistanceJointDef>(r.rod, [](auto& d) { d.length = 0.8; }); }},
        {"motor", [](Row& r) { r.world.joint(r.hinge).setMotorSpeed(3); }},
        {"mass",
         [](Row& r) {
             r.world.body(r.body[1]).setMass({9, {0.1, 0}, 2});
         }},
        {"shape", [](Row& r) { r.world.add(r.body[2], circle(0.4)); }},
        {"rotation", [](Row& r) { r.world.body(r.body[3]).setFixedRotation(true); }},
        {"kinematic", [](Row& r) { r.world.body(r.body[2]).setType(BodyType::Kinematic); }},
        {"static", [](Row& r) { r.world.body(r.body[2]).setType(BodyType::Static); }},
        {"disabled", [](Row& r) { r.world.body(r.body[1]).setEnabled(false); }},
        {"pose",
         [](Row& r) {
             r.world.body(r.body[4]).setPose({4.5, 0}, 1);
         }},
        {"lock", [](Row& r) { r.world.body(r.body[4]).setLocks(false, true); }},
        {"removed", [](Row& r) { r.world.remove(r.rod); }},
        {"wild", [](Row& r) {
             r.world.body(r.body[4]).setVelocity({1e300, 0});
         }}};
    for (const auto& [name, change] : changes) {
        INFO(name);
        Row changed, set;
        change(changed);
        change(set);
        set.setAll();
        changed.run();
        set.run();
        CHECK(stateHash(changed.world) == stateHash(set.world));
        if (name == "nothing") continue;
        Row before;
        before.run();
        CHECK(stateHash(changed.world) != stateHash(before.world));
    }
}
