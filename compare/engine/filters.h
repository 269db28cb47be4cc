// SPDX-License-Identifier: MIT
// Do two filters let their shapes touch?
#pragma once
#include <plumb/space/shape_def.h>

namespace plumb::compare {

/// The rule of Plumb and both Box2Ds. Shapes of the same group always touch, or never if the group is negative. For
/// other shapes, category and mask decide.
inline bool accepts(const Filter& a, const Filter& b) {
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

}  // namespace plumb::compare
