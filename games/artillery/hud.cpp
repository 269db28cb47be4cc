// SPDX-License-Identifier: MIT
#include <games/artillery/hud.h>

#include <algorithm>
#include <cmath>

#include <games/artillery/figures.h>
#include <games/frame/game.h>

namespace plumb::games::artillery {
namespace {

constexpr Color panel = ink.faded(0.72);
constexpr double middle = screenWidth / 2;

void write(Canvas& canvas, const Vec2& at, const std::string& text, double size, const Color& color,
           Align align = Align::Center, double fit = 0) {
    canvas.text(at, text, {size, color, align, Baseline::Middle, Weight::Bold, fit});
}

void drawPanel(Canvas& canvas, const Vec2& corner, const Vec2& size, double radius = 8) {
    canvas.rect(corner, size, panel, radius);
    canvas.rect(corner, size, stroke(paper.faded(0.18), 1), radius);
}

/// A crew's name and a bar for each of its gunners, at the left or the right edge.
void drawCrew(Canvas& canvas, const Hud& hud, int crew) {
    const double side = crew == 0 ? 1 : -1;
    const auto there = canvas.place({.position = {crew == 0 ? 8.0 : screenWidth - 8, 8}});
    const auto x = [side](double from, double width) { return side > 0 ? from : -from - width; };
    drawPanel(canvas, {x(0, 158), 0}, {158, 38}, 9);
    {
        const auto upright = canvas.place({.position = {side * 20, 22}, .scale = {1, -1}});
        drawHead(canvas, {0, 0}, 10, crew, {side, 0});
    }
    write(canvas, {side * 40, 11}, std::string(crewNames[crew == 0 ? 0 : 1]), 13, lighter(crewColor(crew), 0.3),
          crew == 0 ? Align::Left : Align::Right);
    const std::string total = std::to_string(hud.battle.healthOf(crew));
    write(canvas, {side * 150, 11}, total, 13, paper, crew == 0 ? Align::Right : Align::Left);
    int bar = 0;
    for (const Gunner& gunner : hud.battle.gunners()) {
        if (gunner.crew != crew) continue;
        const double from = 40 + 38 * bar++;
        canvas.rect({x(from, 34), 22}, {34, 8}, ink, 4);
        const double width = 34.0 * gunner.health / fullHealth;
        if (width > 0) canvas.rect({x(from, width), 22}, {width, 8}, crewColor(crew), std::min(4.0, width / 2));
        const bool active = &gunner == &hud.battle.gunner() && hud.battle.phase() != Phase::Over;
        if (active) canvas.rect({x(from - 1, 36), 21}, {36, 10}, stroke(gold, 1.6), 5);
    }
}

/// An arrow whose length shows the wind speed, with streaks that move with the wind.
void drawWind(Canvas& canvas, const Hud& hud) {
    const double wind = hud.battle.wind(), strength = std::abs(wind), way = wind < 0 ? -1 : 1;
    drawPanel(canvas, {middle - 62, 8}, {124, 38}, 9);
    const double half = 8 + 2.6 * std::min(strength, 16.0);
    const Color color = mix(paper, gold, std::min(1.0, strength / 12));
    if (strength > 0.2) {
        canvas.line({middle - way * half, 20}, {middle + way * (half - 5), 20}, color, 4);
        canvas.polygon(
            {{middle + way * (half + 4), 20}, {middle + way * (half - 6), 13}, {middle + way * (half - 6), 27}}, color);
    }
    for (int i = 0; i < 3; ++i) {
        const double share = std::fmod(hud.seconds * strength * 0.06 + i / 3.0, 1.0);
        const double x = middle + way * (share - 0.5) * 104;
        canvas.line({x, 13.0 + 7 * i}, {x - way * strength * 0.9, 13.0 + 7 * i},
                    paper.faded(0.5 * std::sin(share * 3.14)), 1.2);
    }
    const std::string tenths = std::to_string(static_cast<int>(std::lround(strength * 10)));
    const std::string text =
        tenths.size() < 2 ? "0." + tenths : tenths.substr(0, tenths.size() - 1) + "." + tenths.back();
    write(canvas, {middle, 37}, "wind " + text + " m/s", 11, paper);
}

void drawClock(Canvas& canvas, const Hud& hud) {
    if (hud.battle.phase() != Phase::Aim) return;
    const int left = (turnTicks - hud.battle.phaseTicks() + 59) / 60;
    const bool late = left <= 5;
    canvas.circle({middle, 62}, 12, panel);
    const double share = 1 - double(hud.battle.phaseTicks()) / turnTicks;
    canvas.arc({middle, 62}, 12, -1.5708, -1.5708 + 6.2832 * share, stroke(late ? crewColors[0] : gold, 2.4));
    write(canvas, {middle, 62}, std::to_string(left), 12, late ? lighter(crewColors[0], 0.3) : paper);
}

void drawScore(Canvas& canvas, const Hud& hud) {
    drawPanel(canvas, {8, 50}, {104, 18});
    write(canvas, {60, 59}, "score " + std::to_string(hud.score), 12, paper, Align::Center, 96);
}

void drawTide(Canvas& canvas, const Hud& hud) {
    const int left = hud.battle.tideTurn() - hud.battle.turn();
    if (left > 4) return;
    const std::string text =
        left > 0 ? "tide in " + std::to_string(left) + (left == 1 ? " turn" : " turns") : "the tide is rising";
    drawPanel(canvas, {screenWidth - 128, 50}, {120, 18});
    write(canvas, {screenWidth - 68, 59}, text, 12, lighter(crewColors[1], 0.4), Align::Center, 112);
}

void drawWeapons(Canvas& canvas, const Hud& hud) {
    const Gunner& gunner = hud.battle.gunner();
    for (int i = 0; i < static_cast<int>(weapons.size()); ++i) {
        const double x = 12 + 76 * i;
        const int rounds = hud.battle.roundsLeft(gunner.crew, i);
        const bool chosen = gunner.weapon == i;
        drawPanel(canvas, {x, 330}, {72, 22}, 7);
        if (chosen) canvas.rect({x, 330}, {72, 22}, gold, 7);
        const Color color = chosen ? ink : rounds == 0 ? paper.faded(0.35) : paper;
        const std::string name(weapons[static_cast<std::size_t>(i)].name);
        write(canvas, {x + 36, 341}, rounds < 0 ? name : name + " " + std::to_string(rounds), 11, color, Align::Center,
              64);
    }
}

/// The charge, and a mark at the charge of the gunner's last shot.
void drawPower(Canvas& canvas, const Hud& hud) {
    const Gunner& gunner = hud.battle.gunner();
    const double left = 250, width = 240;
    drawPanel(canvas, {left - 4, 330}, {width + 8, 22}, 7);
    const double share = double(gunner.aim.charge) / fullCharge;
    if (hud.battle.charging() && share > 0) {
        const Color hot = mix(gold, crewColors[0], share);
        canvas.rect({left, 334}, {width * share, 14}, Paint::linear({left, 0}, gold, {left + width, 0}, hot), 4);
    }
    const double mark = left + width * gunner.mark / fullCharge;
    canvas.line({mark, 330}, {mark, 336}, paper, 2);
    canvas.polygon({{mark, 332}, {mark - 5, 324}, {mark + 5, 324}}, paper);
    if (!hud.battle.charging()) write(canvas, {left + width / 2, 341}, "power", 11, paper.faded(0.75));
}

/// The barrel's angle, and how far the gunner may still walk in this turn.
void drawAngleAndLegs(Canvas& canvas, const Hud& hud) {
    const std::string angle = std::to_string(static_cast<int>(std::lround(hud.battle.gunner().aim.elevation / 10.0)));
    drawPanel(canvas, {500, 330}, {48, 22}, 7);
    write(canvas, {524, 341}, angle + "°", 13, gold);
    drawPanel(canvas, {554, 330}, {74, 22}, 7);
    write(canvas, {574, 341}, "walk", 11, paper.faded(0.75), Align::Center, 28);
    canvas.rect({592, 338}, {30, 6}, ink, 3);
    const double legs = 30.0 * hud.battle.walkLeft() / walkTicks;
    if (legs > 1) canvas.rect({592, 338}, {legs, 6}, crewColors[1], std::min(3.0, legs / 2));
}

/// The controls, for new players.
void drawHint(Canvas& canvas, const Hud& hud) {
    if (hud.battle.turn() > 4 || hud.battle.charging()) return;
    canvas.rect({middle - 215, 303}, {430, 18}, panel, 9);
    write(canvas, {middle, 312},
          "up, down: barrel    left, right: walk    hold fire and let go    weapon: the next one", 11,
          paper.faded(0.85), Align::Center, 600);
}

/// Shows whose turn it is: the panel pops up, stays and fades.
void drawTurn(Canvas& canvas, const Hud& hud) {
    if (hud.battle.phase() != Phase::Ready) return;
    const double since = hud.battle.phaseTicks(), grown = std::min(1.0, since / 9);
    const double spring = grown * (1 + 1.2 * (1 - grown)), left = std::min(1.0, (readyTicks - since) / 8);
    const int crew = hud.battle.crew();
    const std::string name(crewNames[crew == 0 ? 0 : 1]);
    const auto there = canvas.place({.position = {middle, 84}, .scale = {spring, spring}, .opacity = left});
    canvas.box({0, 0}, {118, 19}, panel, 12);
    canvas.box({0, 17}, {100, 1.5}, crewColor(crew));
    write(canvas, {0, -1}, hud.person ? name + ", your turn" : "the " + name + " take aim", 19,
          lighter(crewColor(crew), 0.35), Align::Center, 220);
    if (hud.battle.turn() == 1) {
        canvas.box({0, 36}, {160, 11}, panel, 10);
        write(canvas, {0, 36}, hud.stage + "  ·  against " + hud.rivals, 12, paper, Align::Center, 306);
    }
}

}  // namespace

void drawHud(Canvas& canvas, const Hud& hud) {
    canvas.screen();
    drawCrew(canvas, hud, 0);
    drawCrew(canvas, hud, 1);
    drawWind(canvas, hud);
    drawClock(canvas, hud);
    drawTide(canvas, hud);
    drawScore(canvas, hud);
    if (hud.person && hud.battle.phase() == Phase::Aim) {
        drawWeapons(canvas, hud);
        drawPower(canvas, hud);
        drawAngleAndLegs(canvas, hud);
        drawHint(canvas, hud);
    }
    if (canvas.behind() == Behind::Nothing) drawTurn(canvas, hud);
}

void drawBanner(Canvas& canvas, const std::string& title, const std::string& line, const Color& color, double seconds) {
    canvas.screen();
    const double grown = std::min(1.0, seconds * 4);
    const Aabb seen = canvas.visible();
    const double height = 74 * grown;
    canvas.rect({seen.lower.x(), 170 - height / 2}, {seen.upper.x() - seen.lower.x(), height}, ink.faded(0.82));
    for (const double side : {-1.0, 1.0})
        canvas.rect({seen.lower.x(), 170 + side * height / 2 - 2}, {seen.upper.x() - seen.lower.x(), 4}, color);
    write(canvas, {middle, 158}, title, 32 * grown, lighter(color, 0.3), Align::Center, 600);
    write(canvas, {middle, 188}, line, 14 * grown, paper, Align::Center, 600);
}

}  // namespace plumb::games::artillery
