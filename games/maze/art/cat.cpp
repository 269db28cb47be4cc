// SPDX-License-Identifier: MIT
#include <games/maze/art/figures.h>

#include <cmath>
#include <numbers>

#include <games/maze/art/palette.h>

namespace plumb::games::maze {
namespace {

constexpr std::array<double, 2> sides{-1, 1};

struct Coat {
    Color fur, dark;
};

Coat coatOf(Who who, Mood mood) {
    if (mood == Mood::Frightened) return {scared, darker(scared, 0.4)};
    if (mood == Mood::Flashes) return {scaredLight, Color::hex(0xb9c2f0)};
    return {lookOf(who).fur, lookOf(who).dark};
}

bool isScared(Mood mood) {
    return mood == Mood::Frightened || mood == Mood::Flashes;
}

/// Behind the cat, on the side that it does not look to.
void drawTail(Canvas& canvas, const Coat& coat, const CatPose& pose) {
    const double side = pose.looks == Direction::Right ? -1 : 1;
    std::vector<Vec2> tail;
    for (int i = 0; i <= 6; ++i) {
        const double out = i / 6.0;
        tail.emplace_back(side * (0.5 + 0.5 * out), -0.45 + 0.8 * out * out + 0.14 * out * std::sin(3 * pose.stride));
    }
    canvas.polyline(tail, coat.dark, 0.2);
}

void drawPaws(Canvas& canvas, const Coat& coat, double stride) {
    for (const double side : sides) {
        const double lift = 0.09 * std::max(0.0, std::sin(6 * stride) * side);
        canvas.ellipse({0.34 * side, -0.7 + lift}, {0.24, 0.16}, coat.dark);
        canvas.ellipse({0.34 * side, -0.67 + lift}, {0.2, 0.13}, coat.fur);
    }
}

void drawEars(Canvas& canvas, const Coat& coat, bool folded) {
    for (const double side : sides) {
        const Vec2 tip = folded ? Vec2(0.98 * side, 0.3) : Vec2(0.62 * side, 0.98);
        canvas.polygon({{0.7 * side, 0.2}, {0.18 * side, 0.62}, tip}, coat.fur);
        const Vec2 middle = (Vec2(0.7 * side, 0.2) + Vec2(0.18 * side, 0.62) + tip) / 3;
        canvas.polygon({middle + 0.5 * (Vec2(0.7 * side, 0.2) - middle),
                        middle + 0.5 * (Vec2(0.18 * side, 0.62) - middle), middle + 0.6 * (tip - middle)},
                       coat.dark);
    }
}

void drawStripes(Canvas& canvas, const Coat& coat) {
    for (const double x : {-0.16, 0.0, 0.16}) canvas.line({x, 0.62}, {x * 0.8, 0.42}, coat.dark, 0.08);
    for (const double side : sides)
        for (const double y : {-0.12, -0.3}) canvas.line({0.7 * side, y}, {0.52 * side, y + 0.02}, coat.dark, 0.07);
}

/// White, with slit pupils on the side that it looks to.
void drawEyes(Canvas& canvas, const CatPose& pose) {
    const Vec2 look = 0.1 * unitOf(pose.looks);
    for (const double side : sides) {
        const Vec2 at(0.3 * side, 0.12);
        canvas.ellipse(at, {0.25, 0.27}, paper);
        canvas.ellipse(at + look, {0.12, 0.17}, ink);
        canvas.circle(at + look + Vec2(0.05, 0.07), 0.045, paper);
    }
}

void drawBrows(Canvas& canvas, const Coat& coat, Mood mood) {
    for (const double side : sides) {
        if (mood == Mood::Rests) {  // half-closed lids
            canvas.pie({0.3 * side, 0.13}, 0.29, 0, std::numbers::pi, coat.fur);
            canvas.line({0.06 * side, 0.13}, {0.54 * side, 0.13}, coat.dark, 0.08);
        } else {
            const double slope = mood == Mood::Hastes ? 0.26 : 0.14;
            canvas.line({0.06 * side, 0.34 - slope * 0.6}, {0.56 * side, 0.34 + slope * 0.6}, coat.dark, 0.13);
        }
    }
}

void drawMouth(Canvas& canvas, const Coat& coat, Mood mood) {
    canvas.polygon({{-0.1, -0.17}, {0.1, -0.17}, {0, -0.28}}, ink);
    for (const double side : sides) {
        canvas.polyline({{0, -0.28}, {0.1 * side, -0.38}, {0.25 * side, -0.34}}, ink, 0.06);
        canvas.line({0.45 * side, -0.24}, {0.98 * side, -0.18}, lighter(coat.fur, 0.5).faded(0.8), 0.04);
        canvas.line({0.45 * side, -0.32}, {0.95 * side, -0.38}, lighter(coat.fur, 0.5).faded(0.8), 0.04);
        if (mood == Mood::Hastes)
            canvas.polygon({{0.08 * side, -0.38}, {0.18 * side, -0.37}, {0.13 * side, -0.52}}, paper);
    }
}

void drawScaredFace(Canvas& canvas, Mood mood, double stride) {
    const Color line = mood == Mood::Flashes ? Color::hex(0xd8344f) : scaredLight;
    const double shiver = 0.03 * std::sin(9 * stride);
    for (const double side : sides) {
        canvas.circle({0.3 * side + shiver, 0.14}, 0.21, mood == Mood::Flashes ? ink : paper);
        canvas.circle({0.3 * side + shiver, 0.14}, 0.08, mood == Mood::Flashes ? paper : ink);
    }
    std::vector<Vec2> mouth;
    for (int i = 0; i <= 6; ++i) mouth.emplace_back(-0.36 + 0.12 * i, -0.3 + (i % 2 == 0 ? -0.07 : 0.07));
    canvas.polyline(mouth, line, 0.08);
}

}  // namespace

void drawCat(Canvas& canvas, Who who, const CatPose& pose) {
    if (pose.mood == Mood::Eyes) return drawEyes(canvas, pose);
    const Coat coat = coatOf(who, pose.mood);
    drawTail(canvas, coat, pose);
    drawPaws(canvas, coat, pose.stride);
    drawEars(canvas, coat, isScared(pose.mood));
    canvas.ellipse({0, -0.02}, {0.82, 0.7}, coat.fur);
    drawStripes(canvas, coat);
    if (isScared(pose.mood)) return drawScaredFace(canvas, pose.mood, pose.stride);
    canvas.ellipse({0, -0.32}, {0.34, 0.22}, lighter(coat.fur, 0.45));
    drawEyes(canvas, pose);
    drawBrows(canvas, coat, pose.mood);
    drawMouth(canvas, coat, pose.mood);
}

}  // namespace plumb::games::maze
