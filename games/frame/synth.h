// SPDX-License-Identifier: MIT
// How does a cue sound?
#pragma once
#include <span>
#include <vector>

#include <games/frame/cue.h>

namespace plumb::games {

/// One channel, from -1 to 1, without the delay. Throws std::invalid_argument on a cue that cannot be.
std::vector<float> samplesOf(const Cue& cue, int samplesPerSecond);

/// Adds up what sounds at the same time.
class Mixer {
public:
    explicit Mixer(int samplesPerSecond) : rate_(samplesPerSecond) {}

    /// From now on; of more than 24 at once, the one that began first falls silent.
    void add(const Cue& cue);
    /// The next samples, from -1 to 1: what would be louder is made softer, not cut off.
    void mix(std::span<float> out);
    bool silent() const { return voices_.empty(); }

private:
    struct Voice {
        std::vector<float> samples;
        std::ptrdiff_t at = 0;  ///< the next sample; negative: so many of silence come first
    };

    int rate_;
    std::vector<Voice> voices_;
};

}  // namespace plumb::games
