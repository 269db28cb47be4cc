// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

/// A smooth disc that flies on without a force.
struct FlyingDisc {
    Vec2 position{0, 0};  ///< at t = 0 [m]
    Vec2 velocity{0, 0};  ///< [m/s]
    double radius = 0.5;  ///< [m]
    double mass = 1;      ///< [kg]
};

SceneBody bodyOf(const std::string& name, const FlyingDisc& disc, double restitution) {
    const Material material{.density = discDensity(disc.mass, disc.radius), .friction = 0, .restitution = restitution};
    return {name, {.position = disc.position, .velocity = disc.velocity, .shapes = {circle(disc.radius, material)}}};
}

Scene twoDiscs(const FlyingDisc& a, const FlyingDisc& b, double restitution) {
    return {
        .gravity = {0, 0},
        .bodies = {bodyOf("disc_a", a, restitution), bodyOf("disc_b", b, restitution)},
        .closedForm = ClosedForm{.formula = "j = (1 + e) v_n / (1/m_a + 1/m_b)",
                                 .source = "textbook: Newton's law of impact and conservation of momentum",
                                 .bodies = {FreeMotion{"disc_a"}, FreeMotion{"disc_b"}}},
        .checks = {ExactCheck{1e-6,
                              "one impact, solved at its own time in double; discs that then stay in touch are held in "
                              "float, to 1e-7 m"},
                   invariant("momentum_drift", 1e-9, "what one disc gains the other loses, in one product"),
                   invariant("angular_momentum_drift", 1e-6, "momentum times the limit of the positions")},
    };
}

/// 2 kg at 3 m/s meets 1 kg at -1 m/s after 0.775 s, in the middle of a step.
Scene headOn(double restitution) {
    Scene scene = twoDiscs({.position = {-2.1, 0}, .velocity = {3, 0}, .mass = 2},
                           {.position = {2, 0}, .velocity = {-1, 0}, .mass = 1}, restitution);
    scene.duration = 2;
    return scene;
}

/// Equal discs, one at rest. They meet after 1.01 s; then the line from the first to the second is at 30 degrees to the
/// way of the first.
Scene oblique(double restitution) {
    const double radius = 0.5;
    const Vec2 velocity(1, 0);
    const Vec2 normal = direction(degrees(30));
    Scene scene = twoDiscs({.position = -2 * radius * normal - 1.01 * velocity, .velocity = velocity, .radius = radius},
                           {.radius = radius}, restitution);
    scene.duration = 3;
    return scene;
}

const Check elasticEnergy = invariant("energy_drift", 1e-9, "an elastic impact keeps the energy, to rounding");

}  // namespace

Scene headOn1() {
    Scene scene = headOn(1);
    scene.name = "head_on_1";
    scene.question = "How do 2 kg at 3 m/s and 1 kg at -1 m/s part when nothing is lost?";
    scene.checks.push_back(elasticEnergy);
    return scene;
}

Scene headOn05() {
    Scene scene = headOn(0.5);
    scene.name = "head_on_05";
    scene.question = "How do 2 kg at 3 m/s and 1 kg at -1 m/s part when e = 0.5?";
    return scene;
}

Scene headOn0() {
    Scene scene = headOn(0);
    scene.name = "head_on_0";
    scene.question = "At what speed do 2 kg at 3 m/s and 1 kg at -1 m/s go on together when e = 0?";
    return scene;
}

Scene oblique1() {
    Scene scene = oblique(1);
    scene.name = "oblique_1";
    scene.question = "Do equal discs part at a right angle when one hits the other off its centre and e = 1?";
    scene.checks.push_back(elasticEnergy);
    return scene;
}

Scene oblique08() {
    Scene scene = oblique(0.8);
    scene.name = "oblique_08";
    scene.question = "How do equal discs part when one hits the other 30 degrees off its centre and e = 0.8?";
    return scene;
}

}  // namespace plumb::compare
