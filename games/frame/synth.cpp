// SPDX-License-Identifier: MIT
#include <games/frame/synth.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <plumb/math/check.h>
#include <plumb/math/random.h>

namespace plumb::games {
namespace {

constexpr std::size_t mostVoices = 24;
constexpr double rise = 0.003;  ///< a tone that starts at its full volume would click [s]

void validate(const Cue& cue) {
    requirePositive(cue.from, "Cue.from");
    requirePositive(cue.to, "Cue.to");
    requirePositive(cue.seconds, "Cue.seconds");
    requireWithin(cue.volume, 0, 1, "Cue.volume");
    requireNotNegative(cue.delay, "Cue.delay");
    requireWithin(cue.fade, 0, 1, "Cue.fade");
}

/// What to add to a square wave near its step at phase 0 to make it almost band-limited, so that high tones have less
/// aliasing. step: change of the phase from one sample to the next. Source: Välimäki, Huovilainen, "Antialiasing
/// oscillators in subtractive synthesis", IEEE Signal Processing Magazine 24(2), 2007.
double smoothStep(double phase, double step) {
    if (phase < step) {
        const double t = phase / step;
        return t + t - t * t - 1;
    }
    if (phase > 1 - step) {
        const double t = (phase - 1) / step;
        return t * t + t + t + 1;
    }
    return 0;
}

double square(double phase, double step) {
    const double half = phase < 0.5 ? phase + 0.5 : phase - 0.5;
    return (phase < 0.5 ? 1 : -1) + smoothStep(phase, step) - smoothStep(half, step);
}

/// It is 0 at phase 0 and rises there.
double triangle(double phase) {
    const double x = phase < 0.75 ? phase : phase - 1;
    return 1 - std::abs(4 * x - 1);
}

/// Produces a wave, sample by sample.
class Oscillator {
public:
    explicit Oscillator(Wave wave) : wave_(wave) {}

    /// step: change of the phase in this sample, in periods, up to 1/2.
    double next(double step) {
        const double value = valueAt(step);
        phase_ += step;
        if (phase_ >= 1) {
            phase_ -= 1;
            held_ = chance_.uniform(-1, 1);
        }
        return value;
    }

private:
    double valueAt(double step) const {
        switch (wave_) {
            case Wave::Sine: return std::sin(2 * std::numbers::pi * phase_);
            case Wave::Triangle: return triangle(phase_);
            case Wave::Square: return square(phase_, step);
            case Wave::Noise: break;
        }
        return held_;
    }

    Wave wave_;
    double phase_ = 0;
    Random chance_{1};
    double held_ = chance_.uniform(-1, 1);
};

/// The volume of a cue at a time after its start, 0 to 1 [-].
double envelope(const Cue& cue, double time) {
    const double in = std::min(1.0, time / rise);
    const double left = (cue.seconds - time) / (cue.seconds * std::max(cue.fade, 0.01));
    return in * std::clamp(left, 0.0, 1.0);
}

/// Keeps the value between -1 and 1; up to 0.6 it is not changed.
double soften(double value) {
    constexpr double knee = 0.6;
    const double size = std::abs(value);
    if (size <= knee) return value;
    const double over = (size - knee) / (1 - knee);
    return std::copysign(knee + (1 - knee) * over / (1 + over), value);
}

}  // namespace

std::vector<float> samplesOf(const Cue& cue, int samplesPerSecond) {
    validate(cue);
    std::vector<float> samples(static_cast<std::size_t>(cue.seconds * samplesPerSecond) + 1);
    Oscillator oscillator(cue.wave);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double time = static_cast<double>(i) / samplesPerSecond;
        // The ear hears an even change: the same musical interval in the same time.
        const double pitch = cue.from * std::pow(cue.to / cue.from, time / cue.seconds);
        const double value = oscillator.next(std::min(pitch / samplesPerSecond, 0.5));
        samples[i] = static_cast<float>(std::clamp(value, -1.0, 1.0) * cue.volume * envelope(cue, time));
    }
    return samples;
}

void Mixer::add(const Cue& cue) {
    std::vector<float> samples = samplesOf(cue, rate_);
    if (voices_.size() == mostVoices) voices_.erase(voices_.begin());
    voices_.push_back({std::move(samples), -static_cast<std::ptrdiff_t>(cue.delay * rate_)});
}

void Mixer::mix(std::span<float> out) {
    for (float& sample : out) {
        double sum = 0;
        for (Voice& voice : voices_) {
            const std::ptrdiff_t at = voice.at++;
            if (at >= 0 && at < std::ssize(voice.samples)) sum += voice.samples[static_cast<std::size_t>(at)];
        }
        sample = static_cast<float>(soften(sum));
    }
    std::erase_if(voices_, [](const Voice& voice) { return voice.at >= std::ssize(voice.samples); });
}

}  // namespace plumb::games
