// SPDX-License-Identifier: MIT
// What does a page draw of a scene, before anything runs?
#pragma once
#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// Its names and words, and all that stands still: bodies with the points of their shapes, joints with the points that
/// they hold, fields, probes. Lengths in metres, angles in radians; points are x, y, x, y, ... in the body's frame.
nlohmann::json sceneView(const Scene& scene);

/// The bodies of the scene, by index, that move in an engine of this role: all except the static ones. For the closed
/// form, those that it describes.
std::vector<std::size_t> movingBodies(const Scene& scene, Role role);

}  // namespace plumb::compare
