// SPDX-License-Identifier: MIT
// Do two filters let their shapes touch?
#pragma once
#include <plumb/space/shape_def.h>

namespace plumb::compare {

/// As Plumb and both Box2Ds have it: shapes of one group always do, or never where it is negative; others by category
/// and mask.
inline bool accepts(const Filter& a, const Filter& b) {
    if (a.group == b.group && a.group != 0) return a.group > 0;
    return (a.category & b.mask) != 0 && (b.category & a.mask) != 0;
}

}  // namespace plumb::compare
