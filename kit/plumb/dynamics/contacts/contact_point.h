// SPDX-License-Identifier: MIT
// How does a point of one contact move, for those who look at contacts one by one, in double?
#pragma once
#include <plumb/dynamics/contacts/contact_graph.h>

namespace plumb {

/// A direction at a contact's point, as it acts on one of the two bodies. In the units of SolverVelocity, in which one
/// inverse mass serves shift and turn: an impulse P along it changes x, y and w of the body's record by P / m times
/// these; the speed of the body's point along it is the product of both.
struct PointAxis {
    float x = 0, y = 0, w = 0;

    float dot(const PointAxis& o) const { return x * o.x + y * o.y + w * o.w; }
    /// [m/s]
    double speedOf(const SolverVelocity& v) const {
        return static_cast<double>(x) * static_cast<double>(v.x) + static_cast<double>(y) * static_cast<double>(v.y) +
               static_cast<double>(w) * static_cast<double>(v.w);
    }
};

/// Along the normal, from A to B, and along perp(normal).
inline PointAxis normalAxis(const ContactBatch& batch, std::size_t lane, std::size_t point, bool isB) {
    const PointLanes& p = batch.points[point];
    return {batch.normalX[lane], batch.normalY[lane], isB ? -p.anchorTangentB[lane] : -p.anchorTangentA[lane]};
}
inline PointAxis tangentAxis(const ContactBatch& batch, std::size_t lane, std::size_t point, bool isB) {
    const PointLanes& p = batch.points[point];
    return {-batch.normalY[lane], batch.normalX[lane], isB ? p.anchorNormalB[lane] : p.anchorNormalA[lane]};
}
inline Vec2 normalAt(const ContactBatch& batch, std::size_t lane) {
    return {static_cast<double>(batch.normalX[lane]), static_cast<double>(batch.normalY[lane])};
}

}  // namespace plumb
