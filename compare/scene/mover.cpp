// SPDX-License-Identifier: MIT
#include <compare/scene/mover.h>

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

}  // namespace plumb::compare
