// SPDX-License-Identifier: MIT
// How does it sound?
#pragma once
#include <vector>

#include <games/frame/cue.h>

namespace plumb::games::maze {

using Cues = std::vector<Cue>;

Cues introTune();
Cues dotSound(int count);  ///< they take turns
Cues powerSound();
Cues hunterSound(int points);  ///< higher for the later ones
Cues fruitSound();
Cues caughtSound();
Cues clearedSound();
Cues extraLifeSound();

/// One beat of what is always heard below: higher the more urgent it is, from 0 to 1; lower and restless in fright.
Cues hum(double urgency, bool fright);
/// Ticks until the next beat: fewer the more urgent, fewer still in fright.
int humTicks(double urgency, bool fright);

}  // namespace plumb::games::maze
