// SPDX-License-Identifier: MIT
#include <games/artillery/draw.h>
#include <plumb/math/trig.h>

namespace plumb::games::artillery {
namespace {

constexpr Color wood = Color::hex(0xd29a55), darkWood = Color::hex(0x8a5a33), stone = Color::hex(0xb9b3b8),
                darkStone = Color::hex(0x7d7686), ironGrey = Color::hex(0x3b3547), powder = Color::hex(0xb8402f);
constexpr double line = 0.09;  ///< [m]

void drawCrate(Canvas& canvas, const Vec2& half) {
    canvas.box({0, 0}, half, wood, 0.06);
    canvas.line({-half.x() + 0.2, -half.y() + 0.2}, {half.x() - 0.2, half.y() - 0.2}, darkWood, 0.14);
    canvas.box({0, 0}, half - Vec2(0.1, 0.1), stroke(darkWood, 0.13), 0.03);
    canvas.line({-half.x() + 0.06, half.y() - 0.06}, {half.x() - 0.06, half.y() - 0.06}, lighter(wood, 0.35), 0.08);
    canvas.box({0, 0}, half - Vec2(line / 2, line / 2), stroke(ink, line), 0.06);
}

void drawPillar(Canvas& canvas, const Vec2& half) {
    canvas.box({0, 0}, half, stone, 0.05);
    canvas.rect({0.04, -half.y()}, {half.x() - 0.04, 2 * half.y()}, darkStone);
    for (const double y : {-0.5, 0.0, 0.5}) canvas.line({-half.x(), y}, {half.x(), y}, ink.faded(0.5), 0.05);
    canvas.box({0, 0}, half - Vec2(line / 2, line / 2), stroke(ink, line), 0.05);
}

void drawPlank(Canvas& canvas, const Vec2& half) {
    canvas.box({0, 0}, half, wood, 0.05);
    canvas.line({-half.x() + 0.1, -0.04}, {half.x() - 0.1, -0.04}, darkWood, 0.06);
    for (const double side : {-1.0, 1.0}) canvas.circle({side * (half.x() - 0.3), 0.03}, 0.06, ironGrey);
    canvas.box({0, 0}, half - Vec2(line / 2, line / 2), stroke(ink, line), 0.05);
}

void drawKeg(Canvas& canvas, const Vec2& half, int fuse) {
    const bool lit = fuse >= 0 && fuse % 6 < 3;
    canvas.box({0, 0}, half, lit ? gold : powder, 0.16);
    canvas.rect({-half.x() + 0.1, -half.y() + 0.12}, {0.13, 2 * half.y() - 0.24}, lighter(powder, 0.3), 0.06);
    for (const double y : {-0.24, 0.24}) canvas.line({-half.x(), y}, {half.x(), y}, ironGrey, 0.11);
    canvas.polygon({{0, 0.17}, {0.13, -0.04}, {0, -0.17}, {-0.13, -0.04}}, gold);
    canvas.box({0, 0}, half - Vec2(line / 2, line / 2), stroke(ink, line), 0.16);
}

void drawHat(Canvas& canvas, int crew) {
    canvas.rect({-0.42, -0.12}, {0.84, 0.16}, ink, 0.08);
    canvas.rect({-0.26, -0.04}, {0.52, 0.3}, crewColor(crew), 0.1);
}

}  // namespace

void drawProps(Canvas& canvas, const Figures& figures) {
    for (const Prop& prop : figures.battle.props()) {
        const Transform pose = figures.trail.pose(figures.battle.world(), prop.body, canvas.between());
        const auto there = canvas.place({.position = pose.position, .angle = pose.rotation.angle()});
        const Vec2& half = formOf(prop.kind).halfSize;
        switch (prop.kind) {
            case PieceKind::Crate: drawCrate(canvas, half); break;
            case PieceKind::Pillar: drawPillar(canvas, half); break;
            case PieceKind::Plank:
            case PieceKind::Lintel: drawPlank(canvas, half); break;
            case PieceKind::Keg: drawKeg(canvas, half, prop.fuse); break;
            case PieceKind::Hat: drawHat(canvas, prop.crew); break;
        }
    }
}

void drawShell(Canvas& canvas, const Figures& figures) {
    const auto& shell = figures.battle.shell();
    if (!shell) return;
    const Transform pose = figures.trail.pose(figures.battle.world(), shell->body, canvas.between());
    const Vec2 velocity = figures.battle.world().body(shell->body).velocity();
    const double size = shell->weapon == 2 ? 0.42 : 0.28;
    canvas.line(pose.position, pose.position - velocity * 0.035, gold.faded(0.5), size);
    if (shell->weapon == 1) {
        canvas.circle(pose.position, 0.32, Color::hex(0x3f8f4f));
        const Vec2 spot = pose.rotation * Vec2(0.14, 0.1);
        canvas.circle(pose.position + spot, 0.09, paper);
        const bool blink = shell->age % 20 < 10;
        canvas.circle(pose.position, 0.32, stroke(blink ? gold : ink, 0.09));
        return;
    }
    const double angle = arcTangent(velocity.y(), velocity.x());
    const auto there = canvas.place({.position = pose.position, .angle = angle});
    canvas.capsule({-size * 0.7, 0}, {size * 0.5, 0}, size, ink);
    canvas.capsule({-size * 0.7, 0}, {size * 0.4, 0}, size * 0.7, shell->weapon == 2 ? gold : stone);
    canvas.circle({size * 0.6, 0}, size * 0.5, powder);
}

}  // namespace plumb::games::artillery
