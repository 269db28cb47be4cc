// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <numbers>

#include <games/runner/draw.h>
#include <games/runner/view.h>

namespace plumb::games::runner {
namespace {

/// A pseudo-random number from 0 to 1, uniform; the same argument always gives the same result.
double chance(int number) {
    const double x = std::sin(number * 127.1 + 11.7) * 43758.5453;
    return x - std::floor(x);
}

/// A line of hills: waves of three lengths.
double hill(double x, double seed) {
    return std::sin(x * 0.011 + seed) + 0.5 * std::sin(x * 0.027 + 2 * seed) + 0.22 * std::sin(x * 0.071 + 3 * seed);
}

struct Range {
    double share;  ///< parallax: share of the camera's motion [-]
    double foot;   ///< its mean height, measured down the screen
    double rise;
    double seed;
};

/// How much lower than in a wide window the hills are [units of the screen].
double dropOf(const Aabb& screen) {
    return isUpright(screen) ? 0.36 * (screen.upper.y() - screenHeight) : 0;
}

void drawRange(Canvas& canvas, const Range& range, const Color& color, double shift, double up) {
    const Aabb seen = canvas.visible();
    std::vector<Vec2> line;
    const double foot = range.foot + up * range.share * 0.6;
    for (double x = seen.lower.x() - 8; x <= seen.upper.x() + 8; x += 8)
        line.emplace_back(x, foot - range.rise * hill(x + shift * range.share, range.seed));
    line.emplace_back(seen.upper.x() + 8, seen.upper.y() + 4);
    line.emplace_back(seen.lower.x() - 8, seen.upper.y() + 4);
    canvas.polygon(std::move(line), Paint::linear({0, foot - 1.4 * range.rise}, color, {0, foot + 130},
                                                  mix(color, Color{1, 1, 1, 1}, 0.16)));
}

/// Simple trees along the nearest hills.
void drawTrees(Canvas& canvas, const Range& range, const Color& color, double shift, double up) {
    const Aabb seen = canvas.visible();
    const double foot = range.foot + up * range.share * 0.6, way = shift * range.share;
    for (int i = static_cast<int>((seen.lower.x() + way) / 34) - 1;
         i <= static_cast<int>((seen.upper.x() + way) / 34) + 1; ++i) {
        const double x = i * 34 + 22 * chance(i) - way, tall = 16 + 22 * chance(i + 500);
        const double y = foot - range.rise * hill(x + way, range.seed) + 3;
        canvas.polygon({{x - tall * 0.26, y}, {x, y - tall}, {x + tall * 0.26, y}}, color);
        canvas.polygon({{x - tall * 0.2, y - tall * 0.4}, {x, y - tall * 1.25}, {x + tall * 0.2, y - tall * 0.4}},
                       color);
    }
}

void drawCloud(Canvas& canvas, const Vec2& at, double size, const Color& color) {
    canvas.capsule(at - Vec2(size, 0), at + Vec2(size, 0), size * 0.26, color);
    canvas.capsule(at + Vec2(-0.45 * size, -0.24 * size), at + Vec2(0.35 * size, -0.24 * size), size * 0.26, color);
}

void drawClouds(Canvas& canvas, const Scene& scene, double shift) {
    const Aabb seen = canvas.visible();
    const double wide = 980, drop = dropOf(seen), top = drop > 0 ? seen.lower.y() + uprightBand + 20 : 34;
    for (int i = 0; i < 8; ++i) {
        const double along = i * wide / 8 + 60 * chance(i) - shift * 0.12 + scene.time * (3 + 3 * chance(i + 40));
        const double x = along - std::floor((along + 170) / wide) * wide;
        drawCloud(canvas, {x, top + (110 + 2 * drop) * chance(i + 20)}, 22 + 26 * chance(i + 60), scene.palette.cloud);
        if (x + wide < seen.upper.x() + 100)
            drawCloud(canvas, {x + wide, top + (110 + 2 * drop) * chance(i + 20)}, 30, scene.palette.cloud);
    }
}

void drawStars(Canvas& canvas, double time) {
    const Aabb seen = canvas.visible();
    for (int i = 0; i < 90; ++i) {
        const double x = seen.lower.x() + (seen.upper.x() - seen.lower.x()) * chance(i);
        const double glow = 0.35 + 0.65 * std::fabs(std::sin(time * (0.5 + chance(i + 300)) + i));
        canvas.circle({x, seen.lower.y() + (210 + 3 * dropOf(seen)) * chance(i + 100)}, 0.5 + 0.8 * chance(i + 200),
                      Color::hex(0xdfe4ff).faded(glow));
    }
}

/// The lit part of a moon: half a circle, closed by a flatter curve.
void drawCrescent(Canvas& canvas, const Vec2& center, const Color& color) {
    const auto tilted = canvas.place({.position = center, .angle = 0.5});
    std::vector<Vec2> outline;
    for (int i = 0; i <= 24; ++i) {
        const double angle = std::numbers::pi * (i / 24.0 - 0.5);
        outline.emplace_back(30 * std::cos(angle), 30 * std::sin(angle));
    }
    for (int i = 24; i >= 0; --i) {
        const double angle = std::numbers::pi * (i / 24.0 - 0.5);
        outline.emplace_back(14 * std::cos(angle), 30 * std::sin(angle));
    }
    canvas.polygon(std::move(outline), color);
}

}  // namespace

void drawBackdrop(Canvas& canvas, const Scene& scene) {
    const Palette& palette = scene.palette;
    const Vec2 center = scene.camera.center;
    const double shift = center.x() * 32, up = (center.y() - 6) * 32;
    canvas.screen();
    const Aabb seen = canvas.visible();
    const double drop = dropOf(seen), skyTop = drop > 0 ? seen.lower.y() : 0;
    canvas.clear(Paint::linear({0, skyTop}, palette.skyHigh, {0, 300 + drop}, palette.skyLow));
    if (palette.dark > 0) drawStars(canvas, scene.time);
    const Vec2 light(palette.lightX * screenWidth, palette.lightY * screenHeight + drop);
    canvas.circle(light, 150, Paint::radial(light, palette.light.faded(0.5), 150, palette.light.faded(0)));
    if (palette.dark > 0)
        drawCrescent(canvas, light, palette.light);
    else
        canvas.circle(light, 30, palette.light);
    drawClouds(canvas, scene, shift);
    drawRange(canvas, {0.06, 225 + drop, 34, 0.4}, palette.far, shift, up);
    drawRange(canvas, {0.14, 262 + drop, 30, 1.9}, palette.middle, shift, up);
    const Range near{0.28, 306 + drop, 22, 4.1};
    drawTrees(canvas, near, palette.near, shift, up);
    drawRange(canvas, near, palette.near, shift, up);
}

}  // namespace plumb::games::runner
