// SPDX-License-Identifier: MIT
#include <plumb/movers/arcade_profile.h>

#include <algorithm>
#include <limits>
#include <string>

#include <plumb/math/check.h>

namespace plumb {

namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

void requireLevel(int level) {
    if (level < 1) refuse("level", std::to_string(level) + " is not a level, 1 or more");
}

/// A value that is valid up to a level, after the one of the band before.
template <typename Value>
struct Band {
    int last;
    Value value;
};

constexpr int rest = std::numeric_limits<int>::max();

template <typename Value, std::size_t count>
const Value& at(const std::array<Band<Value>, count>& bands, int level) {
    requireLevel(level);
    return std::find_if(bands.begin(), bands.end(), [&](const Band<Value>& band) { return level <= band.last; })->value;
}

constexpr std::array<Band<ArcadeSpeeds>, 4> speeds{{
    {1, {80, 90, 75, 50, 40, 80, 85}},
    {4, {90, 95, 85, 55, 45, 90, 95}},
    {20, {100, 100, 95, 60, 50, 100, 105}},
    {rest, {90, 0, 95, 0, 50, 100, 105}},
}};

constexpr std::array<Band<ArcadeWaves>, 3> waveBands{{
    {1, {{7, 20, 7, 20, 5, 20, 5, forever}}},
    {4, {{7, 20, 7, 20, 5, 1033, 1.0 / 60, forever}}},
    {rest, {{5, 20, 5, 20, 5, 1037, 1.0 / 60, forever}}},
}};

constexpr std::array<Band<ArcadeHouse>, 4> houses{{
    {1, {{0, 30, 60}, 4}},
    {2, {{0, 0, 50}, 4}},
    {4, {{0, 0, 0}, 4}},
    {rest, {{0, 0, 0}, 3}},
}};

constexpr std::array<Band<ArcadeFruit>, 8> fruits{{{1, {0, 100}},
                                                   {2, {1, 300}},
                                                   {4, {2, 500}},
                                                   {6, {3, 700}},
                                                   {8, {4, 1000}},
                                                   {10, {5, 2000}},
                                                   {12, {6, 3000}},
                                                   {rest, {7, 5000}}}};

constexpr std::array<Band<int>, 8> hasteDots{
    {{1, 20}, {2, 30}, {5, 40}, {8, 50}, {11, 60}, {14, 80}, {18, 100}, {rest, 120}}};

constexpr std::array<double, 18> frightTimes{6, 5, 4, 3, 2, 5, 2, 2, 1, 5, 2, 1, 1, 3, 1, 1, 0, 1};

}  // namespace

ArcadeSpeeds arcadeSpeeds(int level) {
    return at(speeds, level);
}

ArcadeFright arcadeFright(int level) {
    requireLevel(level);
    const double time =
        level > static_cast<int>(frightTimes.size()) ? 0 : frightTimes[static_cast<std::size_t>(level - 1)];
    return {time, time == 0 ? 0 : time == 1 ? 3 : 5};
}

ArcadeWaves arcadeWaves(int level) {
    return at(waveBands, level);
}

ArcadeHouse arcadeHouse(int level) {
    return at(houses, level);
}

ArcadeFruit arcadeFruit(int level) {
    return at(fruits, level);
}

int arcadeHasteDots(int level) {
    return at(hasteDots, level);
}

HunterMode modeAt(const ArcadeWaves& waves, double time) {
    requireNotNegative(time, "modeAt: time");
    double end = 0;
    for (std::size_t wave = 0; wave + 1 < waves.times.size(); ++wave) {
        end += waves.times[wave];
        if (time < end) return wave % 2 == 0 ? HunterMode::Scatter : HunterMode::Chase;
    }
    return HunterMode::Chase;
}

}  // namespace plumb
