// SPDX-License-Identifier: MIT
#include <compare/scene/joint_geometry.h>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {

TEST_CASE("a hinge at (1, 2) on a body at (1, 1) turned a quarter lies at (1, 0) in its frame", "[compare][engine]") {
    using Catch::Matchers::WithinAbs;
    Scene scene = oneDisc();
    scene.bodies[0].def.position = {1, 1};
    scene.bodies[0].def.angle = 1.5707963267948966;
    scene.bodies.push_back(oneDisc().bodies[0]);
    scene.bodies[1].name = "other";
    RevoluteJointDef hinge;
    hinge.anchor = {1, 2};
    scene.joints = {{"hinge", "disc", "other", hinge}};
    const JointGeometry joint = jointGeometries(scene).at(0);
    CHECK_THAT(joint.localAnchorA.x(), WithinAbs(1, 1e-15));
    CHECK_THAT(joint.localAnchorA.y(), WithinAbs(0, 1e-15));
    CHECK(joint.localAnchorB == Vec2(1, 2));
    CHECK(joint.bodyB == 1);
    CHECK_FALSE(joint.length);
}

TEST_CASE("a rod without a length is as long as its ends are apart", "[compare][engine]") {
    Scene scene = oneDisc();
    scene.bodies.push_back(scene.bodies[0]);
    scene.bodies[1].name = "other";
    DistanceJointDef rod;
    rod.anchorA = {0, 0};
    rod.anchorB = {3, 4};
    scene.joints = {{"rod", "disc", "other", rod}};
    CHECK(*jointGeometries(scene).at(0).length == 5);
    rod.length = 2;
    scene.joints[0].def = rod;
    CHECK(*jointGeometries(scene).at(0).length == 2);
}

TEST_CASE("a name that is not in the scene is refused by name", "[compare][engine]") {
    CHECK_THROWS_WITH(bodyIndex(oneDisc(), "disk"), "scene \"one_disc\": there is no body \"disk\"");
    CHECK_THROWS_WITH(jointIndex(oneDisc(), "rod"), "scene \"one_disc\": there is no joint \"rod\"");
}

}  // namespace plumb::compare
