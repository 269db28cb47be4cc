// SPDX-License-Identifier: MIT

#include <compare/formula/catenary.h>
#include <compare/scene/builtin/links.h>
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {

Scene catenary() {
    const HungChain chain{.left = {-2, 0}, .span = 4, .links = 20, .linkLength = 0.25};
    const std::vector<Vec2> hinges = hingesOf(chain);
    Scene scene{
        .name = "catenary",
        .question = "Does a chain of 20 links that hangs as a chain hangs stay as it is, and how hard does it pull?",
        .duration = 3,
        .bodies = {pivotBody({0, 0})},
        .closedForm = ClosedForm{.formula = "link i rises at (i + 1/2 - n/2) / H",
                                 .source = "statics; of many links y = H cosh(x / H)"},
    };
    addLinks(scene, {.hinges = hinges, .halfWidth = 0.02, .linkMass = 1});
    holdEnds(scene, hinges);
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        scene.closedForm->bodies.push_back(RestsMotion{scene.bodies[i].name});
    }
    const Vec2 first = hinges[1] - hinges[0];
    const double half = chain.links / 2.0;
    const double level = (0.5 - half) * first.x() / first.y();  // the horizontal force H, in weights of a link
    const double pull = gravity * Vec2(level, half).norm();
    scene.probes = {{.name = "pull", .quantity = JointForceProbe{"hinge_0"}, .expected = pull, .from = 1, .unit = "N"}};
    scene.checks = {
        ExactCheck{1e-3, "nothing moves it, except that hinges give way or start off their places by single precision"},
        invariant("probe.pull", 0.01 * pull, "1 % of the pull, a second after the start"),
        invariant("joint_error_max", 1e-4, "nobody sees an error of 0.1 mm"),
    };
    return scene;
}

Scene loadedChain() {
    const int links = 10;
    const double length = 0.25, linkMass = 0.1, load = 1000 * linkMass, radius = 0.3;
    std::vector<Vec2> hinges;
    for (int i = 0; i <= links; ++i) hinges.push_back({0, -length * i});
    Scene scene{
        .name = "loaded_chain",
        .question = "How far do ten links of 100 g stretch that carry 100 kg, a thousand times as much?",
        .duration = 3,
        .bodies = {pivotBody({0, 0})},
        .closedForm = ClosedForm{.formula = "x = x0", .source = "textbook: statics"},
    };
    addLinks(scene, {.hinges = hinges, .halfWidth = 0.02, .linkMass = linkMass});
    const Vec2 center = hinges.back() - Vec2(0, radius);
    scene.bodies.push_back(
        {"load",
         {.position = center, .canSleep = false, .shapes = {circle(radius, {.density = discDensity(load, radius)})}}});
    hinge(scene, "hook", "pivot", "link_1", hinges.front());
    hinge(scene, "eye", "link_" + std::to_string(links), "load", hinges.back());
    for (std::size_t i = 1; i < scene.bodies.size(); ++i) {
        scene.closedForm->bodies.push_back(RestsMotion{scene.bodies[i].name});
    }
    const double pull = gravity * (load + links * linkMass);
    scene.probes = {{.name = "pull", .quantity = JointForceProbe{"hook"}, .expected = pull, .from = 1, .unit = "N"}};
    scene.checks = {ExactCheck{1e-3, "nothing pulls it aside; eleven hinges may give way by 0.1 mm each"},
                    invariant("joint_error_max", 1e-4, "nobody sees an error of 0.1 mm"),
                    invariant("probe.pull", 0.01 * pull, "1 % of the load, a second after the start")};
    return scene;
}

}  // namespace plumb::compare
