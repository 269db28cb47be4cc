// SPDX-License-Identifier: MIT
// How are cues played on a sound device?
#pragma once
#include <SDL.h>

#include <games/frame/synth.h>

namespace plumb::games {

/// The sound device. If there is none, it plays nothing.
class Sound {
public:
    Sound();
    ~Sound();
    Sound(const Sound&) = delete;
    Sound& operator=(const Sound&) = delete;

    void play(const Cue& cue);
    void toggleMute() { muted_ = !muted_; }

private:
    static constexpr int rate = 48000;  ///< [samples/s]
    static void fill(void* mixer, Uint8* bytes, int count);

    SDL_AudioDeviceID device_ = 0;  ///< 0: none
    Mixer mixer_{rate};
    bool muted_ = false;
};

}  // namespace plumb::games
