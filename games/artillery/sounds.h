// SPDX-License-Identifier: MIT
// Which sounds does an event make?
#pragma once
#include <vector>

#include <games/artillery/happening.h>
#include <games/frame/cue.h>

namespace plumb::games::artillery {

std::vector<Cue> cuesOf(const Happening& happening);

}  // namespace plumb::games::artillery
