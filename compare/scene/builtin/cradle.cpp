// SPDX-License-Identifier: MIT
#include <cmath>

#include <compare/formula/pendulum.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr int discs = 5;
constexpr double discRadius = 0.1;
constexpr double hangerLength = 1;  // from hinge to centre [m]
constexpr double equivalent =
    hangerLength + discRadius * discRadius / (2 * hangerLength);  // I_pivot / (m l) of a disc [m]
constexpr double share = 0.02;                                    // share of the swing that may be wrong [-]
const double amplitude = degrees(30);

std::string discName(int disc) {
    return "disc_" + std::to_string(disc + 1);
}

double period() {
    return periodOf({equivalent, gravity, amplitude});
}

/// Elastic and smooth, so that only the line through the centres matters.
SceneBody disc(int number, const Vec2& hinge, double angle) {
    const Material glass{.density = discDensity(1, discRadius), .friction = 0, .restitution = 1};
    return {discName(number),
            {.position = hinge - hangerLength * perp(direction(angle)),
             .angle = angle,
             .canSleep = false,
             .shapes = {circle(discRadius, glass)}}};
}

/// Discs that hang side by side. The first `swung` of them are pulled out to the left.
Scene hungDiscs(int swung, double gap) {
    Scene scene{.gravity = {0, -gravity}, .bodies = {pivotBody({0, 0})}};
    for (int i = 0; i < discs; ++i) {
        const Vec2 hinge((i - 2) * (2 * discRadius + gap), 0);
        scene.bodies.push_back(disc(i, hinge, i < swung ? -amplitude : 0));
        scene.joints.push_back(
            {"hinge_" + std::to_string(i + 1), "pivot", discName(i), RevoluteJointDef{.anchor = hinge}});
    }
    return scene;
}

Probe largestAngle(const std::string& name, int disc, double from, double until, double expected) {
    return {.name = name,
            .quantity = AngleProbe{discName(disc)},
            .expected = expected,
            .from = from,
            .unit = "rad",
            .until = until,
            .watch = Watch::Largest};
}

/// Watches the swing of this number, from 0 on: first those on the right, then those on the left, then those on the
/// right.
void watchSwing(Scene& scene, int swing, int swung) {
    constexpr double clear = 0.05;  // time kept clear of the impacts before and after the swing [s]
    const double from = (0.25 + 0.5 * swing) * period() + clear, until = (0.75 + 0.5 * swing) * period() - clear;
    const std::string number = std::to_string(swing + 1);
    for (int i = 0; i < discs; ++i) {
        const bool right = i >= discs - swung, left = i < swung;
        const bool out = swing % 2 == 0 ? right : left;
        const std::string name = (out ? "out_" : "still_") + number + "_" + discName(i);
        const double expected = !out ? 0 : right ? amplitude : -amplitude;
        scene.probes.push_back(largestAngle(name, i, from, until, expected));
        scene.checks.push_back(invariant("probe." + name, share * amplitude,
                                         out ? "2 % of the swing: what comes in goes out on the other side"
                                             : "2 % of the swing: the others hang still"));
    }
}

Scene cradle(int swung) {
    Scene scene = hungDiscs(swung, 0);
    scene.duration = 1.75 * period();
    scene.closedForm = ClosedForm{
        .formula =
            "each disc that comes in stops, and one goes out on the other side: t'' = -(g / L) sin t on one side",
        .source =
            "Herrmann, Seitz, Am. J. Phys. 50 (1982) 977: alike discs that meet one pair after another swap speeds"};
    for (int i = 0; i < discs; ++i) {
        const std::string name = discName(i), hinge = scene.joints[static_cast<std::size_t>(i)].name;
        if (i < swung)
            scene.closedForm->bodies.push_back(SwingsMotion{name, hinge, Side::Left});
        else if (i >= discs - swung)
            scene.closedForm->bodies.push_back(SwingsMotion{name, hinge, Side::Right, discName(0)});
        else
            scene.closedForm->bodies.push_back(RestsMotion{name});
    }
    scene.checks = {ExactCheck{share * amplitude * hangerLength + 3e-3,
                               "2 % of the swing, and an impact put off by half a sub-step, 2 ms at 1.6 m/s"},
                    invariant("energy_drift", 1e-2, "no impact takes energy")};
    for (int swing = 0; swing < 3; ++swing) watchSwing(scene, swing, swung);
    return scene;
}

}  // namespace

Scene cradleOne() {
    Scene scene = cradle(1);
    scene.name = "cradle_one";
    scene.question = "One disc of Newton's cradle is swung: does one disc go out on the other side, and no other?";
    return scene;
}

Scene cradleTwo() {
    Scene scene = cradle(2);
    scene.name = "cradle_two";
    scene.question = "Two discs of Newton's cradle are swung: do two go out on the other side?";
    return scene;
}

Scene cradleGap() {
    Scene scene = hungDiscs(1, 0.01);
    scene.name = "cradle_gap";
    scene.question =
        "With 1 cm between the discs every engine sees one impact after another: what is left of the swing?";
    scene.duration = 0.75 * period();
    scene.probes = {largestAngle("out_1", discs - 1, 0.25 * period(), 0.75 * period(), amplitude)};
    scene.checks = {invariant("probe.out_1", share * amplitude,
                              "2 % of the swing: alike discs swap speeds along the line of their centres, which leaves "
                              "the level by no more than 1 cm in 20"),
                    invariant("energy_drift", 1e-2, "no impact takes energy")};
    return scene;
}

}  // namespace plumb::compare
