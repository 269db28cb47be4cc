// SPDX-License-Identifier: MIT
// How is a scene written in a file?
#pragma once
#include <string>
#include <string_view>

#include <compare/scene/scene.h>

namespace plumb::compare {

enum class Defaults {
    LeftOut,  ///< only fields that differ from their defaults
    Written,  ///< every field; null for a value that is not given and has no default
};

/// The scene as JSON; reading it gives an equal scene.
/// Throws std::invalid_argument as validate does: an invalid scene is not written.
std::string toJson(const Scene& scene, Defaults defaults = Defaults::LeftOut);

/// The scene that the text describes. file is the name of the text in messages. A field with a default may be left out.
/// A shape may be "circle", "capsule", "polygon", "segment", "chain", or "box": {"halfSize": [x, y], "center": [x, y],
/// "radius": r}. The mass of a body may be one number: the densities of its shapes are scaled to it. The bound of a
/// motor, a limit or a joint may be "infinite", and a lower limit "-infinite". Throws std::invalid_argument with one
/// line that says where, what, and what was wanted: "FILE:LINE:COLUMN: ..." for text that is not JSON, "FILE:LINE:
/// bodies[2].shapes[0].circle.radius: -1 is not positive" for JSON that is not a scene. Unknown fields and fields given
/// twice are refused. A field that may be left out and has no default, such as a joint's limit, may also be null.
Scene fromJson(std::string_view text, const std::string& file);

}  // namespace plumb::compare
