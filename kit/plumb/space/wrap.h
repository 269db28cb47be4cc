// SPDX-License-Identifier: MIT
// Where is a point in a world that wraps around?
#pragma once
#include <cmath>
#include <optional>

#include <plumb/math/vec2.h>

namespace plumb {

/// Periodic boundaries: a world of x in [0, width), or y in [0, height), or both; what leaves at one side comes in at
/// the other. A point and all points that are whole periods away from it (its periodic images) are the same place.
struct Wrap {
    std::optional<double> width = std::nullopt;   ///< the period in x, > 0; none: x does not wrap [m]
    std::optional<double> height = std::nullopt;  ///< the period in y, > 0; none: y does not wrap [m]

    bool any() const { return width || height; }
    /// Is a box of this size, or a displacement, longer than a period along an axis that wraps?
    bool isExceededBy(const Vec2& size) const {
        return (width && std::fabs(size.x()) > *width) || (height && std::fabs(size.y()) > *height);
    }
    /// The image of a point in [0, width) x [0, height); a coordinate that does not wrap stays as it is.
    Vec2 place(const Vec2& point) const { return any() ? placed(point) : point; }
    /// The shortest displacement from one point to another (minimum image): at most half a period along each axis.
    Vec2 shortest(const Vec2& from, const Vec2& to) const {
        const Vec2 shift = any() ? shiftNear(to, from) : Vec2(0, 0);
        return {to.x() + shift.x() - from.x(), to.y() + shift.y() - from.y()};
    }
    /// The shift, of whole periods, that brings a point as near to another as it can be; 0 if nothing wraps.
    Vec2 shiftNear(const Vec2& point, const Vec2& other) const;

    /// In which periodic image a point is: whole numbers, (0, 0) for points from 0 to width and height; 0 along an axis
    /// that does not wrap.
    Vec2 imageIndex(const Vec2& point) const;
    /// The offset of an image [m].
    Vec2 imageOffset(const Vec2& image) const;

    friend bool operator==(const Wrap&, const Wrap&) = default;

private:
    Vec2 placed(const Vec2& point) const;
};

}  // namespace plumb
