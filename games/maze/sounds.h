// SPDX-License-Identifier: MIT
// Which sounds does the game play?
#pragma once
#include <vector>

#include <games/frame/cue.h>

namespace plumb::games::maze {

using Cues = std::vector<Cue>;

Cues introTune();
Cues dotSound(int count);  ///< two sounds alternate
Cues powerSound();
Cues hunterSound(int points);  ///< higher for more points
Cues fruitSound();
Cues caughtSound();
Cues clearedSound();
Cues extraLifeSound();

/// One beat of the background sound. Its pitch rises with urgency, 0 to 1. In fright it is one short, rising tone.
Cues hum(double urgency, bool fright);
/// Ticks until the next beat: fewer if it is more urgent, fewest in fright.
int humTicks(double urgency, bool fright);

}  // namespace plumb::games::maze
