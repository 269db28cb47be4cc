// SPDX-License-Identifier: MIT
#include <games/maze/art/figures.h>

#include <cmath>
#include <numbers>

#include <games/maze/art/palette.h>

namespace plumb::games::maze {
namespace {

void drawTail(Canvas& canvas, double stride) {
    std::vector<Vec2> tail;
    for (int i = 0; i <= 8; ++i) {
        const double back = i / 8.0;
        tail.emplace_back(-0.6 - 0.85 * back, 0.24 * back * std::sin(5 * back - 2.2 * stride));
    }
    canvas.polyline(tail, skin, 0.13);
}

void drawFeet(Canvas& canvas, double stride) {
    for (const double side : {-1.0, 1.0})
        for (const double end : {-0.45, 0.35}) {
            const double swing = 0.16 * std::sin(7 * stride + (side * end > 0 ? 0 : std::numbers::pi));
            canvas.ellipse({end + swing, 0.5 * side}, {0.17, 0.11}, skin);
        }
}

void drawHead(Canvas& canvas, bool blinks) {
    for (const double side : {-1.0, 1.0}) {
        canvas.circle({0.14, 0.46 * side}, 0.31, furShade);
        canvas.circle({0.16, 0.46 * side}, 0.2, skin);
    }
    canvas.polygon({{0.1, 0.44}, {0.5, 0.36}, {0.84, 0.1}, {0.84, -0.1}, {0.5, -0.36}, {0.1, -0.44}}, fur);
    canvas.circle({0.3, 0}, 0.4, fur);
    canvas.circle({0.86, 0}, 0.13, skin);
    for (const double side : {-1.0, 1.0}) {
        canvas.line({0.7, 0.12 * side}, {0.62, 0.5 * side}, furShade, 0.05);
        if (blinks)
            canvas.line({0.42, 0.2 * side}, {0.56, 0.2 * side}, ink, 0.07);
        else
            canvas.circle({0.5, 0.2 * side}, 0.1, ink);
    }
}

}  // namespace

void drawMouse(Canvas& canvas, const MousePose& pose) {
    const double squash = pose.still ? 0 : 0.04 * std::sin(7 * pose.stride);
    const Canvas::Scope scope = canvas.place({.angle = pose.angle, .scale = {1 + squash, 1 - squash}});
    drawTail(canvas, pose.stride);
    drawFeet(canvas, pose.stride);
    canvas.ellipse({-0.16, 0}, {0.62, 0.53}, furShade);
    canvas.ellipse({-0.12, 0.02}, {0.56, 0.46}, fur);
    drawHead(canvas, pose.blinks);
}

void drawLostMouse(Canvas& canvas, double angle, double share) {
    const double spin = std::min(1.0, share / 0.7), burst = std::max(0.0, (share - 0.6) / 0.4);
    if (spin < 1) {
        const double size = 1 - spin * spin;
        const Canvas::Scope scope = canvas.place({.angle = 5 * std::numbers::pi * spin, .scale = {size, size}});
        drawMouse(canvas, {.angle = angle, .still = true, .blinks = true});
    }
    if (burst <= 0 || burst >= 1) return;
    for (int i = 0; i < 8; ++i) {
        const double at = i * std::numbers::pi / 4;
        const Vec2 out(std::cos(at), std::sin(at));
        canvas.line((0.3 + burst) * out, (0.5 + 1.1 * burst) * out, cheese.faded(1 - burst), 0.14);
    }
}

}  // namespace plumb::games::maze
