// SPDX-License-Identifier: MIT
#include <compare/scene/mover.h>

#include <algorithm>

namespace plumb::compare {
namespace {

MotionPath straightThrough(const PathMotion& motion) {
    MotionPath path(motion.points.front());
    for (std::size_t i = 1; i < motion.points.size(); ++i) path.lineTo(motion.points[i]);
    if (motion.closed) path.close();
    return path;
}

}  // namespace

PathMover pathMoverOf(const PathMotion& motion) {
    return PathMover({.path = motion.spline ? splineThrough(motion.points, motion.closed) : straightThrough(motion),
                      .timing = {motion.speed, motion.easing, motion.acceleration},
                      .repeat = motion.repeat});
}

bool needsTarget(Behaviour behaviour) {
    return behaviour != Behaviour::Wander && behaviour != Behaviour::Follow && behaviour != Behaviour::Flock;
}

std::optional<double> discRadius(const BodyDef& body) {
    std::optional<double> reach;
    for (const ShapeDef& shape : body.shapes)
        if (const auto* circle = std::get_if<Circle>(&shape.shape))
            reach = std::max(reach.value_or(0), circle->center.norm() + circle->radius);
    return reach;
}

}  // namespace plumb::compare
