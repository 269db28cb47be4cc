// SPDX-License-Identifier: MIT
#include <compare/metric/conserved.h>

#include <compare/scene/builtin.h>

#include "catch.h"
#include "compare/scripted.h"

namespace plumb::compare {
namespace {

using Names = std::vector<std::string>;

const Names both{"momentum_drift", "angular_momentum_drift"};
const Names none;

/// The disc without gravity, and what else acts.
Scene freeDisc() {
    Scene scene = oneDisc();
    scene.gravity = {0, 0};
    return scene;
}

SceneBody fixedDisc() {
    SceneBody body = freeDisc().bodies[0];
    body.name = "post";
    body.def = {.type = BodyType::Static, .position = {3, 0}, .shapes = {circle(0.5)}};
    return body;
}

}  // namespace

TEST_CASE("momentum is conserved where only free bodies act on each other, also if each has its own gravity",
          "[compare][metric]") {
    Scene scene = freeDisc();
    CHECK(conservedMomenta(scene) == both);
    scene.fields = {{"pull", {.law = MutualGravity{}}}};
    CHECK(conservedMomenta(scene) == both);
    scene.wrap.width = 10;
    CHECK(conservedMomenta(scene) == Names{"momentum_drift"});
}

TEST_CASE("momentum is not conserved under gravity, with damping, in a field, or where a body is held",
          "[compare][metric]") {
    CHECK(conservedMomenta(oneDisc()) == none);
    const auto with = [](auto change) {
        Scene scene = freeDisc();
        change(scene);
        return conservedMomenta(scene);
    };
    CHECK(with([](Scene& scene) { scene.bodies[0].def.linearDamping = 1; }) == none);
    CHECK(with([](Scene& scene) { scene.bodies[0].def.lockX = true; }) == none);
    CHECK(with([](Scene& scene) { scene.bodies[0].appears = 1; }) == none);
    CHECK(with([](Scene& scene) { scene.fields = {{"drag", {.law = Drag{}}}}; }) == none);
    CHECK(with([](Scene& scene) { scene.joints = {{"hand", "disc", "", TargetJointDef{}}}; }) == none);
}

TEST_CASE("a fixed body takes momentum if it may touch a free one or is jointed to it", "[compare][metric]") {
    Scene scene = freeDisc();
    scene.bodies.push_back(fixedDisc());
    CHECK(conservedMomenta(scene) == none);
    scene.bodies[1].def.shapes[0].filter.mask = 2;
    CHECK(conservedMomenta(scene) == both);
    scene.joints = {{"hinge", "post", "disc", RevoluteJointDef{}}};
    CHECK(conservedMomenta(scene) == none);
}

TEST_CASE("a drift of momentum that a check asks for is one of those that say something", "[compare][metric]") {
    Scene scene = oneDisc();
    scene.checks = {InvariantCheck{"angular_momentum_drift", 1}};
    CHECK(conservedMomenta(scene) == Names{"angular_momentum_drift"});
    CHECK(conservedMomenta(*findScene("two_body_orbit")) == both);
    CHECK(conservedMomenta(*findScene("pendulum_45")) == none);
}

}  // namespace plumb::compare
