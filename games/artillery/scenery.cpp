// SPDX-License-Identifier: MIT
#include <games/artillery/scenery.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/random.h>
#include <plumb/math/trig.h>

namespace plumb::games::artillery {
namespace {

constexpr double horizon = 3.2;  ///< [m]

double wave(double x) {
    return sinCos(x).sin;
}

void drawSky(Canvas& canvas, const Palette& palette) {
    canvas.clear(Paint::linear({0, 34}, palette.skyTop, {0, 15}, palette.skyMiddle));
    const Aabb seen = canvas.visible();
    canvas.rect(seen.lower, {seen.upper.x() - seen.lower.x(), 15.05 - seen.lower.y()},
                Paint::linear({0, 15}, palette.skyMiddle, {0, horizon}, palette.skyLow));
    const Vec2 sun(palette.sunX, palette.sunY);
    const double glow = palette.sunRadius * 4;
    canvas.circle(sun, glow, Paint::radial(sun, palette.sun.faded(0.45), glow, palette.sun.faded(0)));
    canvas.circle(sun, palette.sunRadius, palette.sun);
    if (!palette.stars) return;
    for (const Vec2& sea : {Vec2(-0.8, 0.6), Vec2(0.7, 0.9), Vec2(0.3, -0.8)})  // so it is a moon
        canvas.circle(sun + sea, 0.3 + 0.2 * sea.y() * sea.y(), darker(palette.sun, 0.12));
}

void drawStars(Canvas& canvas, double seconds) {
    Random random(11);
    for (int i = 0; i < 90; ++i) {
        const Vec2 at(random.uniform(-60, 60), random.uniform(8, 60));
        const double twinkle = 0.55 + 0.45 * wave(seconds * random.uniform(0.5, 2) + i);
        canvas.circle(at, random.uniform(0.04, 0.1), paper.faded(0.8 * twinkle));
    }
}

void drawClouds(Canvas& canvas, const Palette& palette, double seconds) {
    Random random(5);
    for (int i = 0; i < 7; ++i) {
        const double x = random.uniform(-60, 60) + seconds * random.uniform(0.15, 0.4);
        const Vec2 at(x - 120 * std::floor((x + 60) / 120), random.uniform(16, 30));
        const double size = random.uniform(0.6, 1.4);
        const Color color = palette.cloud.faded(0.55);
        const auto whole = canvas.place({.position = at, .scale = {size, size}});
        canvas.rect({-3.4, -0.5}, {6.8, 1}, color, 0.5);
        canvas.rect({-1.9, 0.1}, {3.6, 1.1}, color, 0.55);
        canvas.rect({-0.4, -1.0}, {4.6, 0.8}, color, 0.4);
    }
}

/// A row of islands on the horizon.
void drawHills(Canvas& canvas, const Color& color, double height, double length, double phase) {
    const Aabb seen = canvas.visible();
    std::vector<Vec2> outline{{seen.lower.x(), horizon - 1}};
    for (double x = seen.lower.x(); x < seen.upper.x() + 1; x += 1) {
        const double swell = wave(x / length + phase) + 0.5 * wave(2.3 * x / length + 2 * phase) + 0.13 * wave(x * 0.9);
        outline.emplace_back(x, horizon + std::max(-0.2, height * swell));
    }
    outline.emplace_back(seen.upper.x() + 1, horizon - 1);
    canvas.polygon(std::move(outline), color);
}

void drawFarSea(Canvas& canvas, const Palette& palette, double seconds) {
    const Aabb seen = canvas.visible();
    const Vec2 corner(seen.lower.x(), seen.lower.y() - 1);
    canvas.rect(corner, {seen.upper.x() - seen.lower.x(), horizon - corner.y()},
                Paint::linear({0, horizon}, mix(palette.farSea, palette.skyLow, 0.35), {0, -3}, palette.farSea));
    Random random(3);
    for (int i = 0; i < 46; ++i) {
        const double depth = random.uniform(0.05, 1);
        const double x = random.uniform(-50, 50) + wave(seconds * 0.5 + i) * 0.8;
        const double length = 0.5 + 2.2 * depth;
        canvas.line({x, horizon - 4 * depth}, {x + length, horizon - 4 * depth}, palette.foam.faded(0.3),
                    0.05 + 0.05 * depth);
    }
}

/// The ground's outline, or a layer's within the earth, over what is seen; closed far below.
std::vector<Vec2> layerOf(const Terrain& terrain, const Aabb& seen, double depth) {
    const int first = Terrain::columnAt(seen.lower.x() - 1), last = Terrain::columnAt(seen.upper.x() + 1);
    std::vector<Vec2> outline{{Terrain::xOf(first), seen.lower.y() - 2}};
    for (int i = first; i <= last; ++i) {
        const double x = Terrain::xOf(i), wobble = depth > 0 ? 0.35 * wave(x * 0.45 + depth) : 0;
        outline.emplace_back(x, std::min(terrain.height(i), terrain.firstHeight(i) - depth + wobble));
    }
    outline.emplace_back(Terrain::xOf(last), seen.lower.y() - 2);
    return outline;
}

/// Grass where no blast has been, soot where one has.
void drawTurf(Canvas& canvas, const Terrain& terrain, const Palette& palette, const Aabb& seen) {
    const int first = Terrain::columnAt(seen.lower.x() - 1), last = Terrain::columnAt(seen.upper.x() + 1);
    for (int i = first; i < last;) {
        const bool isBurnt = terrain.burnt(i) > 0.5;
        std::vector<Vec2> upper, lower;
        for (; i <= last; ++i) {
            upper.emplace_back(Terrain::xOf(i), terrain.height(i) - 0.02);
            lower.emplace_back(Terrain::xOf(i), terrain.height(i) - 0.2);
            if ((terrain.burnt(i) > 0.5) != isBurnt && upper.size() > 1) break;
        }
        canvas.polyline(lower, isBurnt ? palette.burnt : palette.turf, 0.5);
        if (!isBurnt) canvas.polyline(upper, palette.turfLight, 0.2);
    }
}

void drawBlades(Canvas& canvas, const Terrain& terrain, const Palette& palette, const Aabb& seen) {
    for (int i = Terrain::columnAt(seen.lower.x()); i <= Terrain::columnAt(seen.upper.x()); ++i) {
        Random random(static_cast<std::uint64_t>(i) * 977);
        if (random.integer(0, 2) != 0 || terrain.burnt(i) > 0 || terrain.height(i) < 0.8) continue;
        const Vec2 foot(Terrain::xOf(i), terrain.height(i));
        for (int blade = 0; blade < 3; ++blade)
            canvas.line(foot, foot + Vec2(random.uniform(-0.22, 0.22), random.uniform(0.2, 0.5)), palette.turfLight,
                        0.07);
    }
}

}  // namespace

void drawBackdrop(Canvas& canvas, const Eye& eye, const Palette& palette, double seconds, double wind) {
    canvas.look(eye.farCamera(canvas.between(), 0.15));
    drawSky(canvas, palette);
    if (palette.stars) drawStars(canvas, seconds);
    drawClouds(canvas, palette, seconds * (wind < 0 ? -1 : 1) * 2);
    canvas.look(eye.farCamera(canvas.between(), 0.3));
    drawHills(canvas, palette.farHills, 2.6, 9, 1.3);
    canvas.look(eye.farCamera(canvas.between(), 0.45));
    drawHills(canvas, palette.nearHills, 1.8, 6, 4.1);
    drawFarSea(canvas, palette, seconds);
}

void drawEarth(Canvas& canvas, const Terrain& terrain, const Palette& palette) {
    const Aabb seen = canvas.visible();
    const Paint earth = Paint::linear({0, 15}, palette.earthTop, {0, -6}, palette.earthDeep);
    canvas.polygon(layerOf(terrain, seen, 0), earth);
    for (const double depth : {1.5, 3.6, 6.4}) canvas.polygon(layerOf(terrain, seen, depth), palette.layer.faded(0.33));
    drawTurf(canvas, terrain, palette, seen);
    drawBlades(canvas, terrain, palette, seen);
}

void drawSea(Canvas& canvas, double level, const Palette& palette, double seconds) {
    const Aabb seen = canvas.visible();
    for (int row = 0; row < 2; ++row) {
        const double shift = row * 1.7 + seconds * (row == 0 ? 1.1 : -0.8);
        std::vector<Vec2> crest;
        for (double x = seen.lower.x() - 1; x < seen.upper.x() + 2; x += 0.6)
            crest.emplace_back(x, level + 0.12 * wave(x * 0.9 + shift) + 0.08 * wave(x * 2.1 - shift) - 0.25 * row);
        std::vector<Vec2> body = crest;
        body.emplace_back(seen.upper.x() + 2, seen.lower.y() - 2);
        body.emplace_back(seen.lower.x() - 1, seen.lower.y() - 2);
        canvas.polygon(std::move(body),
                       Paint::linear({0, level}, palette.sea.faded(0.55), {0, level - 5}, palette.sea.faded(0.85)));
        if (row == 0) canvas.polyline(std::move(crest), palette.foam.faded(0.75), 0.13);
    }
}

}  // namespace plumb::games::artillery
