// SPDX-License-Identifier: MIT
// How does a cue sound?
#pragma once
#include <span>
#include <vector>

#include <games/frame/cue.h>

namespace plumb::games {

/// One channel, from -1 to 1, without the delay. Throws std::invalid_argument on an invalid cue.
std::vector<float> samplesOf(const Cue& cue, int samplesPerSecond);

/// Adds up the cues that sound at the same time.
class Mixer {
public:
    explicit Mixer(int samplesPerSecond) : rate_(samplesPerSecond) {}

    /// Plays a cue from now on. If there are more than 24 at once, the one that was added first stops.
    void add(const Cue& cue);
    /// The next samples, from -1 to 1. Louder sums are compressed, not clipped.
    void mix(std::span<float> out);
    bool silent() const { return voices_.empty(); }

private:
    struct Voice {
        std::vector<float> samples;
        std::ptrdiff_t at = 0;  ///< the next sample; negative: this number of silent samples comes first
    };

    int rate_;
    std::vector<Voice> voices_;
};

}  // namespace plumb::games
