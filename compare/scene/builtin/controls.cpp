// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>

#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

using Controls = std::vector<SceneControl>;

SceneControl durationControl() {
    return {.label = "Duration", .set = {"duration"}, .from = 0.5, .to = 60, .step = 0.5, .unit = "s"};
}

SceneControl gravityControl() {
    return {.label = "Gravity", .set = {"gravity.1"}, .as = ShownAs::Downwards, .to = 25, .unit = "m/s²"};
}

Controls shotControls() {
    return {
        {.label = "Speed", .set = {"bodies.ball.velocity"}, .as = ShownAs::Size, .to = 40, .step = 0.1, .unit = "m/s"},
        {.label = "Angle",
         .set = {"bodies.ball.velocity"},
         .as = ShownAs::Direction,
         .to = 90,
         .step = 0.5,
         .unit = "°"},
        {.label = "Height", .set = {"bodies.ball.position"}, .as = ShownAs::Y, .to = 30, .step = 0.1, .unit = "m"},
        gravityControl(),
        durationControl()};
}

Controls dragControls() {
    Controls controls = shotControls();
    controls.push_back({.label = "Drag, by speed", .set = {"bodies.ball.linearDamping"}, .to = 2, .unit = "1/s"});
    return controls;
}

Controls fallControls() {
    return {{.label = "Height", .set = {"bodies.ball.position"}, .as = ShownAs::Y, .to = 100, .step = 0.5, .unit = "m"},
            {.label = "Speed upwards",
             .set = {"bodies.ball.velocity"},
             .as = ShownAs::Y,
             .from = -20,
             .to = 20,
             .step = 0.1,
             .unit = "m/s"},
            gravityControl(),
            durationControl()};
}

Controls bounceControls() {
    return {{.label = "Restitution e", .set = {"bodies.ball.restitution"}},
            {.label = "Height of its centre",
             .set = {"bodies.ball.position"},
             .as = ShownAs::Y,
             .from = 0.6,
             .to = 20,
             .step = 0.1,
             .unit = "m"},
            gravityControl(),
            durationControl()};
}

/// The bob hangs from (0, 2).
Controls pendulumControls() {
    return {{.label = "Angle",
             .set = {"bodies.bob.position"},
             .as = ShownAs::Hanging,
             .about = {0, 2},
             .from = -179,
             .to = 179,
             .step = 1,
             .unit = "°"},
            {.label = "Length",
             .set = {"bodies.bob.position"},
             .as = ShownAs::Size,
             .about = {0, 2},
             .from = 0.2,
             .to = 4,
             .unit = "m"},
            gravityControl(),
            durationControl()};
}

Controls discControls() {
    Controls controls;
    for (const std::string name : {"A", "B"}) {
        const std::string body = name == "A" ? "bodies.disc_a" : "bodies.disc_b";
        controls.push_back({.label = "Mass of disc " + name,
                            .set = {body + ".mass"},
                            .from = 0.1,
                            .to = 10,
                            .step = 0.1,
                            .unit = "kg"});
        controls.push_back({.label = "Speed of disc " + name,
                            .set = {body + ".velocity"},
                            .as = ShownAs::Size,
                            .to = 10,
                            .step = 0.1,
                            .unit = "m/s"});
        controls.push_back({.label = "Direction of disc " + name,
                            .set = {body + ".velocity"},
                            .as = ShownAs::Direction,
                            .from = -180,
                            .to = 180,
                            .step = 1,
                            .unit = "°"});
    }
    controls.push_back({.label = "Offset of disc A",
                        .set = {"bodies.disc_a.position"},
                        .as = ShownAs::Y,
                        .from = -1,
                        .to = 1,
                        .unit = "m"});
    controls.push_back({.label = "Restitution e", .set = {"bodies.disc_a.restitution", "bodies.disc_b.restitution"}});
    return controls;
}

Controls slopeControls() {
    return {{.label = "Slope",
             .set = {"bodies.incline.angle", "bodies.block.angle"},
             .as = ShownAs::DegreesDown,
             .to = 60,
             .step = 0.5,
             .unit = "°"},
            {.label = "Friction", .set = {"bodies.block.friction", "bodies.incline.friction"}, .to = 1.5},
            {.label = "Mass", .set = {"bodies.block.mass"}, .from = 0.1, .to = 20, .step = 0.1, .unit = "kg"},
            gravityControl(),
            durationControl()};
}

Controls springControls() {
    const std::string spring = "joints.spring_of_weight.distance.spring";
    return {{.label = "Stiffness k", .set = {spring + ".stiffness"}, .from = 1, .to = 200, .step = 1, .unit = "N/m"},
            {.label = "Damping c", .set = {spring + ".damping"}, .to = 20, .step = 0.1, .unit = "N s/m"},
            {.label = "Mass", .set = {"bodies.weight.mass"}, .from = 0.1, .to = 5, .step = 0.1, .unit = "kg"},
            gravityControl(),
            durationControl()};
}

Controls atwoodControls() {
    return {{.label = "Mass of the light one",
             .set = {"bodies.light.mass"},
             .from = 0.1,
             .to = 10,
             .step = 0.1,
             .unit = "kg"},
            {.label = "Mass of the heavy one",
             .set = {"bodies.heavy.mass"},
             .from = 0.1,
             .to = 10,
             .step = 0.1,
             .unit = "kg"},
            gravityControl(),
            durationControl()};
}

Controls rollControls() {
    return {{.label = "Speed",
             .set = {"bodies.disc.velocity"},
             .as = ShownAs::X,
             .from = -8,
             .to = 8,
             .step = 0.1,
             .unit = "m/s"},
            {.label = "Friction", .set = {"bodies.disc.friction", "bodies.floor.friction"}},
            gravityControl(),
            durationControl()};
}

Controls airControls() {
    return {{.label = "Drag, by the square of speed",
             .set = {"fields.air.drag.quadratic"},
             .to = 0.1,
             .step = 0.001,
             .unit = "kg/m"},
            {.label = "Mass", .set = {"bodies.ball.mass"}, .from = 0.1, .to = 10, .step = 0.1, .unit = "kg"},
            gravityControl(),
            durationControl()};
}

struct Offered {
    std::string_view scene;
    Controls (*controls)();
};

constexpr Offered offered[] = {
    {"free_fall", fallControls},        {"projectile", shotControls},        {"projectile_damped", dragControls},
    {"terminal_speed", airControls},    {"bounce_08", bounceControls},       {"bounce_1", bounceControls},
    {"head_on_1", discControls},        {"head_on_05", discControls},        {"head_on_0", discControls},
    {"oblique_1", discControls},        {"oblique_08", discControls},        {"block_slides", slopeControls},
    {"block_sticks", slopeControls},    {"slide_to_roll", rollControls},     {"pendulum_45", pendulumControls},
    {"pendulum_150", pendulumControls}, {"spring_undamped", springControls}, {"atwood_machine", atwoodControls},
};

}  // namespace

std::vector<SceneControl> controlsOf(const std::string& scene) {
    const auto* found = std::ranges::find(offered, scene, &Offered::scene);
    return found == std::end(offered) ? Controls{} : found->controls();
}

}  // namespace plumb::compare
