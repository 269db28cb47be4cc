// SPDX-License-Identifier: MIT
// What do the bodies of one random scene have in common?
#pragma once
#include <vector>

#include <compare/scene/random/draw.h>
#include <plumb/space/shape_def.h>

namespace plumb::compare {

enum class Form { Disc, Capsule, Box, Regular, Irregular, Rounded, Compound };

/// From low to high.
struct Range {
    double low = 0, high = 0;
};

struct Style {
    Range radius{};             ///< of the circle around the body's origin that the body fits in [m]
    bool mostlySmall = false;   ///< a few large ones among many small ones
    std::vector<Form> forms{};  ///< all are equally likely
    Range friction{}, restitution{}, density{};
    bool upright = false;  ///< starts at angle 0
    double speed = 0;      ///< the greatest speed at the start [m/s]
    double spin = 0;       ///< the greatest angular speed at the start [rad/s]
};

/// Draws a style for this many bodies: ratios of sizes from 1 : 1 to 1 : 30, one form or up to all seven, smooth to
/// rough, not bouncing to bouncing well.
Style drawStyle(Draw& draw, int count);

/// The radius of a body of this style [m].
double drawRadius(Draw& draw, const Style& style);

Material drawMaterial(Draw& draw, const Style& style);

}  // namespace plumb::compare
