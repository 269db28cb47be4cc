// SPDX-License-Identifier: MIT
// What does one hear of it?
#pragma once
#include <vector>

#include <games/artillery/happening.h>
#include <games/frame/cue.h>

namespace plumb::games::artillery {

std::vector<Cue> cuesOf(const Happening& happening);

}  // namespace plumb::games::artillery
