// SPDX-License-Identifier: MIT
// How does a scene stand in a file?
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include <compare/scene/scene.h>

namespace plumb::compare {

enum class Defaults {
    LeftOut,  ///< only what differs from its default stands there
    Written,  ///< every field stands there; null is what is not given and has no default
};

/// The scene as JSON; reading it gives an equal scene.
/// Throws std::invalid_argument as validate does: a scene that is not valid is not written.
std::string toJson(const Scene& scene, Defaults defaults = Defaults::LeftOut);

/// The scene that the text describes; file names the text in messages. Fields may be left out where they have a
/// default. Beside "circle", "capsule", "polygon", "segment" and "chain" a shape may be "box": {"halfSize": [x, y],
/// "center": [x, y], "radius": r}. What bounds a motor, a limit or a joint may be "infinite", a lower limit
/// "-infinite".
/// Throws std::invalid_argument with one line that says where, what, and what was wanted: "FILE:LINE:COLUMN: ..." for
/// text that is not JSON, "FILE:LINE: bodies[2].shapes[0].circle.radius: -1 is not positive" for what is no scene.
/// Unknown fields and fields given twice are refused. What may be left out without a default, as a joint's limit, may
/// also be null.
Scene fromJson(std::string_view text, const std::string& file);

/// The scene in a file. Throws as fromJson does, and when the file cannot be read.
Scene readScene(const std::filesystem::path& path);

}  // namespace plumb::compare
