// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/scene/random/worlds.h>

namespace plumb::compare {
namespace {

/// The space between a paddle's tip and the walls and floor. Several of the largest bodies fit in it side by side, so
/// that none is pinched.
double playAround(const Filling& filling) {
    return 3.5 * std::max(2 * filling.style.radius.high, 1.0);
}

/// A bar that turns below the heap. Returns how high it reaches.
double addPaddle(Scene& scene, Draw& draw, const Filling& filling, double halfWidth) {
    const double play = playAround(filling), most = std::min(halfWidth - play, halfWidth / 2);
    const double reach = most * draw.uniform(0.5, 1), speed = draw.eitherWay(0.5, 4);
    SceneBody paddle{"paddle", {.type = BodyType::Kinematic, .position = {0, play + reach}}};
    paddle.def.angle = draw.uniform(-fullTurn / 2, fullTurn / 2);
    paddle.def.angularVelocity = speed / reach;
    const double half = std::max(0.05, 0.05 * reach), length = std::sqrt(reach * reach - half * half);
    paddle.def.shapes = {box({length, half}, {.friction = 0.2})};
    scene.bodies.push_back(paddle);
    return play + 2 * reach;
}

/// A block that starts at the left wall and moves to the right. Returns where its front is.
double addPusher(Scene& scene, Draw& draw, double halfWidth) {
    const double height = draw.uniform(0.5, 2) + 0.2 * halfWidth, way = draw.uniform(0.1, 0.6) * halfWidth;
    SceneBody pusher{"pusher", {.type = BodyType::Kinematic, .position = {0.3 - halfWidth, height / 2}}};
    pusher.def.velocity = {way / scene.duration, 0};
    pusher.def.shapes = {box({0.25, height / 2}, {.friction = 0.3})};
    scene.bodies.push_back(pusher);
    return 0.6 - halfWidth;
}

/// Half of a bin's width: from a narrow shaft to a wide bin.
double drawHalfWidth(Draw& draw, const Filling& filling, bool hasPaddle) {
    const double width = std::sqrt(areaOf(filling.items) * draw.logUniform(0.5, 3));
    const double least = 2 * widestOf(filling.items) + 2, withPaddle = hasPaddle ? 3 * playAround(filling) : 0;
    return std::max({width, least, withPaddle}) / 2;
}

}  // namespace

std::string fillBin(Scene& scene, Draw& draw, const Filling& filling) {
    const bool isMound = draw.chance(0.3), hasBelt = draw.chance(0.25);
    const bool hasPaddle = !isMound && draw.chance(0.25), hasPusher = !hasPaddle && draw.chance(0.2);
    const double heap = drawHalfWidth(draw, filling, hasPaddle);
    const double half = isMound ? heap * draw.uniform(2, 4) : heap;
    Extent starts{-heap, heap};
    double bottom = 0.05;
    if (hasPaddle) bottom = addPaddle(scene, draw, filling, half);
    if (hasPusher) starts.left = std::max(starts.left, addPusher(scene, draw, half));
    const std::vector<Vec2> origins = placeOver(filling.items, starts, bottom, draw);
    const double top = addItems(scene, filling.items, origins);
    Material ground{.friction = 0.6};
    std::vector<ShapeDef> shapes = wallsAround({-half, half}, 0, top + headroom, ground);
    if (hasBelt) {
        ground.surfaceSpeed = draw.eitherWay(0.5, 4);
        ground.friction = 0.8;
    }
    shapes.push_back(floorAt({-half, half}, 0, ground));
    setWorld(scene, shapes);
    std::string place = isMound ? "heaped between walls far apart" : "in a bin";
    if (hasPaddle) place += " with a paddle that turns";
    if (hasPusher) place += " with a pusher";
    if (hasBelt) place += hasPaddle || hasPusher ? " and a belt for a floor" : " with a belt for a floor";
    return place;
}

}  // namespace plumb::compare
