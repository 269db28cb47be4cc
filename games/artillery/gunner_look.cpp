// SPDX-License-Identifier: MIT
#include <games/artillery/draw.h>

#include <algorithm>
#include <cmath>

#include <plumb/math/trig.h>

namespace plumb::games::artillery {
namespace {

constexpr Color iron = Color::hex(0x4a4658), shine = Color::hex(0x8e8aa0);

/// A tricorne for crew 0, a sailor's cap for crew 1; for a head of radius 1 that looks to the right.
void drawCap(Canvas& canvas, int crew) {
    if (crew == 0) {
        canvas.polygon({{-1.45, 0.35}, {-0.7, 1.35}, {0.5, 1.3}, {1.45, 0.45}, {0, 0.2}}, ink);
        canvas.polygon({{-1.15, 0.48}, {-0.6, 1.15}, {0.4, 1.1}, {1.1, 0.55}, {0, 0.38}}, darker(crewColor(0), 0.12));
        canvas.polyline({{-1.25, 0.42}, {0, 0.3}, {1.25, 0.5}}, gold, 0.16);
        return;
    }
    canvas.rect({-1.15, 0.75}, {2.1, 0.75}, ink, 0.35);
    canvas.rect({-1, 0.85}, {1.8, 0.5}, paper, 0.25);
    canvas.rect({-1.05, 0.35}, {2.1, 0.55}, ink, 0.15);
    canvas.rect({-0.95, 0.45}, {1.9, 0.3}, crewColor(1), 0.1);
}

void drawBarrel(Canvas& canvas, const Vec2& direction, double recoil) {
    const Vec2 back = Vec2(0, 0.15) - direction * (0.3 * recoil), front = back + 1.2 * direction;
    canvas.line(back - direction * 0.2, front, ink, 0.56);
    canvas.line(back - direction * 0.2, front, iron, 0.38);
    canvas.line(back + perp(direction) * 0.08, front + perp(direction) * 0.08, shine, 0.08);
    canvas.line(front - perp(direction) * 0.24, front + perp(direction) * 0.24, ink, 0.3);
    canvas.line(front - perp(direction) * 0.2, front + perp(direction) * 0.2, gold, 0.14);
}

/// Looks to the right; the caller mirrors it. The barrel is not mirrored, so it is drawn later.
void drawTrunk(Canvas& canvas, const Gunner& gunner, double stride) {
    const Color& color = crewColor(gunner.crew);
    for (const double side : {-1.0, 1.0}) {
        const Vec2 foot(side * 0.22 + side * 0.16 * stride, -0.82 + 0.1 * std::max(0.0, side * stride));
        canvas.line({side * 0.18, -0.45}, foot, ink, 0.3);
        canvas.line(foot, foot + Vec2(0.14, 0), ink, 0.24);
    }
    canvas.rect({-0.52, -0.66}, {1.04, 1.02}, ink, 0.36);
    canvas.rect({-0.44, -0.58}, {0.88, 0.86}, color, 0.3);
    canvas.rect({-0.44, -0.36}, {0.88, 0.18}, darker(color, 0.45));
    canvas.rect({-0.08, -0.38}, {0.24, 0.22}, gold, 0.04);
}

/// Gunners look at a flying shell, otherwise along the barrel.
Vec2 gazeOf(const Figures& figures, const Gunner& gunner, const Vec2& at) {
    const auto& shell = figures.battle.shell();
    if (!shell) return directionOf(gunner.aim);
    const Vec2 way = figures.battle.world().body(shell->body).position() - at;
    return way.norm() > 0.5 ? Vec2(way.normalized()) : directionOf(gunner.aim);
}

/// Height above the ground: the winners hop [m].
double hopOf(const Figures& figures, const Gunner& gunner) {
    if (figures.battle.phase() != Phase::Over || figures.battle.winner() != gunner.crew) return 0;
    return 0.7 * std::abs(sinCos(figures.seconds * 6 + gunner.body.index).sin);
}

/// Leans back during charge and recoil; leans over when about to die [rad].
double leanOf(const Figures& figures, const Gunner& gunner, bool active) {
    if (gunner.health == 0) return 0.5;
    if (!active) return 0;
    const double charge = figures.battle.charging() ? double(gunner.aim.charge) / fullCharge : 0;
    const double tremble = 0.03 * charge * sinCos(figures.seconds * 50).sin;
    return gunner.aim.facing * (0.14 * charge + 0.3 * figures.recoil + tremble);
}

/// The glow of the charge at the muzzle.
void drawGlow(Canvas& canvas, const Gunner& gunner, double seconds) {
    const Vec2 muzzle = muzzleFrom(directionOf(gunner.aim));
    const double charge = double(gunner.aim.charge) / fullCharge;
    const double radius = (0.3 + 0.9 * charge) * (1 + 0.12 * sinCos(seconds * 40).sin);
    canvas.circle(muzzle, radius, Paint::radial(muzzle, gold.faded(0.9), radius, gold.faded(0)));
}

void drawBody(Canvas& canvas, const Figures& figures, const Gunner& gunner, bool active) {
    const Transform pose = figures.trail.pose(figures.battle.world(), gunner.body, canvas.between());
    const double speed = std::abs(figures.battle.world().body(gunner.body).velocity().x());
    const double stride = speed > 0.3 ? sinCos(pose.position.x() * 5).sin : 0;
    const double breath = 0.02 * sinCos(figures.seconds * 3 + gunner.crew + gunner.body.index).sin;
    const Vec2 hop(0, hopOf(figures, gunner));
    const auto there = canvas.place({.position = pose.position + hop, .angle = leanOf(figures, gunner, active)});
    {
        const auto mirrored = canvas.place({.scale = {double(gunner.aim.facing), 1}});
        drawTrunk(canvas, gunner, stride);
    }
    if (active && figures.battle.charging()) drawGlow(canvas, gunner, figures.seconds);
    drawBarrel(canvas, directionOf(gunner.aim), active ? figures.recoil : 0);
    const Vec2 head(-0.2 * gunner.aim.facing, 0.6 + breath);
    drawHead(canvas, head, 0.46, gunner.crew, gazeOf(figures, gunner, pose.position));
}

void drawHealth(Canvas& canvas, const Vec2& at, const Gunner& gunner) {
    const double full = 0.85, share = double(gunner.health) / fullHealth;
    canvas.box(at, {full + 0.1, 0.24}, ink.faded(0.85), 0.2);
    if (share > 0)
        canvas.rect(at - Vec2(full, 0.14), {2 * full * share, 0.28}, lighter(crewColor(gunner.crew), 0.12), 0.1);
}

}  // namespace

void drawHead(Canvas& canvas, const Vec2& at, double radius, int crew, const Vec2& gaze) {
    const double side = gaze.x() < 0 ? -1 : 1;
    const auto there = canvas.place({.position = at, .scale = {side * radius, radius}});
    canvas.circle({0, 0}, 1.16, ink);
    canvas.circle({0, 0}, 1, skin);
    canvas.circle({-0.35, -0.3}, 0.22, Color::hex(0xf3a08a));
    const Vec2 look(0.13 * side * gaze.x(), 0.13 * gaze.y());
    for (const double eye : {0.18, 0.68}) {
        canvas.ellipse({eye, 0.08}, {0.22, 0.28}, paper);
        canvas.circle(Vec2(eye, 0.08) + look, 0.13, ink);
    }
    canvas.arc({0.4, -0.32}, 0.26, 3.6, 5.8, stroke(ink, 0.12));
    drawCap(canvas, crew);
}

void drawGunners(Canvas& canvas, const Figures& figures) {
    const auto& gunners = figures.battle.gunners();
    for (std::size_t i = 0; i < gunners.size(); ++i)
        if (gunners[i].alive) drawBody(canvas, figures, gunners[i], static_cast<int>(i) == figures.battle.active());
}

void drawTags(Canvas& canvas, const Figures& figures) {
    const Battle& battle = figures.battle;
    for (const Gunner& gunner : battle.gunners()) {
        if (!gunner.alive) continue;
        const Vec2 at = figures.trail.pose(battle.world(), gunner.body, canvas.between()).position;
        drawHealth(canvas, at + Vec2(0, 1.85), gunner);
        const bool active =
            &gunner == &battle.gunner() && (battle.phase() == Phase::Ready || battle.phase() == Phase::Aim);
        if (!active || battle.charging()) continue;
        const Vec2 tip = at + Vec2(0, 2.4 + 0.25 * std::abs(sinCos(figures.seconds * 4).sin));
        canvas.polygon({tip + Vec2(0, -0.1), tip + Vec2(0.72, 0.9), tip + Vec2(-0.72, 0.9)}, ink);
        canvas.polygon({tip + Vec2(0, 0.12), tip + Vec2(0.5, 0.77), tip + Vec2(-0.5, 0.77)}, gold);
    }
}

}  // namespace plumb::games::artillery
