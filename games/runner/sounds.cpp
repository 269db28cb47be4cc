// SPDX-License-Identifier: MIT
#include <games/runner/event.h>

#include <algorithm>
#include <cmath>

namespace plumb::games::runner {
namespace {

/// Semitones above the A of 440 Hz.
double note(double halfTones) {
    return 440 * std::exp2(halfTones / 12);
}

std::vector<Cue> tune(std::initializer_list<double> halfTones, double beat, Wave wave, double volume) {
    std::vector<Cue> cues;
    for (const double tone : halfTones)
        cues.push_back({.wave = wave,
                        .from = note(tone),
                        .to = note(tone),
                        .seconds = beat * 1.5,
                        .volume = volume,
                        .delay = beat * static_cast<double>(cues.size())});
    return cues;
}

Cue noise(double from, double to, double seconds, double volume) {
    return {.wave = Wave::Noise, .from = from, .to = to, .seconds = seconds, .volume = volume};
}

}  // namespace

std::vector<Cue> soundsOf(const Event& event) {
    switch (event.kind) {
        case EventKind::Jumped: return {{.wave = Wave::Square, .from = 260, .to = 560, .seconds = 0.14, .volume = 0.2}};
        case EventKind::Landed:
            if (event.strength < 6) return {};
            return {noise(900, 300, 0.06, std::min(0.3, 0.018 * event.strength))};
        case EventKind::Skidded: return {noise(2600, 1800, 0.06, 0.12)};
        case EventKind::Stomped: {
            const double up = 2 * std::min(event.strength, 8.0);
            return {{.wave = Wave::Square, .from = note(up - 5), .to = note(up - 17), .seconds = 0.12, .volume = 0.3},
                    noise(3000, 600, 0.1, 0.3)};
        }
        case EventKind::Squashed: return {noise(1600, 200, 0.2, 0.35)};
        case EventKind::Sprung:
            return {{.wave = Wave::Triangle, .from = 180, .to = 900, .seconds = 0.3, .volume = 0.5}};
        case EventKind::Coin: return tune({14, 19}, 0.06, Wave::Square, 0.16);
        case EventKind::Sun: return tune({7, 11, 14, 19, 23}, 0.07, Wave::Triangle, 0.45);
        case EventKind::Oil: return tune({2, 6, 9, 14}, 0.06, Wave::Triangle, 0.4);
        case EventKind::Bumped: return {noise(400, 200, 0.08, 0.3)};
        case EventKind::LampLit: return tune({9, 16}, 0.07, Wave::Square, 0.18);
        case EventKind::BrickBroke: return {noise(1200, 250, 0.22, 0.4)};
        case EventKind::LanternLit: return tune({0, 4, 7, 12}, 0.09, Wave::Triangle, 0.4);
        case EventKind::Hurt: return {{.wave = Wave::Square, .from = 500, .to = 120, .seconds = 0.3, .volume = 0.3}};
        case EventKind::Died: return tune({3, 0, -4, -9}, 0.14, Wave::Triangle, 0.5);
        case EventKind::Finished: return tune({0, 4, 7, 12, 7, 12, 16, 19}, 0.12, Wave::Triangle, 0.5);
    }
    return {};
}

}  // namespace plumb::games::runner
