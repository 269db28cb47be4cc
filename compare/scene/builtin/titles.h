// SPDX-License-Identifier: MIT
// What are the built-in scenes called, and which of them form a group?
#pragma once

#include <compare/scene/scene.h>

namespace plumb::compare {

/// Gives a scene its title and group by its name. A scene that is not known here keeps its own.
void giveTitle(Scene& scene);

}  // namespace plumb::compare
