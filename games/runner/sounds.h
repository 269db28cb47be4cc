// SPDX-License-Identifier: MIT
// Which sounds does an event make?
#pragma once
#include <vector>

#include <games/frame/cue.h>
#include <games/runner/event.h>

namespace plumb::games::runner {

std::vector<Cue> soundsOf(const Event& event);

}  // namespace plumb::games::runner
