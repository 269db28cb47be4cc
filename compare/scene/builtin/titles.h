// SPDX-License-Identifier: MIT
// What are the built-in scenes called, and which belong together?
#pragma once

#include <compare/scene/scene.h>

namespace plumb::compare {

/// Gives a scene its title and group by its name; one that is not known here keeps its own.
void giveTitle(Scene& scene);

}  // namespace plumb::compare
