// SPDX-License-Identifier: MIT
#include <games/frame/synth.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/random.h>

#include "cases.h"
#include "catch.h"

using namespace plumb;
using namespace plumb::games;
using test::containsText;

namespace {

constexpr int rate = 48000;

/// How often the samples rise through 0 between two times [s].
int rises(const std::vector<float>& samples, double from, double to) {
    int count = 0;
    for (auto i = static_cast<std::size_t>(from * rate) + 1; i < static_cast<std::size_t>(to * rate); ++i)
        if (samples[i - 1] < 0 && samples[i] >= 0) ++count;
    return count;
}

double loudest(const std::vector<float>& samples) {
    double most = 0;
    for (const float s : samples) most = std::max(most, std::abs(double(s)));
    return most;
}

Cue cueOf(Random& random) {
    return {.wave = static_cast<Wave>(random.integer(0, 3)),
            .from = random.uniform(20, 30000),
            .to = random.uniform(20, 30000),
            .seconds = random.uniform(0.001, 0.3),
            .volume = random.uniform(0, 1),
            .delay = random.uniform(0, 0.1),
            .fade = random.uniform(0, 1)};
}

}  // namespace

TEST_CASE("a tone of 440 Hz rises through 0 440 times a second, with a sine, triangle or square wave", "[games]") {
    for (const Wave wave : {Wave::Sine, Wave::Triangle, Wave::Square}) {
        const auto samples = samplesOf({.wave = wave, .seconds = 1.2, .fade = 0.1}, rate);
        CHECK(std::abs(rises(samples, 0.01, 1.01) - 440) <= 1);
    }
}

TEST_CASE("from 200 Hz to 800 Hz in a second, each half rises by an octave: 288.5 and 577.1 waves", "[games]") {
    // The integral of 200 4^t over [0, 1/2] and [1/2, 1]: 200 (2 - 1) / ln 4 and twice that, 144.3 and 288.5 s Hz.
    const auto samples = samplesOf({.wave = Wave::Sine, .from = 200, .to = 800, .seconds = 1, .fade = 0}, rate);
    CHECK(std::abs(rises(samples, 0.0, 0.5) - 200 / std::log(4.0)) < 1.5);
    CHECK(std::abs(rises(samples, 0.5, 0.99) - 400 * (std::pow(2.0, 0.98) - 1) / std::log(4.0)) < 1.5);
}

TEST_CASE("random cues begin and end softly, last as long as they say, and never exceed their volume", "[games]") {
    Random random(8);
    for (int i = 0; i < test::cases(1000); ++i) {
        const Cue cue = cueOf(random);
        const auto samples = samplesOf(cue, rate);
        REQUIRE(std::abs(static_cast<double>(samples.size()) - cue.seconds * rate) <= 1);
        REQUIRE(loudest(samples) <= cue.volume + 1e-6);  // a float's rounding
        REQUIRE(samples.front() == 0);
        REQUIRE(std::abs(samples.back()) <= cue.volume * 0.3);
    }
}

TEST_CASE("24 square waves of full volume at once stay within -1 and 1, and a single quiet one is not changed",
          "[games]") {
    Mixer mixer(rate);
    for (int i = 0; i < 24; ++i) mixer.add({.from = 100, .to = 100, .seconds = 1, .volume = 1});
    std::vector<float> out(4800);
    mixer.mix(out);
    CHECK(loudest(out) <= 1);
    CHECK(loudest(out) > 0.95);

    const Cue quiet{.seconds = 0.05};
    Mixer alone(rate);
    alone.add(quiet);
    std::vector<float> heard(samplesOf(quiet, rate).size());
    alone.mix(heard);
    CHECK(heard == samplesOf(quiet, rate));
    CHECK(alone.silent());
}

TEST_CASE("a cue with a delay of 10 ms begins 480 samples later, for any number of samples per call", "[games]") {
    const Cue cue{.wave = Wave::Triangle, .seconds = 0.02, .delay = 0.01};
    const auto heard = [&](std::size_t atOnce) {
        Mixer mixer(rate);
        mixer.add(cue);
        std::vector<float> all;
        for (std::vector<float> part(atOnce); !mixer.silent(); all.insert(all.end(), part.begin(), part.end()))
            mixer.mix(part);
        all.resize(1441);
        return all;
    };
    const auto all = heard(7);
    CHECK(std::all_of(all.begin(), all.begin() + 481, [](float s) { return s == 0; }));
    CHECK(all[482] != 0);
    CHECK(all == heard(512));
}

TEST_CASE("the 25th voice takes the place of the first", "[games]") {
    Mixer mixer(rate);
    for (int i = 0; i < 24; ++i) mixer.add({.volume = i == 0 ? 0.5 : 0.0});
    mixer.add({.volume = 0});
    std::vector<float> out(1000);
    mixer.mix(out);
    CHECK(loudest(out) == 0);
}

TEST_CASE("an invalid cue is refused by the name of its field", "[games]") {
    CHECK_THROWS_WITH(samplesOf({.from = 0}, rate), containsText("Cue.from"));
    CHECK_THROWS_WITH(samplesOf({.to = -1}, rate), containsText("Cue.to"));
    CHECK_THROWS_WITH(samplesOf({.seconds = 0}, rate), containsText("Cue.seconds"));
    CHECK_THROWS_WITH(samplesOf({.volume = 1.5}, rate), containsText("Cue.volume"));
    CHECK_THROWS_WITH(samplesOf({.delay = -1}, rate), containsText("Cue.delay"));
    CHECK_THROWS_WITH(samplesOf({.fade = NAN}, rate), containsText("Cue.fade"));
}
