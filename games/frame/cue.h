// SPDX-License-Identifier: MIT
// What is to be heard?
#pragma once

namespace plumb::games {

enum class Wave { Sine, Triangle, Square, Noise };

/// One tone, or one burst of noise. A tune is several, each with its delay.
struct Cue {
    Wave wave = Wave::Square;
    double from = 440, to = 440;  ///< the pitch, at first and at last, > 0; of noise, how often it changes [Hz]
    double seconds = 0.1;         ///< > 0 [s]
    double volume = 0.5;          ///< 0 to 1, of the loudest [-]
    double delay = 0;             ///< >= 0, before it sounds [s]
    double fade = 1;              ///< the share of it, at its end, in which it dies away, 0 to 1 [-]
};

}  // namespace plumb::games
