// SPDX-License-Identifier: MIT
#include <games/artillery/draw.h>

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
    // The glow: plain discs take a tenth of the time of a gradient.
    for (const double radius : {3.6, 2.9, 2.3, 1.8, 1.4})
        canvas.circle(sun, radius * palette.sunRadius, palette.sun.faded(0.08));
    canvas.circle(sun, palette.sunRadius, palette.sun);
    if (!palette.stars) return;
    for (const Vec2& sea : {Vec2(-0.8, 0.6), Vec2(0.7, 0.9), Vec2(0.3, -0.8)})  // the spots of a moon
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

void drawCloud(Canvas& canvas, const Color& color) {
    canvas.rect({-3.4, -0.6}, {6.8, 1.2}, color, 0.6);
    canvas.circle({-1.2, 0.5}, 1.0, color);
    canvas.circle({0.6, 0.8}, 1.35, color);
    canvas.circle({2.0, 0.3}, 0.8, color);
}

/// Each cloud drifts with the wind, at its own height and speed.
void drawClouds(Canvas& canvas, const Palette& palette, double drift) {
    Random random(5);
    const Color color = mix(palette.skyMiddle, palette.cloud, 0.6);
    for (int i = 0; i < 7; ++i) {
        const double x = random.uniform(-60, 60) + drift * random.uniform(0.06, 0.12);
        const Vec2 at(x - 120 * std::floor((x + 60) / 120), random.uniform(16, 30));
        const double size = random.uniform(0.6, 1.3);
        const auto there = canvas.place({.position = at, .scale = {size, 0.8 * size}});
        drawCloud(canvas, color);
    }
}

/// A few circling gulls, not at night.
void drawGulls(Canvas& canvas, double seconds, double drift) {
    for (int i = 0; i < 4; ++i) {
        const double pace = 0.22 + 0.04 * i, turn = seconds * pace + 1.7 * i;
        const double x = -18 + 13 * i + 0.05 * drift + 4 * wave(turn);
        const Vec2 at(x - 80 * std::floor((x + 40) / 80), 16 + 2.5 * i + 1.2 * wave(1.7 * turn));
        const double flap = 0.28 * wave(seconds * (5 + 0.6 * i) + i);
        for (const double side : {-1.0, 1.0})
            canvas.polyline({at, at + Vec2(side * 0.45, 0.22 + flap), at + Vec2(side * 0.9, 0.05 + 1.6 * flap)},
                            ink.faded(0.65), 0.12);
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

/// The outline of the ground, or of a layer of earth at this depth, across the picture; closed below the picture.
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

/// Grass, or soot where a blast has been, from column first to column last.
void drawTurf(Canvas& canvas, const Terrain& terrain, const Palette& palette, int first, int last, bool isBurnt) {
    std::vector<Vec2> top, middle, band;
    for (int i = first; i <= last; ++i) {
        top.emplace_back(Terrain::xOf(i), terrain.height(i) - 0.02);
        middle.emplace_back(Terrain::xOf(i), terrain.height(i) - 0.2);
        band.emplace_back(Terrain::xOf(i), terrain.height(i));
    }
    if (!isBurnt) {
        canvas.polyline(std::move(middle), palette.turf, 0.5);
        canvas.polyline(std::move(top), palette.turfLight, 0.2);
        return;
    }
    for (int i = last; i >= first; --i) band.emplace_back(Terrain::xOf(i), terrain.height(i) - 0.8);
    canvas.polygon(std::move(band), palette.burnt.faded(0.45));
    canvas.polyline(std::move(top), palette.burnt, 0.24);
}

void drawAllTurf(Canvas& canvas, const Terrain& terrain, const Palette& palette, const Aabb& seen) {
    const int last = Terrain::columnAt(seen.upper.x() + 1);
    for (int from = Terrain::columnAt(seen.lower.x() - 1); from < last;) {
        const bool isBurnt = terrain.burnt(from) > 0.5;
        int to = from + 1;
        while (to < last && (terrain.burnt(to) > 0.5) == isBurnt) ++to;
        drawTurf(canvas, terrain, palette, from, to, isBurnt);
        from = to;
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

/// The camera, raised or lowered so that the horizon is where the other camera has it.
Camera withHorizonOf(const Camera& other, Camera camera) {
    camera.center = {camera.center.x(), horizon + (other.center.y() - horizon) * camera.height / other.height};
    return camera;
}

}  // namespace

void drawBackdrop(Canvas& canvas, const Camera& camera, const Palette& palette, double seconds, double drift) {
    canvas.look(farCamera(camera, 0.15));
    drawSky(canvas, palette);
    if (palette.stars) drawStars(canvas, seconds);
    drawClouds(canvas, palette, drift);
    if (!palette.stars) drawGulls(canvas, seconds, drift);
    const Camera near = farCamera(camera, 0.45);
    canvas.look(withHorizonOf(near, farCamera(camera, 0.3)));
    drawHills(canvas, palette.farHills, 2.6, 9, 1.3);
    canvas.look(near);
    drawHills(canvas, palette.nearHills, 1.8, 6, 4.1);
    drawFarSea(canvas, palette, seconds);
}

void drawEarth(Canvas& canvas, const Terrain& terrain, const Palette& palette) {
    const Aabb seen = canvas.visible();
    const Paint earth = Paint::linear({0, 15}, palette.earthTop, {0, -6}, palette.earthDeep);
    canvas.polygon(layerOf(terrain, seen, 0), earth);
    for (const double depth : {1.5, 3.6, 6.4}) canvas.polygon(layerOf(terrain, seen, depth), palette.layer.faded(0.33));
    drawAllTurf(canvas, terrain, palette, seen);
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
