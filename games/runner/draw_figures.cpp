// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <games/runner/draw.h>

namespace plumb::games::runner {
namespace {

const Color ink = Color::hex(0x2a2233);

void drawEye(Canvas& canvas, const Vec2& at, double size, double look, bool shut) {
    if (shut) return canvas.line(at - Vec2(size * 0.8, 0), at + Vec2(size * 0.8, 0), ink, 0.05);
    canvas.ellipse(at, {size * 0.85, size}, Color::hex(0xffffff));
    canvas.circle(at + Vec2(look * size * 0.35, -0.01), size * 0.5, ink);
    canvas.circle(at + Vec2(look * size * 0.35 - 0.02, 0.03), size * 0.17, Color::hex(0xffffff));
}

/// A bell on two feet, with a frown.
void drawSnuffer(Canvas& canvas, const Color& metal, int direction, double step) {
    for (const double side : {-1.0, 1.0})
        canvas.ellipse({0.18 * side + 0.08 * direction, -0.36 + 0.06 * std::max(0.0, std::sin(step + side * 1.57))},
                       {0.15, 0.09}, darker(metal, 0.5));
    const auto sway = canvas.place({.angle = 0.07 * std::sin(step)});
    canvas.polygon({{-0.46, -0.3}, {0.46, -0.3}, {0.3, 0.18}, {0.14, 0.36}, {-0.14, 0.36}, {-0.3, 0.18}}, metal);
    canvas.polygon({{0.1, -0.3}, {0.46, -0.3}, {0.3, 0.18}, {0.14, 0.36}, {0.02, 0.36}}, darker(metal, 0.18));
    canvas.capsule({-0.44, -0.29}, {0.44, -0.29}, 0.07, darker(metal, 0.3));
    canvas.circle({0, 0.42}, 0.09, darker(metal, 0.2));
    canvas.line({-0.25, -0.12}, {-0.19, 0.1}, lighter(metal, 0.55), 0.05);
    const double face = 0.1 * direction;
    for (const double side : {-1.0, 1.0}) {
        drawEye(canvas, {face + 0.13 * side, 0.02}, 0.1, direction, false);
        canvas.line({face + 0.05 * side, 0.11}, {face + 0.22 * side, 0.17}, ink, 0.05);
    }
}

/// A ball of thorns.
void drawBurr(Canvas& canvas, const Palette& palette, int direction, double step) {
    for (int i = 0; i < 11; ++i) {
        const auto thorn = canvas.place({.angle = -0.35 + i * 0.385 - 0.06 * std::sin(step)});
        canvas.polygon({{0.25, -0.1}, {0.25, 0.1}, {0.54, 0}}, lighter(palette.thorn, 0.2));
    }
    for (const double side : {-1.0, 1.0})
        canvas.ellipse({0.17 * side, -0.34 + 0.05 * std::max(0.0, std::sin(step + side * 1.57))}, {0.13, 0.07}, ink);
    canvas.ellipse({0, -0.03}, {0.37, 0.34}, palette.thorn);
    canvas.ellipse({-0.08, 0.08}, {0.2, 0.14}, lighter(palette.thorn, 0.18));
    for (const double side : {-1.0, 1.0})
        drawEye(canvas, {0.09 * direction + 0.12 * side, 0.02}, 0.09, direction, false);
}

void drawMoth(Canvas& canvas, int direction, double time) {
    const double flap = std::sin(time * 22);
    for (const double side : {-1.0, 1.0}) {
        const auto wing = canvas.place({.angle = side * (0.5 + 0.45 * flap), .scale = {side, 1}});
        canvas.ellipse({0.3, 0.12}, {0.3, 0.19}, Color::hex(0xd8c7e8));
        canvas.ellipse({0.32, 0.12}, {0.14, 0.09}, Color::hex(0x9a78b8));
        canvas.ellipse({0.2, -0.08}, {0.18, 0.12}, Color::hex(0xb9a2d2));
    }
    canvas.capsule({0, -0.16}, {0, 0.16}, 0.13, Color::hex(0x6a5080));
    for (const double side : {-1.0, 1.0}) {
        canvas.line({side * 0.05, 0.26}, {side * 0.16, 0.42}, Color::hex(0x6a5080), 0.035);
        drawEye(canvas, {0.05 * direction + 0.08 * side, 0.13}, 0.075, direction, false);
    }
}

/// A stomped foe is flat and fades within 26 ticks; returns its opacity [-].
double flatShare(int ticks) {
    return std::max(0.0, 1 - ticks / 26.0);
}

bool blinks(double time, double phase) {
    const double turn = time * 0.35 + phase;
    return turn - std::floor(turn) < 0.045;
}

/// The player's candle, with its feet at (0, 0).
void drawCandle(Canvas& canvas, const Scene& scene, const Hero& hero) {
    const Color wax = Color::hex(0xfff4dc), shade = Color::hex(0xe6c9a0);
    const Slide& slide = hero.mover.slide();
    const double step = scene.view.stride() * 3.4, speed = scene.view.pace();
    const bool airborne = !slide.isOnFloor, skids = slide.isOnFloor && speed * hero.facing < -2;
    for (const double side : {-1.0, 1.0}) {
        const double swing = airborne                 ? 0.14 * side
                             : std::fabs(speed) > 0.3 ? 0.22 * std::sin(step + side * 1.57)
                                                      : 0.13 * side;
        const double lift = airborne                 ? 0.1 + 0.05 * side
                            : std::fabs(speed) > 0.3 ? 0.13 * std::max(0.0, std::cos(step + side * 1.57))
                                                     : 0;
        canvas.ellipse({swing + 0.04 * hero.facing, 0.07 + lift}, {0.16, 0.09}, Color::hex(0x8a4b3c));
    }
    const auto body = canvas.place({.position = {0, 0.1}, .angle = (skids ? 0.22 : -0.1) * (speed / 9.4)});
    const double tall = hero.tall ? 0.74 : 0.56;
    canvas.rect({-0.29, 0}, {0.58, tall}, wax, 0.17);
    canvas.rect({hero.facing > 0 ? -0.29 : 0.13, 0.02}, {0.16, tall - 0.08}, shade, 0.08);
    canvas.capsule({-0.2, tall - 0.02}, {0.22, tall - 0.02}, 0.08, Color::hex(0xffffff));
    canvas.capsule({0.2 * hero.facing, tall - 0.02}, {0.2 * hero.facing, tall - 0.2}, 0.055, Color::hex(0xffffff));
    // A scarf with its ends behind the body.
    canvas.capsule({-0.25, 0.2}, {0.25, 0.2}, 0.075, Color::hex(0xd9414e));
    const double wave = 0.08 * std::sin(scene.time * 11), back = -hero.facing * (0.3 + 0.035 * std::fabs(speed));
    canvas.polyline({{-0.24 * hero.facing, 0.2},
                     {back, 0.2 + wave - 0.02 * slide.velocity.y()},
                     {1.6 * back, 0.16 - wave - 0.03 * slide.velocity.y()}},
                    Color::hex(0xd9414e), 0.12);
    const double look = hero.facing;
    for (const double side : {-1.0, 1.0})
        drawEye(canvas, {0.09 * look + 0.12 * side, 0.43 * tall / 0.74 + 0.06}, 0.105, look,
                blinks(scene.time, 0) || !hero.alive);
    canvas.line({0, tall}, {-0.03 * look, tall + 0.12}, ink, 0.05);
    if (hero.alive)
        drawFlame(canvas, {-0.02 * look, tall + 0.05}, hero.tall ? 0.72 : 0.4, scene.view.lean(), scene.time);
}

}  // namespace

void drawHero(Canvas& canvas, const Scene& scene) {
    const Hero& hero = scene.stage.hero();
    const Vec2 at = scene.at(hero.mover.body());
    const double squash = scene.view.squash();
    if (hero.alive)
        canvas.circle(at + Vec2(0, 0.6), 1.7,
                      Paint::radial(at + Vec2(0, 0.6), Color::hex(0xffc060).faded(hero.tall ? 0.35 : 0.2), 1.7,
                                    Color::hex(0xffc060).faded(0)));
    const bool hidden = hero.safeTicks > 0 && hero.safeTicks / 4 % 2 == 1 && hero.alive;
    // On a slope, the body's box touches the ground with one corner. The candle is drawn lower, to touch with its
    // middle.
    const double sink =
        hero.mover.slide().isOnFloor
            ? heroHalf.x() * std::fabs(hero.mover.slide().floorNormal.x() / hero.mover.slide().floorNormal.y())
            : 0;
    const auto place = canvas.place({.position = at - Vec2(0, heroHalf.y() + 0.8 * sink),
                                     .scale = {1 + squash, 1 - squash},
                                     .opacity = hidden ? 0.35 : 1});
    drawCandle(canvas, scene, hero);
}

void drawFoes(Canvas& canvas, const Scene& scene) {
    for (const Walker& walker : scene.stage.walkers()) {
        const double flat = flatShare(walker.deadTicks);
        if (!walker.alive && (flat <= 0 || walker.thorny)) continue;
        const Vec2 at = scene.at(walker.body);
        const double squash = walker.alive ? 1 : 0.25;
        const auto place = canvas.place({.position = at - Vec2(0, walkerHalf.y() * (1 - squash)),
                                         .scale = {walker.alive ? 1 : 1.35, squash},
                                         .opacity = walker.alive ? 1 : flat});
        const double step = 9 * scene.stageTime() + at.x();
        if (walker.thorny)
            drawBurr(canvas, scene.palette, walker.direction, step);
        else
            drawSnuffer(canvas, scene.palette.metal, walker.direction, step);
    }
    for (const Moth& moth : scene.stage.moths()) {
        const double flat = flatShare(moth.deadTicks);
        if (!moth.alive && flat <= 0) continue;
        const Vec2 at = scene.at(moth.body);
        const double fall = moth.alive ? 0 : 0.004 * moth.deadTicks * moth.deadTicks;
        const auto place = canvas.place(
            {.position = at - Vec2(0, fall), .angle = moth.alive ? 0 : 3.1, .opacity = moth.alive ? 1 : flat});
        drawMoth(canvas, scene.stage.heroAt().x() < at.x() ? -1 : 1, scene.time + static_cast<double>(moth.phase));
    }
}

void drawNight(Canvas& canvas, const Scene& scene) {
    if (scene.palette.dark <= 0) return;
    const Vec2 at = scene.at(scene.stage.hero().mover.body()) + Vec2(0, 0.5);
    const double reach = (scene.stage.hero().tall ? 8.5 : 6) + 0.15 * std::sin(9 * scene.time);
    const Color dark = Color::hex(0x060818);
    canvas.clear(Paint::radial(at, dark.faded(0), reach, dark.faded(scene.palette.dark)));
}

}  // namespace plumb::games::runner
