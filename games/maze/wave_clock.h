// SPDX-License-Identifier: MIT
// Do the hunters chase the player now, or do they rest in their corners?
#pragma once
#include <games/maze/level_rules.h>

namespace plumb::games::maze {

/// Counts the frames of a life in which no hunter is frightened.
class WaveClock {
public:
    /// Counts one frame. True: the mode has changed, and all hunters must turn back.
    bool step(const ArcadeWaves& waves) {
        const HunterMode before = mode_;
        mode_ = modeAt(waves, static_cast<double>(++frames_) / framesPerSecond);
        return mode_ != before;
    }
    HunterMode mode() const { return mode_; }
    int frames() const { return frames_; }

private:
    int frames_ = 0;
    HunterMode mode_ = HunterMode::Scatter;
};

}  // namespace plumb::games::maze
