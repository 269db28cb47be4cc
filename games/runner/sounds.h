// SPDX-License-Identifier: MIT
// What does it sound like?
#pragma once
#include <vector>

#include <games/frame/cue.h>
#include <games/runner/event.h>

namespace plumb::games::runner {

std::vector<Cue> soundsOf(const Event& event);

}  // namespace plumb::games::runner
