// SPDX-License-Identifier: MIT
#include <games/maze/sounds.h>

#include <array>

namespace plumb::games::maze {
namespace {

/// The frequency this many semitones above the A of 110 Hz, in equal temperament [Hz].
double pitch(int halfTones) {
    double hertz = 110;
    for (int i = 0; i < halfTones; ++i) hertz *= 1.0594630943592953;
    return hertz;
}

struct Note {
    int halfTones;
    double at, seconds;
};

template <std::size_t count>
void add(Cues& cues, const std::array<Note, count>& notes, Wave wave, double volume) {
    for (const Note& note : notes)
        cues.push_back({.wave = wave,
                        .from = pitch(note.halfTones),
                        .to = pitch(note.halfTones),
                        .seconds = note.seconds,
                        .volume = volume,
                        .delay = note.at});
}

// A short, quiet tune in D minor: two steps up, a rest, and on.
constexpr double beat = 0.15;
constexpr std::array<Note, 15> tune{{{17, 0 * beat, 0.14},
                                     {20, 1 * beat, 0.14},
                                     {24, 2 * beat, 0.14},
                                     {23, 3 * beat, 0.14},
                                     {24, 4 * beat, 0.3},
                                     {17, 7 * beat, 0.14},
                                     {20, 8 * beat, 0.14},
                                     {25, 9 * beat, 0.14},
                                     {24, 10 * beat, 0.14},
                                     {25, 11 * beat, 0.3},
                                     {27, 14 * beat, 0.12},
                                     {25, 15 * beat, 0.12},
                                     {24, 16 * beat, 0.12},
                                     {20, 17 * beat, 0.12},
                                     {29, 18 * beat, 0.4}}};
constexpr std::array<Note, 7> bass{{{5, 0 * beat, 0.28},
                                    {12, 2 * beat, 0.28},
                                    {5, 4 * beat, 0.28},
                                    {1, 7 * beat, 0.28},
                                    {8, 9 * beat, 0.28},
                                    {0, 14 * beat, 0.28},
                                    {5, 18 * beat, 0.4}}};

}  // namespace

Cues introTune() {
    Cues cues;
    add(cues, tune, Wave::Square, 0.22);
    add(cues, bass, Wave::Triangle, 0.4);
    return cues;
}

Cues dotSound(int count) {
    const bool up = count % 2 == 0;
    return {{.wave = Wave::Triangle,
             .from = up ? 330.0 : 495.0,
             .to = up ? 495.0 : 330.0,
             .seconds = 0.07,
             .volume = 0.34}};
}

Cues powerSound() {
    return {{.wave = Wave::Square, .from = 180, .to = 720, .seconds = 0.28, .volume = 0.28},
            {.wave = Wave::Sine, .from = 360, .to = 1440, .seconds = 0.28, .volume = 0.3, .delay = 0.04}};
}

Cues hunterSound(int points) {
    const double base = points >= 1600 ? 700 : points >= 800 ? 600 : points >= 400 ? 500 : 420;
    return {{.wave = Wave::Square, .from = base * 0.5, .to = base * 2, .seconds = 0.22, .volume = 0.28},
            {.wave = Wave::Triangle, .from = base * 2, .to = base * 3, .seconds = 0.2, .volume = 0.3, .delay = 0.2}};
}

Cues fruitSound() {
    Cues cues;
    add(cues, std::array<Note, 3>{{{24, 0, 0.08}, {28, 0.08, 0.08}, {31, 0.16, 0.18}}}, Wave::Triangle, 0.5);
    return cues;
}

Cues caughtSound() {
    Cues cues;
    for (int i = 0; i < 7; ++i) {
        const double from = 760.0 - 85 * i;
        cues.push_back({.wave = Wave::Square,
                        .from = from,
                        .to = from * 0.6,
                        .seconds = 0.15,
                        .volume = 0.26,
                        .delay = 0.5 + 0.15 * i});
    }
    cues.push_back({.wave = Wave::Noise, .from = 900, .to = 200, .seconds = 0.3, .volume = 0.25, .delay = 1.6});
    return cues;
}

Cues clearedSound() {
    Cues cues;
    add(cues,
        std::array<Note, 6>{
            {{17, 0, 0.1}, {20, 0.1, 0.1}, {24, 0.2, 0.1}, {29, 0.3, 0.1}, {32, 0.4, 0.1}, {36, 0.5, 0.4}}},
        Wave::Square, 0.22);
    return cues;
}

Cues extraLifeSound() {
    Cues cues;
    for (int i = 0; i < 6; ++i)
        cues.push_back(
            {.wave = Wave::Sine, .from = 1320, .to = 1320, .seconds = 0.09, .volume = 0.45, .delay = 0.12 * i});
    return cues;
}

Cues hum(double urgency, bool fright) {
    if (fright) return {{.wave = Wave::Triangle, .from = 130, .to = 196, .seconds = 0.12, .volume = 0.22}};
    const double low = 92 + 60 * urgency;
    return {{.wave = Wave::Triangle, .from = low, .to = low * 1.5, .seconds = 0.16, .volume = 0.2, .fade = 0.6},
            {.wave = Wave::Triangle,
             .from = low * 1.5,
             .to = low,
             .seconds = 0.16,
             .volume = 0.16,
             .delay = 0.17,
             .fade = 0.6}};
}

int humTicks(double urgency, bool fright) {
    constexpr int calm = 24, urgent = 16, afraid = 8;
    return fright ? afraid : calm - static_cast<int>((calm - urgent) * urgency);
}

}  // namespace plumb::games::maze
