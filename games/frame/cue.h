// SPDX-License-Identifier: MIT
// Which sound does a game play?
#pragma once

namespace plumb::games {

enum class Wave { Sine, Triangle, Square, Noise };

/// One tone, or one burst of noise. A tune is several cues, each with its own delay.
struct Cue {
    Wave wave = Wave::Square;
    double from = 440, to = 440;  ///< pitch at the start and at the end, > 0; for noise, how often it changes [Hz]
    double seconds = 0.1;         ///< > 0 [s]
    double volume = 0.5;          ///< 0 to 1, where 1 is the loudest [-]
    double delay = 0;             ///< >= 0, silence before the sound [s]
    double fade = 1;              ///< the part at its end in which it fades out, 0 to 1 of its length [-]
};

}  // namespace plumb::games
