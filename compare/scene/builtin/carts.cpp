// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/links.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr double cartMass = 1000, lightMass = 1.57;  // [kg]
constexpr double smallRadius = 0.1, drop = 0.5;      // [m]
constexpr double axle = 0.9, aboveAxle = 0.15;       // from the middle to a wheel, and from there up to the bottom [m]
const Vec2 halfSize(1, 0.25);

/// A box on two hinged wheels, in the air.
void addCart(Scene& scene, const std::string& name, double x) {
    const double hub = drop + smallRadius;
    const std::string body = name + "body";
    scene.bodies.push_back({body,
                            {.position = {x, hub + aboveAxle + halfSize.y()},
                             .shapes = {box(halfSize, {.density = cartMass / (4 * halfSize.prod())})}}});
    for (const auto& [side, at] : {std::pair("rear", -axle), std::pair("front", axle)}) {
        const Vec2 place(x + at, hub);
        const std::string wheel = name + side;
        scene.bodies.push_back(
            {wheel,
             {.position = place, .shapes = {circle(smallRadius, {.density = discDensity(lightMass, smallRadius)})}}});
        hinge(scene, wheel + "_axle", body, wheel, place);
    }
}

SceneBody ground(double halfWidth) {
    return {"ground", {.type = BodyType::Static, .shapes = {segment({-halfWidth, 0}, {halfWidth, 0})}}};
}

/// Watches the cart's height from one second on, after it has landed.
void watchHeight(Scene& scene, const std::string& cart) {
    const std::string probe = cart + "height";
    scene.probes.push_back({.name = probe,
                            .quantity = PositionProbe{cart + "body", {0, 1}},
                            .expected = smallRadius + aboveAxle + halfSize.y(),
                            .from = 1,
                            .unit = "m"});
    scene.checks.push_back(
        invariant("probe." + probe, 2e-3, "it falls for 0.32 s and nothing is elastic, so it stays where it lands"));
}

void addChecks(Scene& scene) {
    scene.checks.push_back(invariant("joint_error_max", 1e-3, "of axles, when half a ton each lands at 3.1 m/s"));
    scene.checks.push_back(invariant("settle_time", 2, "0.32 s of fall, and as much again for the ground to stop it"));
}

}  // namespace

Scene cartOfATon() {
    Scene scene{.name = "cart_of_a_ton",
                .question = "Does a cart of a ton on wheels of 1.57 kg, let fall by half a metre, stay down?",
                .duration = 5,
                .bodies = {ground(10)}};
    addCart(scene, "", 0);
    watchHeight(scene, "");
    addChecks(scene);
    return scene;
}

Scene nineCarts() {
    constexpr int carts = 9;
    constexpr double apart = 3;  // [m]
    Scene scene{.name = "nine_carts",
                .question = "Do nine carts of a ton each rest as one does?",
                .duration = 5,
                .bodies = {ground(20)}};
    for (int i = 0; i < carts; ++i) {
        const std::string name = "cart_" + std::to_string(i + 1) + "_";
        addCart(scene, name, apart * (i - (carts - 1) / 2.0));
        watchHeight(scene, name);
    }
    addChecks(scene);
    return scene;
}

}  // namespace plumb::compare
