// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <games/runner/draw.h>

namespace plumb::games::runner {
namespace {

bool isSeen(const Canvas& canvas, const Vec2& at, double margin = 2) {
    const Aabb seen = inflate(canvas.visible(), margin);
    return overlap(seen, Aabb{at, at});
}

void glow(Canvas& canvas, const Vec2& at, double radius, const Color& color, double share) {
    canvas.circle(at, radius, Paint::radial(at, color.faded(share), radius, color.faded(0)));
}

void drawCoin(Canvas& canvas, const Vec2& at, double turn, const Color& color) {
    const double face = std::fabs(std::cos(turn)), half = 0.07 + 0.21 * face;
    canvas.ellipse(at + Vec2(0.04, 0), {half, 0.3}, darker(color, 0.35));
    canvas.ellipse(at, {half, 0.3}, color);
    canvas.ellipse(at, {half * 0.62, 0.2}, stroke(darker(color, 0.22), 0.05));
    canvas.ellipse(at + Vec2(-half * 0.45, 0.1), {0.03 + 0.02 * face, 0.07}, lighter(color, 0.8).faded(face));
}

void drawSun(Canvas& canvas, const Vec2& at, double time, const Color& color) {
    glow(canvas, at, 1.2, color, 0.4 + 0.1 * std::sin(3 * time));
    for (int i = 0; i < 8; ++i) {
        const auto ray = canvas.place({.position = at, .angle = time * 0.8 + i * 0.785398});
        canvas.polygon({{0.38, -0.1}, {0.38, 0.1}, {0.66 + 0.05 * std::sin(5 * time + i), 0}}, color);
    }
    canvas.circle(at, 0.4, darker(color, 0.15));
    canvas.circle(at, 0.34, color);
    canvas.circle(at + Vec2(-0.1, 0.1), 0.11, lighter(color, 0.7));
}

void drawOil(Canvas& canvas, const Vec2& at) {
    const Color color = Color::hex(0xff8b3d);
    glow(canvas, at, 0.8, color, 0.4);
    canvas.circle(at - Vec2(0, 0.08), 0.24, color);
    canvas.polygon({at + Vec2(-0.2, 0.04), at + Vec2(0.2, 0.04), at + Vec2(0, 0.4)}, color);
    canvas.circle(at + Vec2(-0.08, 0), 0.07, Color::hex(0xffe0b8));
}

const Color iron = Color::hex(0x3d3547);

void drawPost(Canvas& canvas, const Vec2& cell) {
    const Vec2 foot = cell - Vec2(0, 0.5);
    canvas.rect(foot + Vec2(-0.25, 0), {0.5, 0.14}, iron, 0.05);
    canvas.line(foot, foot + Vec2(0, 1.2), iron, 0.11);
}

void drawLantern(Canvas& canvas, const Vec2& cell, bool lit, double time) {
    const Vec2 head = cell + Vec2(0, 1);
    if (lit) glow(canvas, head, 2.2, Color::hex(0xffb84d), 0.5 + 0.05 * std::sin(7 * time));
    canvas.box(head, {0.27, 0.3}, iron, 0.08);
    canvas.box(head, {0.19, 0.22}, lit ? Color::hex(0xffd98a) : Color::hex(0x6f6880), 0.05);
    canvas.polygon({head + Vec2(-0.34, 0.28), head + Vec2(0.34, 0.28), head + Vec2(0, 0.52)}, iron);
    if (lit) drawFlame(canvas, head - Vec2(0, 0.2), 0.42, 0, time);
}

void drawTower(Canvas& canvas, const Vec2& cell) {
    const Vec2 foot = cell - Vec2(0, 0.5);
    const Color stone = Color::hex(0xe9dfd0), shade = Color::hex(0xb79f98);
    canvas.polygon({foot + Vec2(-0.8, 0), foot + Vec2(0.8, 0), foot + Vec2(0.5, 2.2), foot + Vec2(-0.5, 2.2)}, stone);
    canvas.polygon({foot + Vec2(0.15, 0), foot + Vec2(0.8, 0), foot + Vec2(0.5, 2.2), foot + Vec2(0.1, 2.2)}, shade);
    canvas.polygon({foot + Vec2(-0.67, 0.95), foot + Vec2(0.67, 0.95), foot + Vec2(0.6, 1.45), foot + Vec2(-0.6, 1.45)},
                   Color::hex(0xc4584a));
    canvas.rect(foot + Vec2(-0.22, 0), {0.44, 0.6}, Color::hex(0x4a3b52), 0.18);
    canvas.rect(foot + Vec2(-0.7, 2.18), {1.4, 0.18}, Color::hex(0x4a3b52), 0.05);
}

/// The top of the tower.
void drawBeacon(Canvas& canvas, const Vec2& cell, bool lit, double time) {
    const Vec2 head = cell + Vec2(0, 2.35);
    if (lit) glow(canvas, head, 7, Color::hex(0xffc860), 0.75);
    canvas.box(head, {0.42, 0.5}, Color::hex(0x4a3b52), 0.06);
    canvas.box(head, {0.32, 0.42}, lit ? Color::hex(0xfff0b0) : Color::hex(0x8d86a0), 0.05);
    canvas.polygon({head + Vec2(-0.6, 0.48), head + Vec2(0.6, 0.48), head + Vec2(0, 1.0)}, Color::hex(0xc4584a));
    if (lit) {
        drawFlame(canvas, head - Vec2(0, 0.36), 0.75, 0, time);
    } else {
        const double hop = 0.12 * std::fabs(std::sin(3 * time));
        canvas.polygon({head + Vec2(-0.2, 1.65 + hop), head + Vec2(0.2, 1.65 + hop), head + Vec2(0, 1.35 + hop)},
                       Color::hex(0xffd24a));
    }
}

void drawSpring(Canvas& canvas, const Spring& spring, const Palette& palette) {
    const double t = spring.ticksSince;
    const double tall = t < 40 ? 0.42 + 0.32 * std::exp(-t * 0.1) * std::sin(t * 0.7) : 0.42;
    std::vector<Vec2> coil;
    for (int i = 0; i <= 6; ++i)
        coil.push_back(spring.at +
                       Vec2(i == 0 || i == 6 ? 0 : (i % 2 == 0 ? 0.26 : -0.26), 0.06 + (tall - 0.06) * i / 6));
    canvas.rect(spring.at + Vec2(-0.42, 0), {0.84, 0.12}, darker(palette.metal, 0.3), 0.04);
    canvas.polyline(std::move(coil), lighter(palette.metal, 0.5), 0.09);
    canvas.rect(spring.at + Vec2(-0.46, tall - 0.04), {0.92, 0.18}, Color::hex(0xe4574f), 0.08);
    canvas.rect(spring.at + Vec2(-0.38, tall + 0.07), {0.76, 0.04}, Color::hex(0xffa08c), 0.02);
}

}  // namespace

void drawFlame(Canvas& canvas, const Vec2& foot, double size, double lean, double time) {
    const auto tongue = [&](double share, const Color& color, double phase) {
        const double tall = size * share * (1 + 0.1 * std::sin(17 * time + phase)), half = 0.3 * size * share;
        const double aside = -lean * tall * 0.9 + 0.06 * size * std::sin(13 * time + phase);
        std::vector<Vec2> outline;
        for (int i = 0; i <= 10; ++i) {
            const double angle = 3.14159265 + i * 0.314159265;
            outline.push_back(foot + Vec2(half * std::cos(angle), half * 0.9 + half * 0.9 * std::sin(angle)));
        }
        outline.push_back(foot + Vec2(half * 0.8 + aside * 0.35, half + 0.35 * tall));
        outline.push_back(foot + Vec2(aside, tall + half * 0.4));
        outline.push_back(foot + Vec2(-half * 0.8 + aside * 0.35, half + 0.3 * tall));
        canvas.polygon(std::move(outline), color);
    };
    tongue(1, Color::hex(0xff7a2e), 0);
    tongue(0.68, Color::hex(0xffb83f), 1);
    tongue(0.38, Color::hex(0xfff3c4), 2);
}

void drawPlaces(Canvas& canvas, const Scene& scene) {
    for (const Lantern& lantern : scene.stage.lanterns()) {
        if (!isSeen(canvas, lantern.at)) continue;
        drawPost(canvas, lantern.at);
        drawLantern(canvas, lantern.at, lantern.lit, scene.time);
    }
    const Vec2 beacon = scene.stage.level().beacon;
    if (isSeen(canvas, beacon, 6)) {
        drawTower(canvas, beacon);
        drawBeacon(canvas, beacon, scene.stage.isFinished(), scene.time);
    }
    for (const Spring& spring : scene.stage.springs())
        if (isSeen(canvas, spring.at)) drawSpring(canvas, spring, scene.palette);
}

void drawLifts(Canvas& canvas, const Scene& scene) {
    const Palette& palette = scene.palette;
    for (const Lift& lift : scene.stage.lifts()) {
        const Vec2 at = scene.at(lift.body), half(lift.width / 2, platformHalf);
        const MotionPath& path = lift.path.def().path;
        if (!isSeen(canvas, at, 12)) continue;
        for (double along = 0; along <= path.length(); along += 0.5)
            canvas.circle(path.at(along).position, 0.045, Color::hex(0xffffff).faded(0.35));
        canvas.box(at - Vec2(0, 0.12), half, darker(palette.metal, 0.35), 0.12);
        canvas.box(at, half, palette.metal, 0.12);
        canvas.rect(at + Vec2(-half.x() + 0.06, 0.1), {2 * half.x() - 0.12, 0.07}, lighter(palette.metal, 0.55), 0.03);
        for (const double side : {-1.0, 1.0})
            canvas.circle(at + Vec2(side * (half.x() - 0.25), -0.02), 0.07, Color::hex(0xffd24a));
    }
}

void drawCrates(Canvas& canvas, const Scene& scene) {
    const Color wood = scene.palette.wood;
    for (const Crate& crate : scene.stage.crates()) {
        const Transform pose = scene.trail.pose(scene.stage.world(), crate.body, scene.between);
        if (!isSeen(canvas, pose.position)) continue;
        const auto place = canvas.place({.position = pose.position, .angle = pose.rotation.angle()});
        canvas.box({0, 0}, {crateHalf, crateHalf}, darker(wood, 0.4), 0.06);
        canvas.box({0, 0}, {crateHalf - 0.1, crateHalf - 0.1}, wood);
        canvas.line({-0.34, -0.34}, {0.34, 0.34}, darker(wood, 0.25), 0.12);
        canvas.box({0, 0}, {crateHalf - 0.05, crateHalf - 0.05}, stroke(lighter(wood, 0.15), 0.1), 0.03);
        for (const double x : {-0.43, 0.43})
            for (const double y : {-0.43, 0.43}) canvas.circle({x, y}, 0.03, darker(wood, 0.55));
    }
}

void drawTreasures(Canvas& canvas, const Scene& scene) {
    for (const Treasure& treasure : scene.stage.treasures()) {
        if (treasure.taken || !isSeen(canvas, treasure.at)) continue;
        const Vec2 at = treasure.at + Vec2(0, 0.06 * std::sin(2.5 * scene.time + treasure.at.x()));
        if (treasure.kind == ThingKind::Coin)
            drawCoin(canvas, treasure.at, 3 * scene.time + 0.35 * treasure.at.x(), scene.palette.coin);
        if (treasure.kind == ThingKind::Sun) drawSun(canvas, at, scene.time, scene.palette.coin);
        if (treasure.kind == ThingKind::Oil) drawOil(canvas, at);
    }
}

void drawLights(Canvas& canvas, const Scene& scene) {
    if (scene.palette.dark <= 0) return;
    drawLamps(canvas, scene);
    for (const Lantern& lantern : scene.stage.lanterns())
        if (lantern.lit && isSeen(canvas, lantern.at)) drawLantern(canvas, lantern.at, true, scene.time);
    const Vec2 beacon = scene.stage.level().beacon;
    if (!scene.stage.isFinished() && isSeen(canvas, beacon, 6)) drawBeacon(canvas, beacon, false, scene.time);
    drawTreasures(canvas, scene);
}

}  // namespace plumb::games::runner
