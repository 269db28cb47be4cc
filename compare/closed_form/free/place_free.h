// SPDX-License-Identifier: MIT
// Which properties of a body matter for how it flies?
#pragma once
#include <compare/closed_form/free/free_body.h>

namespace plumb::compare {

/// A body at its start, with the obstacles that it may meet. Throws Unsupported if a joint or a lock holds it, if a
/// field acts on it that is not uniform, or if there is no formula here for its shapes.
FreeBody freeBodyOf(const Scene& scene, const FreeMotion& motion);

/// The effect of the air on a body: dv/dt = -(linear v) / m - (quadratic |v| v) / m, v relative to the wind.
struct Air {
    double linear = 0;     ///< [kg/s]
    double quadratic = 0;  ///< [kg/m]
    Vec2 wind{0, 0};       ///< [m/s]
};
Air airAt(const Scene& scene, const BodyDef& def);

/// True if the filter of a field lets it act on a body, everywhere. Throws Unsupported for a field that acts in a
/// region.
bool actsOn(const SceneField& field, const SceneBody& body);

}  // namespace plumb::compare
