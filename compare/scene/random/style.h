// SPDX-License-Identifier: MIT
// What do the bodies of one random scene have in common?
#pragma once
#include <vector>

#include <compare/scene/random/draw.h>
#include <plumb/space/shape_def.h>

namespace plumb::compare {

enum class Form { Disc, Capsule, Box, Regular, Irregular, Rounded, Compound };

/// low to high.
struct Range {
    double low = 0, high = 0;
};

struct Style {
    Range radius{};             ///< of the circle around a body's origin that it fits in [m]
    bool mostlySmall = false;   ///< a few large ones among many small ones
    std::vector<Form> forms{};  ///< each as likely as any other
    Range friction{}, restitution{}, density{};
    bool upright = false;  ///< starts without a turn
    double speed = 0;      ///< greatest at the start [m/s]
    double spin = 0;       ///< likewise [rad/s]
};

/// Sizes of 1 : 1 to 1 : 30, one form to all seven, smooth to rough, dead to lively; for so many bodies.
Style drawStyle(Draw& draw, int count);

/// The radius of a body of this style [m].
double drawRadius(Draw& draw, const Style& style);

Material drawMaterial(Draw& draw, const Style& style);

}  // namespace plumb::compare
