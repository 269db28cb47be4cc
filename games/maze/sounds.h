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
/// One beat of what is always heard below: faster the fewer dots are left, lower and restless in fright.
Cues hum(double urgency, bool fright);
inline constexpr int humTicks = 24;  ///< between two beats when nothing is urgent
inline constexpr int frightHumTicks = 8;

}  // namespace plumb::games::maze
