// SPDX-License-Identifier: MIT
// Where is a place of a world that goes on at its other side?
#pragma once
#include <optional>

#include <plumb/math/vec2.h>

namespace plumb {

/// A world of x in [0, width), or y in [0, height), or both: what leaves it at one side comes in at the other. Any
/// place stands for all those that are whole rounds away from it.
struct Wrap {
    std::optional<double> width = std::nullopt;   ///< > 0; none: x goes on for ever [m]
    std::optional<double> height = std::nullopt;  ///< > 0; none: y goes on for ever [m]

    bool any() const { return width || height; }
    /// The place in [0, width) x [0, height); what does not wrap stays as it is.
    Vec2 place(const Vec2& point) const { return any() ? placed(point) : point; }
    /// From one place to another, the nearest way round: no farther than half a round along each axis.
    Vec2 way(const Vec2& from, const Vec2& to) const {
        const Vec2 shift = any() ? shiftNear(to, from) : Vec2(0, 0);
        return {to.x() + shift.x() - from.x(), to.y() + shift.y() - from.y()};
    }
    /// What a point is to be shifted by, so many whole rounds, to be as near to another as it can; 0 if nothing wraps.
    Vec2 shiftNear(const Vec2& point, const Vec2& other) const;

    /// In which round a point is: whole numbers, (0, 0) from 0 to width and height; 0 along what does not wrap.
    Vec2 roundOf(const Vec2& point) const;
    /// So many rounds [m].
    Vec2 lengthOf(const Vec2& rounds) const;

    friend bool operator==(const Wrap&, const Wrap&) = default;

private:
    Vec2 placed(const Vec2& point) const;
};

}  // namespace plumb
