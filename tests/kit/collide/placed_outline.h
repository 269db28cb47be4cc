// SPDX-License-Identifier: MIT
// How does a placed shape look to the Minkowski reference?
#pragma once
#include <algorithm>
#include <cmath>

#include <plumb/math/transform.h>
#include <plumb/shapes/shape.h>

#include "kit/collide/minkowski.h"

/// The standard library's, which the kit does not use: the angle is nothing the reference has to know.
inline plumb::Rot turnBy(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

inline minkowski::Point pointOf(const plumb::Vec2& v) {
    return {v.x(), v.y()};
}

/// As it lies in the world.
inline minkowski::Outline outlineOf(const plumb::Shape& shape, const plumb::Transform& pose) {
    minkowski::Outline outline;
    const auto add = [&](const plumb::Vec2& corner) { outline.corners.push_back(pointOf(pose * corner)); };
    if (const auto* circle = std::get_if<plumb::Circle>(&shape)) {
        add(circle->center);
        outline.radius = circle->radius;
    } else if (const auto* polygon = std::get_if<plumb::Polygon>(&shape)) {
        for (const plumb::Vec2& corner : polygon->vertices) add(corner);
        outline.radius = polygon->radius;
    } else if (const auto* capsule = std::get_if<plumb::Capsule>(&shape)) {
        add(capsule->start);
        add(capsule->end);
        outline.radius = capsule->radius;
    } else {
        add(std::get<plumb::Segment>(shape).start);
        add(std::get<plumb::Segment>(shape).end);
    }
    return outline;
}

inline double largestNumber(const plumb::Shape& shape) {
    double largest = 0;
    const minkowski::Outline outline = outlineOf(shape, {});
    for (const minkowski::Point p : outline.corners) largest = std::max(largest, length(p));
    return largest + outline.radius;
}
