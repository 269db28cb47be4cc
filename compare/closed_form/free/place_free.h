// SPDX-License-Identifier: MIT
// What of a scene's body matters to how it flies?
#pragma once
#include <compare/closed_form/free/free_body.h>

namespace plumb::compare {

/// A body at its start, with what it may meet. Throws Unsupported where a joint or a lock holds it, a field pulls at it
/// that is not uniform, or what it is made of has no formula here.
FreeBody freeBodyOf(const Scene& scene, const FreeMotion& motion);

/// What the air does to a body: dv/dt = -(linear v) / m - (quadratic |v| v) / m, v seen from the wind.
struct Air {
    double linear = 0;     ///< [kg/s]
    double quadratic = 0;  ///< [kg/m]
    Vec2 wind{0, 0};       ///< [m/s]
};
Air airAt(const Scene& scene, const BodyDef& def);

/// The filter of a field lets it act on a body, everywhere. Throws Unsupported for one that acts in a region.
bool actsOn(const SceneField& field, const SceneBody& body);

}  // namespace plumb::compare
