// SPDX-License-Identifier: MIT
#include <games/shell/desktop/sound.h>

namespace plumb::games {

void Sound::fill(void* mixer, Uint8* bytes, int count) {
    const std::size_t samples = static_cast<std::size_t>(count) / sizeof(float);
    static_cast<Mixer*>(mixer)->mix({reinterpret_cast<float*>(bytes), samples});
}

Sound::Sound() {
    if (SDL_InitSubSystem(SDL_INIT_AUDIO) != 0) return;
    SDL_AudioSpec wanted{};
    wanted.freq = rate;
    wanted.format = AUDIO_F32SYS;
    wanted.channels = 1;
    wanted.samples = 512;  // 11 ms: short enough to match the picture
    wanted.callback = &Sound::fill;
    wanted.userdata = &mixer_;
    device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
    if (device_ != 0) SDL_PauseAudioDevice(device_, 0);
}

Sound::~Sound() {
    if (device_ != 0) SDL_CloseAudioDevice(device_);
}

void Sound::play(const Cue& cue) {
    if (device_ == 0 || muted_) return;
    SDL_LockAudioDevice(device_);
    mixer_.add(cue);
    SDL_UnlockAudioDevice(device_);
}

}  // namespace plumb::games
