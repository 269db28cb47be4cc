// SPDX-License-Identifier: MIT
#include <games/maze/art/figures.h>

#include <array>
#include <numbers>

#include <games/maze/art/palette.h>

namespace plumb::games::maze {
namespace {

constexpr Color leafGreen = Color::hex(0x7ccf6b);
constexpr Color bark = Color::hex(0x7a4a2a);

void blueberry(Canvas& canvas) {
    canvas.circle({-0.3, -0.15}, 0.42, Color::hex(0x4b5fd6));
    canvas.circle({0.28, -0.22}, 0.42, Color::hex(0x6a7ff0));
    canvas.circle({0.2, -0.1}, 0.12, Color::hex(0xc3ccff));
    canvas.ellipse({0.1, 0.45}, {0.45, 0.18}, leafGreen);
}
void hazelnut(Canvas& canvas) {
    canvas.ellipse({0, -0.12}, {0.55, 0.58}, Color::hex(0xb9752f));
    canvas.ellipse({-0.18, -0.05}, {0.14, 0.3}, Color::hex(0xdc9d55));
    canvas.pie({0, 0.1}, 0.6, 0, std::numbers::pi, leafGreen);
    canvas.line({0, 0.6}, {0.1, 0.8}, bark, 0.12);
}
void mushroom(Canvas& canvas) {
    canvas.box({0, -0.38}, {0.24, 0.38}, paper, 0.15);
    canvas.pie({0, -0.12}, 0.75, 0, std::numbers::pi, Color::hex(0xe5484d));
    for (const Vec2& at : {Vec2(-0.35, 0.12), Vec2(0.05, 0.35), Vec2(0.4, 0.1)}) canvas.circle(at, 0.11, paper);
}
void pear(Canvas& canvas) {
    canvas.circle({0, -0.25}, 0.52, Color::hex(0xc6d94b));
    canvas.ellipse({0, 0.2}, {0.32, 0.42}, Color::hex(0xc6d94b));
    canvas.ellipse({-0.2, -0.2}, {0.12, 0.22}, Color::hex(0xe9f39a));
    canvas.line({0, 0.55}, {0.08, 0.85}, bark, 0.12);
    canvas.ellipse({0.32, 0.68}, {0.26, 0.12}, leafGreen);
}
void honey(Canvas& canvas) {
    canvas.box({0, -0.15}, {0.6, 0.55}, Color::hex(0xd98a2b), 0.25);
    canvas.box({0, 0.42}, {0.48, 0.14}, paper, 0.1);
    canvas.box({0, -0.15}, {0.42, 0.22}, Color::hex(0xffe08a), 0.1);
    canvas.polygon({{-0.4, 0.34}, {-0.1, 0.34}, {-0.16, 0.02}, {-0.3, 0.1}}, cheese);
}
void cake(Canvas& canvas) {
    canvas.polygon({{-0.7, -0.5}, {0.7, -0.5}, {0.7, 0.15}, {-0.7, -0.05}}, Color::hex(0xe9b872));
    canvas.polygon({{-0.7, -0.05}, {0.7, 0.15}, {0.55, 0.42}, {-0.5, 0.25}}, skin);
    canvas.line({-0.7, -0.28}, {0.7, -0.2}, Color::hex(0xd6457a), 0.12);
    canvas.circle({0.1, 0.52}, 0.19, Color::hex(0xe5484d));
}
void fishBone(Canvas& canvas) {
    canvas.line({-0.6, 0}, {0.45, 0}, paper, 0.12);
    for (const double x : {-0.3, 0.0, 0.28}) canvas.line({x - 0.1, 0.36}, {x - 0.1, -0.36}, paper, 0.12);
    canvas.polygon({{0.35, 0.36}, {0.8, 0}, {0.35, -0.36}}, paper);
    canvas.circle({0.5, 0.06}, 0.08, ink);
    canvas.polygon({{-0.5, 0}, {-0.82, 0.34}, {-0.82, -0.34}}, paper);
}
void bell(Canvas& canvas) {
    canvas.circle({0, 0.68}, 0.14, stroke(cheese, 0.1));
    canvas.pie({0, 0.02}, 0.52, 0, std::numbers::pi, cheese);
    canvas.polygon({{-0.52, 0.04}, {0.52, 0.04}, {0.72, -0.42}, {-0.72, -0.42}}, cheese);
    canvas.capsule({-0.68, -0.42}, {0.68, -0.42}, 0.1, Color::hex(0xd98a2b));
    canvas.circle({0, -0.6}, 0.17, Color::hex(0xd98a2b));
    canvas.ellipse({-0.22, 0.1}, {0.1, 0.26}, Color::hex(0xfff2b8));
}

}  // namespace

void drawCrumb(Canvas& canvas, const Vec2& at) {
    canvas.circle(at, 0.15, crumb);
}

void drawCheese(Canvas& canvas, const Vec2& at, double pulse) {
    const double halo = 0.85 + 0.35 * pulse;
    canvas.circle(at, halo, Paint::radial(at, cheese.faded(0.45), halo, cheese.faded(0)));
    const Canvas::Scope scope = canvas.place({.position = at, .scale = Vec2(1, 1) * (0.9 + 0.12 * pulse)});
    canvas.polygon({{-0.5, -0.34}, {0.5, -0.34}, {0.5, 0.06}, {-0.42, -0.02}}, cheese);
    canvas.polygon({{-0.46, 0}, {0.5, 0.08}, {0.2, 0.4}}, lighter(cheese, 0.45));
    canvas.circle({-0.16, -0.18}, 0.09, Color::hex(0xd99a1e));
    canvas.circle({0.24, -0.12}, 0.11, Color::hex(0xd99a1e));
}

void drawFruit(Canvas& canvas, int kind) {
    constexpr std::array draws{blueberry, hazelnut, mushroom, pear, honey, cake, fishBone, bell};
    draws[static_cast<std::size_t>(kind)](canvas);
}

}  // namespace plumb::games::maze
