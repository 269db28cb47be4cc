// SPDX-License-Identifier: MIT
// Where do small steps say that hung bodies go which hit each other? For tests alone; shares no code with closed forms.
#pragma once
#include <vector>

#include <compare/engine/engine.h>

namespace plumb::compare {

/// Discs in a row on hinges: alike discs that touch and come nearer swap their speeds, one pair after another.
std::vector<std::vector<BodyState>> cradleSteps(const Scene& scene, const std::vector<double>& times);

/// A bullet that flies level until its front is at the wall on the right of a block on rods, and then goes with it.
std::vector<std::vector<BodyState>> ballisticSteps(const Scene& scene, const std::vector<double>& times);

}  // namespace plumb::compare
