// SPDX-License-Identifier: MIT
#include <compare/scene/builtin/parts.h>
#include <compare/scene/builtin/scenes.h>

namespace plumb::compare {
namespace {

constexpr double slope = degrees(30);
constexpr double slopeLength = 10;  // [m]
constexpr double plankLength = 30;  // long enough for the slopes that a person sets [m]

Vec2 downhill() {
    return direction(-slope);
}
Vec2 outward() {
    return perp(direction(-slope));
}
/// The point at a distance `down` from the slope's top along the slope, and at a distance `off` from its face.
Vec2 onSlope(double down, double off) {
    return Vec2(0, -slopeLength * downhill().y()) + down * downhill() + off * outward();
}

/// A wedge that goes down to the right.
SceneBody wedge(double friction) {
    const std::vector<Vec2> corners{{0, 0}, {slopeLength * downhill().x(), 0}, {0, -slopeLength * downhill().y()}};
    return {"incline", {.type = BodyType::Static, .shapes = {polygon(corners, {.friction = friction})}}};
}

/// A block of 1 kg at rest with its face on the slope. It is 1 m long and 0.5 m high, so that it does not tip. The
/// slope is a plank with its origin at the block's: so both may be turned alike.
Scene slidingBlock(double friction) {
    const Vec2 halfSize(0.5, 0.25), halfPlank(plankLength / 2, 0.15);
    const Vec2 start = onSlope(1, halfSize.y());
    const Vec2 middle(halfPlank.x() - 1, -halfSize.y() - halfPlank.y());  // of the plank, from the block
    const SceneBody plank{"incline",
                          {.type = BodyType::Static,
                           .position = start,
                           .angle = -slope,
                           .shapes = {{.shape = boxPolygon(halfPlank, middle), .material = {.friction = friction}}}}};
    const Material material{.density = 1 / (4 * halfSize.x() * halfSize.y()), .friction = friction};
    return {
        .duration = 2,
        .bodies = {plank, {"block", {.position = start, .angle = -slope, .shapes = {box(halfSize, material)}}}},
        .closedForm = ClosedForm{.formula = "a = g (sin t - mu cos t) where tan t > mu, else 0",
                                 .source = "textbook: Coulomb's law of friction",
                                 .bodies = {FreeMotion{"block"}}},
        .probes = {{.name = "normal",
                    .quantity = NormalForceProbe{"incline", "block"},
                    .expected = gravity * outward().y(),
                    .from = 0.5,
                    .unit = "N"}},
        .checks = {invariant("probe.normal", 0.01 * gravity * outward().y(),
                             "1 %: m g cos t carries the block once the first touch has died down")},
    };
}

}  // namespace

Scene blockSlides() {
    Scene scene = slidingBlock(0.3);
    scene.name = "block_slides";
    scene.question = "How fast does a block with a friction of 0.3 gain speed down 30 degrees?";
    scene.checks.push_back(
        ExactCheck{1e-3, sinksOnGround + "5/8 of it under a box; the slide itself is solved to second order"});
    return scene;
}

Scene blockSticks() {
    Scene scene = slidingBlock(0.7);
    scene.name = "block_sticks";
    scene.question = "Does a block with a friction of 0.7 stay on 30 degrees?";
    scene.checks.push_back(ExactCheck{
        1e-3, sinksOnGround + "5/8 of it under a box; friction may hold more than it has to, so nothing else moves"});
    return scene;
}

Scene discRolls() {
    const double radius = 0.5;
    const Vec2 start = onSlope(1, radius);
    const Material material{.density = discDensity(1, radius), .friction = 0.5};
    return {
        .name = "disc_rolls",
        .question = "How fast does a disc gain speed as it rolls down 30 degrees?",
        .duration = 2,
        .bodies = {wedge(0.5), {"disc", {.position = start, .shapes = {circle(radius, material)}}}},
        .closedForm = ClosedForm{.formula = "a = g sin t / (1 + k), k = I / (m r^2) = 1/2",
                                 .source = "textbook: rolling without slip; holds for mu >= tan t / 3 = 0.19",
                                 .bodies = {FreeMotion{"disc"}}},
        .probes = {{.name = "angle", .quantity = AngleProbe{"disc"}, .unit = "rad"}},
        .checks = {ExactCheck{1e-3, sinksOnGround +
                                        "half of it under a disc; the roll itself is solved to second order, but "
                                        "for the slip while friction finds its load"},
                   invariant("probe.angle", 1e-3 / radius, "the limit of the way, over the radius"),
                   invariant("energy_drift", 1e-3, "rolling does no work: the limit of the way, over its metres")},
    };
}

}  // namespace plumb::compare
