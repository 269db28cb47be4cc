// SPDX-License-Identifier: MIT
#include <games/artillery/happening.h>

#include <algorithm>

namespace plumb::games::artillery {
namespace {

using Kind = Happening::Kind;

std::vector<Cue> tune(std::initializer_list<double> pitches, double step, Wave wave, double volume) {
    std::vector<Cue> cues;
    double delay = 0;
    for (const double pitch : pitches) {
        cues.push_back({wave, pitch, pitch, step * 1.6, volume, delay, 0.8});
        delay += step;
    }
    return cues;
}

}  // namespace

std::vector<Cue> cuesOf(const Happening& happening) {
    const double size = happening.size;
    switch (happening.kind) {
        case Kind::TurnBegan:
            return happening.crew == 0 ? tune({392, 523}, 0.09, Wave::Triangle, 0.35)
                                       : tune({349, 294}, 0.09, Wave::Triangle, 0.35);
        case Kind::Turned: return {{Wave::Square, 950, 900, 0.015, 0.1}};
        case Kind::Walked: return {{Wave::Noise, 900, 500, 0.03, 0.15}};
        case Kind::Charged: return {{Wave::Triangle, 200 + 500 * size, 220 + 520 * size, 0.06, 0.25}};
        case Kind::Hurry: return {{Wave::Square, 1400, 1400, 0.03, 0.2}};
        case Kind::Falling: return {{Wave::Sine, 1500, 500, 1.1, 0.12, 0, 0.3}};
        case Kind::Fired: return {{Wave::Noise, 2400, 300, 0.22, 0.6}, {Wave::Sine, 220, 50, 0.25, 0.7}};
        case Kind::Bounced: return {{Wave::Sine, 300, 160, 0.07, std::min(0.5, size / 20)}};
        case Kind::Exploded:
            return {{Wave::Noise, 1500, 60, 0.35 + 0.1 * size, 0.9},
                    {Wave::Sine, 120, 30, 0.4 + 0.08 * size, 0.9},
                    {Wave::Noise, 400, 80, 0.8, 0.3, 0.15}};
        case Kind::Splashed: return {{Wave::Noise, 3000, 600, 0.35, 0.4}, {Wave::Sine, 500, 140, 0.18, 0.3}};
        case Kind::Hurt: return {{Wave::Square, 520, 260, 0.1, 0.25, 0.05}};
        case Kind::Died: return tune({523, 415, 311, 208}, 0.08, Wave::Square, 0.3);
        case Kind::Thud: return {{Wave::Noise, 500, 150, 0.06, std::min(0.4, size / 25)}};
        case Kind::Tide: return {{Wave::Noise, 500, 1400, 0.9, 0.25}, {Wave::Noise, 1400, 400, 1.2, 0.25, 0.8}};
        case Kind::Over:
            return happening.crew == 0 ? tune({392, 523, 659, 784, 1047}, 0.12, Wave::Square, 0.35)
                                       : tune({392, 370, 349, 262}, 0.2, Wave::Square, 0.35);
    }
    return {};
}

}  // namespace plumb::games::artillery
