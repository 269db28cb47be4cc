// SPDX-License-Identifier: MIT
// Can the checks fail? Plumb is given broken data, one law at a time, and the built-in scenes that watch that law must
// turn red: a comparison that is green whatever happens proves nothing.
#include <compare/check/verdict.h>
#include <compare/scene/builtin.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "catch.h"

namespace plumb::compare {
namespace {

using Break = std::function<void(Scene&)>;

/// The engines of this build, but that Plumb builds the scene that breaking leaves.
std::vector<Engine> withBrokenPlumb(const Break& breakScene) {
    std::vector<Engine> result = engines();
    for (Engine& engine : result) {
        if (engine.role != Role::Subject) continue;
        engine.build = [build = engine.build, breakScene](const Scene& scene) {
            Scene broken = scene;
            breakScene(broken);
            std::erase_if(broken.probes, [&](const Probe& probe) {
                const auto* force = std::get_if<JointForceProbe>(&probe.quantity);
                return force &&
                       std::ranges::find(broken.joints, force->joint, &SceneJoint::name) == broken.joints.end();
            });
            return build(broken);
        };
    }
    return result;
}

void eachShape(Scene& scene, const std::function<void(ShapeDef&)>& change) {
    for (SceneBody& body : scene.bodies)
        for (ShapeDef& shape : body.def.shapes) change(shape);
}

/// Of joints of one kind.
template <class Def>
Break eachJoint(const std::function<void(Def&)>& change) {
    return [change](Scene& scene) {
        for (SceneJoint& joint : scene.joints)
            if (Def* def = std::get_if<Def>(&joint.def)) change(*def);
    };
}

/// Passes as it is, fails when broken, without the help of a Box2D to compare with.
void checkTurnsRed(const std::vector<std::string>& scenes, const Break& breakScene) {
    const RunOptions alone{{subjectName()}, {}, {}};
    for (const std::string& name : scenes) {
        INFO(name);
        const std::optional<Scene> scene = findScene(name);
        REQUIRE(scene);
        CHECK(runScene(*scene, alone, engines()).verdict == Verdict::Holds);
        CHECK(runScene(*scene, alone, withBrokenPlumb(breakScene)).verdict == Verdict::Fails);
    }
}

}  // namespace

TEST_CASE("a restitution 1 % too small turns the scenes that bounce red", "[compare][check]") {
    checkTurnsRed(
        {"bounce_08", "bounce_1", "wall_touch", "head_on_1", "head_on_05", "oblique_1", "oblique_08", "elastic_gas"},
        [](Scene& scene) { eachShape(scene, [](ShapeDef& s) { s.material.restitution *= 0.99; }); });
}

TEST_CASE("a restitution where there is none turns head_on_0 red", "[compare][check]") {
    checkTurnsRed({"head_on_0"},
                  [](Scene& scene) { eachShape(scene, [](ShapeDef& s) { s.material.restitution = 0.01; }); });
}

TEST_CASE("a friction 1 % too small turns block_slides red, none at all block_sticks and disc_rolls",
          "[compare][check]") {
    checkTurnsRed({"block_slides"},
                  [](Scene& scene) { eachShape(scene, [](ShapeDef& s) { s.material.friction *= 0.99; }); });
    checkTurnsRed({"block_sticks", "disc_rolls"},
                  [](Scene& scene) { eachShape(scene, [](ShapeDef& s) { s.material.friction = 0; }); });
}

TEST_CASE("an inertia 2 % too large turns rolling and swinging bodies red", "[compare][check]") {
    checkTurnsRed({"disc_rolls", "rod_pendulum_90", "pendulum_150"}, [](Scene& scene) {
        for (SceneBody& body : scene.bodies) {
            if (body.def.type != BodyType::Dynamic) continue;
            Mass mass = massOf(body.def);
            mass.inertia *= body.name == "bob" ? 3 : 1.02;  // a bob's own is 0.5 % of what swings
            body.def.mass = mass;
        }
    });
}

TEST_CASE("a hinge 1 cm beside its place and rods 2 % too long turn the scenes that hang red", "[compare][check]") {
    checkTurnsRed({"pendulum_45", "pendulum_150", "rod_pendulum_90"}, [](Scene& scene) {
        for (SceneJoint& joint : scene.joints) std::get<RevoluteJointDef>(joint.def).anchor.x() += 0.01;
    });
    checkTurnsRed({"double_pendulum", "hanging_chain"}, [](Scene& scene) {
        for (SceneJoint& joint : scene.joints) {
            DistanceJointDef& rod = std::get<DistanceJointDef>(joint.def);
            rod.length = 1.02 * (rod.anchorB - rod.anchorA).norm();
        }
    });
}

TEST_CASE("a gravity of 9.80 turns every scene that falls or rests red", "[compare][check]") {
    checkTurnsRed(
        {"free_fall", "projectile", "projectile_damped", "spin_free", "bounce_08", "bounce_1", "block_slides",
         "disc_rolls", "pendulum_45", "pendulum_150", "rod_pendulum_90", "pendulum_horizontal", "double_four_bar"},
        [](Scene& scene) { scene.gravity *= 9.80 / 9.81; });
    checkTurnsRed({"box_at_rest", "stack_of_ten", "hanging_chain", "block_sticks"},
                  [](Scene& scene) { scene.gravity *= 0.9; });
}

TEST_CASE("a spring 1 % too soft, or one that damps by 0.1 %, turns the undamped spring red", "[compare][check]") {
    checkTurnsRed({"spring_undamped"},
                  eachJoint<DistanceJointDef>([](DistanceJointDef& def) { def.spring->stiffness *= 0.99; }));
    checkTurnsRed({"spring_undamped"}, eachJoint<DistanceJointDef>([](DistanceJointDef& def) {
                      def.spring->damping = 0.001 * 2 * std::sqrt(def.spring->stiffness);
                  }));
}

TEST_CASE("a damper 1 % too strong turns the damped springs red, springs 5 % too soft or motors 2 % too fast the car",
          "[compare][check]") {
    checkTurnsRed({"springs_damped"},
                  eachJoint<DistanceJointDef>([](DistanceJointDef& def) { def.spring->damping *= 1.01; }));
    checkTurnsRed({"car_over_hills"},
                  eachJoint<WheelJointDef>([](WheelJointDef& def) { def.spring->stiffness *= 0.95; }));
    checkTurnsRed({"car_over_hills"}, eachJoint<WheelJointDef>([](WheelJointDef& def) { def.motorSpeed *= 1.02; }));
}

TEST_CASE("a pulley or gear of 1.01 for 1, or a gear left out, turns the machines red", "[compare][check]") {
    checkTurnsRed({"atwood_machine"}, eachJoint<PulleyJointDef>([](PulleyJointDef& def) { def.ratio *= 1.01; }));
    checkTurnsRed({"gear_train"}, eachJoint<GearJointDef>([](GearJointDef& def) { def.ratio *= 1.01; }));
    checkTurnsRed({"gear_train"}, [](Scene& scene) { scene.joints.pop_back(); });
}

TEST_CASE("motors 1 % off turn the machines red", "[compare][check]") {
    checkTurnsRed({"gear_train"},
                  eachJoint<RevoluteJointDef>([](RevoluteJointDef& def) { def.maxMotorTorque *= 1.01; }));
    checkTurnsRed({"scissor_lift"},
                  eachJoint<PrismaticJointDef>([](PrismaticJointDef& def) { def.motorSpeed *= 0.99; }));
}

TEST_CASE("a rail that is bent by half a degree turns the scissor lift red", "[compare][check]") {
    checkTurnsRed({"scissor_lift"},
                  eachJoint<PrismaticJointDef>([](PrismaticJointDef& def) { def.axis += Vec2(0, 0.01); }));
}

TEST_CASE("hinges 1 mm beside their places, or a load 2 % too light, turn the chains red", "[compare][check]") {
    checkTurnsRed({"loaded_chain"}, eachJoint<RevoluteJointDef>([](RevoluteJointDef& def) { def.anchor.x() += 1e-3; }));
    checkTurnsRed({"catenary", "loaded_chain"}, [](Scene& scene) { scene.gravity *= 0.98; });
}

TEST_CASE("a bullet that is 2 % too slow, or bounces back, turns the ballistic pendulum red", "[compare][check]") {
    checkTurnsRed({"ballistic_pendulum"}, [](Scene& scene) { scene.bodies.back().def.velocity *= 0.98; });
    checkTurnsRed({"ballistic_pendulum"},
                  [](Scene& scene) { eachShape(scene, [](ShapeDef& s) { s.material.restitution = 0.05; }); });
}

TEST_CASE("a restitution 1 % too small, a little rubbing or a disc 3 % too heavy turns the cradles red",
          "[compare][check]") {
    const std::vector<std::string> cradles{"cradle_one", "cradle_two", "cradle_gap"};
    checkTurnsRed(cradles, [](Scene& scene) { eachShape(scene, [](ShapeDef& s) { s.material.restitution = 0.99; }); });
    checkTurnsRed(cradles, [](Scene& scene) {
        for (SceneBody& body : scene.bodies) body.def.linearDamping = 0.02;
    });
    checkTurnsRed(cradles, [](Scene& scene) { scene.bodies.back().def.shapes.front().material.density *= 1.03; });
}

TEST_CASE("hinges 2 cm beside their places, a joint too strong or too weak turn the bridges red", "[compare][check]") {
    checkTurnsRed({"bridge_under_load"},
                  eachJoint<RevoluteJointDef>([](RevoluteJointDef& def) { def.anchor.y() += 0.02; }));
    for (const double force : {1e3, 1e6})
        checkTurnsRed({"breaking_bridge"}, eachJoint<RevoluteJointDef>([force](RevoluteJointDef& def) {
                          if (def.breaking.force < unlimited) def.breaking.force = force;
                      }));
}

TEST_CASE("limbs that bend too far, or stairs of ice, turn the doll red", "[compare][check]") {
    checkTurnsRed({"ragdoll"}, eachJoint<RevoluteJointDef>([](RevoluteJointDef& def) { def.limit.reset(); }));
    checkTurnsRed({"ragdoll"}, [](Scene& scene) { eachShape(scene, [](ShapeDef& s) { s.material.friction = 0; }); });
}

TEST_CASE("a gate that is solid, or looks for nothing, and a platform that is solid either way turn red",
          "[compare][check]") {
    checkTurnsRed({"sensor_gate"}, [](Scene& scene) { eachShape(scene, [](ShapeDef& s) { s.sensor = false; }); });
    checkTurnsRed({"sensor_gate"}, [](Scene& scene) { scene.bodies.front().def.shapes.front().filter.mask = 0; });
    checkTurnsRed({"one_way_platform"}, [](Scene& scene) { eachShape(scene, [](ShapeDef& s) { s.oneWay.reset(); }); });
    checkTurnsRed({"one_way_platform"}, [](Scene& scene) {
        eachShape(scene, [](ShapeDef& s) { s.oneWay = s.oneWay ? std::optional<Vec2>(-*s.oneWay) : std::nullopt; });
    });
}

TEST_CASE("a little damping turns the double pendulum red within its minute", "[compare][check]") {
    checkTurnsRed({"double_pendulum_minute"}, [](Scene& scene) {
        for (SceneBody& body : scene.bodies) body.def.linearDamping = 1e-3;
    });
}

}  // namespace plumb::compare
