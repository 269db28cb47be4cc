// SPDX-License-Identifier: MIT

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <games/maze/art/palette.h>
#include <games/maze/art/scene.h>
#include <games/maze/maze_game.h>

namespace plumb::games::maze {
namespace {

/// The share of these ticks that has passed; 1 or more when the effect is over.
double shareOf(const Trace& trace, int ticks) {
    return static_cast<double>(trace.age) / ticks;
}

/// Calls draw for this many directions around a circle, turned by an angle.
template <typename Draw>
void around(int count, double turned, const Draw& draw) {
    for (int i = 0; i < count; ++i) {
        const double angle = turned + 2 * std::numbers::pi * i / count;
        draw(Vec2(std::cos(angle), std::sin(angle)));
    }
}

void drawBits(Canvas& canvas, const Trace& trace) {
    const double share = shareOf(trace, 14);
    if (share >= 1) return;
    const Vec2 at = trace.event.position;
    around(3, at.x() + 2 * at.y(), [&](const Vec2& out) {
        const Vec2 fall(0, -0.5 * share * share);
        canvas.circle(at + (0.2 + 0.55 * share) * out + fall, 0.09 * (1 - share), crumb.faded(1 - share));
    });
}

void drawRing(Canvas& canvas, const Trace& trace, const Color& color, double reach) {
    const double share = shareOf(trace, 28);
    if (share >= 1) return;
    const double slower = 1 - (1 - share) * (1 - share);
    canvas.circle(trace.event.position, 0.4 + reach * slower, stroke(color.faded(1 - share), 0.3 * (1 - share) + 0.05));
}

void drawStars(Canvas& canvas, const Trace& trace, const Color& color) {
    const double share = shareOf(trace, 32);
    if (share >= 1) return;
    around(8, 0.4, [&](const Vec2& out) {
        const Vec2 at = trace.event.position + (0.7 + 1.6 * std::sqrt(share)) * out;
        canvas.line(at, at + 0.45 * (1 - share) * out, color.faded(1 - share), 0.16);
    });
}

/// Above the place, where the mouse does not hide them. More points are drawn larger.
void drawPoints(Canvas& canvas, const Trace& trace) {
    const int points = trace.event.points;
    const double pop = 1 + 0.4 * std::max(0.0, 1 - trace.age / 8.0);
    const double fade = std::min(1.0, (Trace::longest - trace.age) / 15.0);
    const Vec2 at = trace.event.position + Vec2(0, 1.4 + 0.6 * shareOf(trace, Trace::longest));
    const double size = (points >= 1600 ? 2.0 : points >= 800 ? 1.75 : 1.5) * pop;
    drawLettering(canvas, std::to_string(points), at, (points >= 800 ? cheese : paper).faded(fade), size);
}

}  // namespace

void drawTrace(Canvas& canvas, const Trace& trace) {
    switch (trace.event.kind) {
        case Happening::Dot: return drawBits(canvas, trace);
        case Happening::Power: return drawRing(canvas, trace, cheese, 5);
        case Happening::HunterCaught:
            drawRing(canvas, trace, scaredLight, 2);
            drawStars(canvas, trace, cheese);
            return drawPoints(canvas, trace);
        case Happening::Fruit: drawStars(canvas, trace, skin); return drawPoints(canvas, trace);
        case Happening::PlayerCaught: return drawRing(canvas, trace, skin, 3);
        default: break;
    }
}

void drawLettering(Canvas& canvas, const std::string& text, const Vec2& at, const Color& color, double size) {
    TextStyle style{.size = size,
                    .color = night.faded(color.alpha),
                    .align = Align::Center,
                    .baseline = Baseline::Middle,
                    .weight = Weight::Heavy};
    const double edge = 0.07 * size;
    for (const double x : {-edge, edge})
        for (const double y : {-edge, edge}) canvas.text(at + Vec2(x, y), text, style);
    style.color = color;
    canvas.text(at, text, style);
}

}  // namespace plumb::games::maze
