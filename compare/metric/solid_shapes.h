// SPDX-License-Identifier: MIT
// Which shapes of a scene are solid?
#pragma once
#include <vector>

#include <compare/scene/scene.h>
#include <compare/scene/shape_pair.h>
#include <plumb/math/transform.h>

namespace plumb::compare {

struct SolidShape {
    std::size_t body;  ///< its place in the scene
    ShapeDef shape;
    bool dynamic;
};

/// Of bodies that are enabled: neither sensors nor one-way shapes, which what passes them overlaps rightly. A tile map
/// is taken apart into what its solid tiles fill.
std::vector<SolidShape> solidShapes(const Scene& scene);

}  // namespace plumb::compare
