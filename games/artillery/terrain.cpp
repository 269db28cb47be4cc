// SPDX-License-Identifier: MIT
#include <games/artillery/terrain.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <games/artillery/rules.h>
#include <plumb/math/trig.h>

namespace plumb::games::artillery {
namespace {

constexpr double seabed = -8;     ///< [m]
constexpr double shoulder = 2.5;  ///< width of the smoothed ground beside a plot [m]
constexpr double pi = 3.14159265358979323846;

struct Hill {
    double x, height, width;  ///< [m]; height is negative for a hollow, width 0 for no hill
};
struct Landscape {
    double base;       ///< above the sea [m]
    double roughness;  ///< factor for the height of its waves [-]
    std::array<Hill, 4> hills;
};
constexpr std::array<Landscape, 6> landscapes{{
    {3.0, 0.8, {{{0, 12, 6.5}}}},                                 // a ridge
    {5.0, 0.7, {{{0, -9, 7}, {-19, 4, 7}, {19, 4, 7}}}},          // a lake
    {3.0, 0.8, {{{-8, 9, 4.5}, {9, 8, 5}}}},                      // two peaks
    {3.0, 0.8, {{{-22, 8, 10}, {3, 4, 4}}}},                      // high over low
    {4.5, 1.9, {}},                                               // dunes
    {4.0, 0.6, {{{-11.5, -7, 2.6}, {1, 10, 5}, {12, -7, 2.6}}}},  // a peak between two creeks
}};

/// 0 below from, 1 above to, smooth in between.
double smoothStep(double from, double to, double x) {
    const double s = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return s * s * (3 - 2 * s);
}

struct Wave {
    double length, height, phase;
};

double heightOf(const Landscape& land, const std::array<Wave, 3>& waves, double x) {
    double height = land.base;
    for (const Hill& hill : land.hills) {
        if (hill.width <= 0) continue;
        const double s = (x - hill.x) / hill.width;
        height += hill.height * exponential(-s * s);
    }
    for (const Wave& wave : waves)
        height += land.roughness * wave.height * sinCos(2 * pi * x / wave.length + wave.phase).sin;
    const double shore = 1 - smoothStep(29, 40, std::abs(x));
    return seabed + (height - seabed) * shore;
}

}  // namespace

Terrain::Terrain(double height) : heights_(columns, height), burnt_(columns, 0), first_(heights_) {}

Terrain::Terrain(Random& random) : Terrain(0) {
    Landscape land = landscapes[static_cast<std::size_t>(random.integer(0, int{landscapes.size()} - 1))];
    const double side = random.integer(0, 1) == 0 ? 1 : -1;
    for (Hill& hill : land.hills) {
        hill.x = side * (hill.x + random.uniform(-2, 2));
        hill.height *= random.uniform(0.8, 1.15);
    }
    std::array<Wave, 3> waves{{{23, 1.3, 0}, {11, 0.6, 0}, {5, 0.18, 0}}};
    for (Wave& wave : waves) wave.phase = random.uniform(0, 2 * pi);
    for (int i = 0; i < columns; ++i) heights_[static_cast<std::size_t>(i)] = heightOf(land, waves, xOf(i));
    first_ = heights_;
}

int Terrain::columnAt(double x) {
    return static_cast<int>(std::clamp(std::round((x + half) / spacing), 0.0, columns - 1.0));
}

double Terrain::heightAt(double x) const {
    const double place = std::clamp((x + half) / spacing, 0.0, columns - 1.0);
    const int left = std::min(static_cast<int>(place), columns - 2);
    const double share = place - left;
    return height(left) * (1 - share) + height(left + 1) * share;
}

void Terrain::level(const std::vector<Plot>& plots) {
    std::vector<bool> free(columns, false);
    for (const Plot& plot : plots)
        for (int i = columnAt(plot.x - plot.halfWidth - shoulder); i <= columnAt(plot.x + plot.halfWidth + shoulder);
             ++i)
            free[static_cast<std::size_t>(i)] = true;
    for (const Plot& plot : plots)
        for (int i = columnAt(plot.x - plot.halfWidth); i <= columnAt(plot.x + plot.halfWidth); ++i) {
            heights_[static_cast<std::size_t>(i)] = plot.height;
            free[static_cast<std::size_t>(i)] = false;
        }
    // The ground between them becomes nearly straight, and meets the plots without a step.
    for (int round = 0; round < 60; ++round)
        for (std::size_t i = 1; i + 1 < columns; ++i)
            if (free[i]) heights_[i] = (heights_[i - 1] + heights_[i] + heights_[i + 1]) / 3;
    first_ = heights_;
}

void Terrain::carve(const Vec2& center, double radius) {
    const int first = columnAt(center.x() - radius), last = columnAt(center.x() + radius);
    for (int i = first; i <= last; ++i) {
        const double across = xOf(i) - center.x();
        const double square = radius * radius - across * across;
        if (square <= 0) continue;
        const double reach = std::sqrt(square);
        double& height = heights_[static_cast<std::size_t>(i)];
        const double cut = std::min(height, center.y() + reach) - (center.y() - reach);
        if (cut > 0) height = std::max(height - cut, seabed - 0.5);
    }
    for (int i = columnAt(center.x() - radius - 0.4); i <= columnAt(center.x() + radius + 0.4); ++i)
        burnt_[static_cast<std::size_t>(i)] = 1;
    for (int i = first; i <= last; ++i) slide(i);
}

/// Goes outwards from a lowered column, as long as the next column is too high.
void Terrain::slide(int column) {
    for (const int step : {-1, 1})
        for (int i = column + step; i >= 0 && i < columns; i += step) {
            const double most = height(i - step) + steepest * spacing;
            if (height(i) <= most) break;
            heights_[static_cast<std::size_t>(i)] = most;
            burnt_[static_cast<std::size_t>(i)] = std::max(burnt(i), 0.7);
        }
}

ShapeDef Terrain::shape() const {
    std::vector<Vec2> points;
    points.reserve(columns);
    for (int i = 0; i < columns; ++i) points.emplace_back(xOf(i), height(i));
    ShapeDef ground = chain(std::move(points), {.friction = 1});
    ground.filter.category = Ground;
    return ground;
}

void Terrain::addTo(Hash& hash) const {
    for (const double height : heights_) hash.add(height);
}

}  // namespace plumb::games::artillery
