// SPDX-License-Identifier: MIT
#include <games/artillery/hud.h>

#include <algorithm>
#include <cmath>

#include <games/artillery/draw.h>
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

// Each display is drawn around its own upper left corner, or its upper middle, in units of the screen. Where it is, and
// how large, is decided at the end.

/// The same as a crew's panel, but of the right crew: mirrored.
double leftEnd(double side, double from, double width) {
    return side > 0 ? from : -from - width;
}

/// A bar for each of its gunners.
void drawGunnerBars(Canvas& canvas, const Hud& hud, int crew, double side) {
    int bar = 0;
    for (const Gunner& gunner : hud.battle().gunners()) {
        if (gunner.crew != crew) continue;
        const double from = 40 + 38 * bar++;
        canvas.rect({leftEnd(side, from, 34), 22}, {34, 8}, ink, 4);
        const double width = 34.0 * gunner.health / fullHealth;
        if (width > 0)
            canvas.rect({leftEnd(side, from, width), 22}, {width, 8}, crewColor(crew), std::min(4.0, width / 2));
        const bool active = &gunner == &hud.battle().gunner() && hud.battle().phase() != Phase::Over;
        if (active) canvas.rect({leftEnd(side, from - 1, 36), 21}, {36, 10}, stroke(gold, 1.6), 5);
    }
}

/// A crew's name and health. The panel of the crew whose turn it is has a frame, and the other one is dim.
void drawCrew(Canvas& canvas, const Hud& hud, int crew) {
    const double side = crew == 0 ? 1 : -1;
    const bool over = hud.battle().phase() == Phase::Over, itsTurn = !over && hud.battle().crew() == crew;
    const auto dim = canvas.place({.opacity = itsTurn || over ? 1 : 0.6});
    drawPanel(canvas, {leftEnd(side, 0, 158), 0}, {158, 38}, 9);
    if (itsTurn) canvas.rect({leftEnd(side, 0, 158), 0}, {158, 38}, stroke(lighter(crewColor(crew), 0.25), 3), 9);
    {
        const auto upright = canvas.place({.position = {side * 20, 22}, .scale = {1, -1}});
        drawHead(canvas, {0, 0}, 10, crew, {side, 0});
    }
    write(canvas, {side * 40, 11}, std::string(crewNames[crew == 0 ? 0 : 1]), 13, lighter(crewColor(crew), 0.3),
          crew == 0 ? Align::Left : Align::Right);
    const std::string total = std::to_string(hud.battle().healthOf(crew));
    write(canvas, {side * 150, 11}, total, 13, paper, crew == 0 ? Align::Right : Align::Left);
    drawGunnerBars(canvas, hud, crew, side);
}

/// An arrow whose length shows the wind speed, with streaks that move with the wind.
void drawWind(Canvas& canvas, const Hud& hud) {
    const double wind = hud.battle().wind(), strength = std::abs(wind), way = wind < 0 ? -1 : 1;
    drawPanel(canvas, {-62, 0}, {124, 38}, 9);
    const double half = 8 + 2.6 * std::min(strength, 16.0);
    const Color color = mix(paper, gold, std::min(1.0, strength / 12));
    if (strength > 0.2) {
        canvas.line({-way * half, 12}, {way * (half - 5), 12}, color, 4);
        canvas.polygon({{way * (half + 4), 12}, {way * (half - 6), 5}, {way * (half - 6), 19}}, color);
    }
    for (int i = 0; i < 3; ++i) {
        const double share = std::fmod(hud.seconds * strength * 0.06 + i / 3.0, 1.0);
        const double x = way * (share - 0.5) * 104;
        canvas.line({x, 5.0 + 7 * i}, {x - way * strength * 0.9, 5.0 + 7 * i},
                    paper.faded(0.5 * std::sin(share * 3.14)), 1.2);
    }
    const std::string tenths = std::to_string(static_cast<int>(std::lround(strength * 10)));
    const std::string text =
        tenths.size() < 2 ? "0." + tenths : tenths.substr(0, tenths.size() - 1) + "." + tenths.back();
    write(canvas, {0, 29}, "wind " + text + " m/s", 11, paper);
}

/// The rest of the time to aim.
void drawClock(Canvas& canvas, const Hud& hud, const Vec2& at) {
    const int left = (turnTicks - hud.battle().phaseTicks() + 59) / 60;
    const bool late = left <= 5;
    canvas.circle(at, 11, ink);
    const double share = 1 - double(hud.battle().phaseTicks()) / turnTicks;
    canvas.arc(at, 11, -1.5708, -1.5708 + 6.2832 * share, stroke(late ? crewColors[0] : gold, 2.4));
    write(canvas, at, std::to_string(left), 12, late ? lighter(crewColors[0], 0.3) : paper);
}

/// Whose turn it is, in the crew's colour. It grows for a moment when a turn begins, and flashes when it answers a
/// press in the rival's turn.
void drawSign(Canvas& canvas, const Hud& hud) {
    const std::string text = hud.answer > 0 ? Answer::text(hud.match) : turnText(hud.match);
    if (text.empty()) return;
    const Battle& battle = hud.battle();
    const double since = battle.phaseTicks(), fresh = std::clamp(1 - since / readyTicks, 0.0, 1.0);
    const double grown = battle.phase() == Phase::Ready && hud.answer == 0 ? 1 + 0.08 * fresh : 1;
    const auto there = canvas.place({.position = {0, 13}, .scale = {grown, grown}});
    const bool flash = hud.answer > 0 && hud.answer / 12 % 2 == 1;
    canvas.box({0, 0}, {112, 13}, flash ? gold : mix(crewColor(battle.crew()), ink, 0.45), 13);
    canvas.box({0, 0}, {112, 13}, stroke(hud.answer > 0 ? gold : lighter(crewColor(battle.crew()), 0.35), 2), 13);
    const bool timed = battle.phase() == Phase::Aim;
    if (timed) drawClock(canvas, hud, {-99, 0});
    write(canvas, {timed ? 10.0 : 0.0, 0.5}, text, 15, flash ? ink : paper, Align::Center, timed ? 184 : 208);
}

/// The island and the rival, at the start of a battle.
void drawOpening(Canvas& canvas, const Hud& hud) {
    if (hud.battle().phase() != Phase::Ready || hud.battle().turn() != 1) return;
    canvas.box({0, 0}, {160, 11}, panel, 10);
    write(canvas, {0, 0}, hud.stage + "  ·  against " + hud.rivals, 12, paper, Align::Center, 306);
}

void drawScore(Canvas& canvas, const Hud& hud) {
    drawPanel(canvas, {0, 0}, {104, 18});
    write(canvas, {52, 9}, "score " + std::to_string(hud.match.progress().score), 12, paper, Align::Center, 96);
}

void drawTide(Canvas& canvas, const Hud& hud) {
    const int left = hud.battle().tideTurn() - hud.battle().turn();
    if (left > 4) return;
    const std::string text =
        left > 0 ? "tide in " + std::to_string(left) + (left == 1 ? " turn" : " turns") : "the tide is rising";
    drawPanel(canvas, {-120, 0}, {120, 18});
    write(canvas, {-60, 9}, text, 12, lighter(crewColors[1], 0.4), Align::Center, 112);
}

void drawWeapons(Canvas& canvas, const Hud& hud) {
    const Gunner& gunner = hud.battle().gunner();
    for (int i = 0; i < static_cast<int>(weapons.size()); ++i) {
        const double x = 76 * i;
        const int rounds = hud.battle().roundsLeft(gunner.crew, i);
        const bool chosen = gunner.weapon == i;
        drawPanel(canvas, {x, 0}, {72, 22}, 7);
        if (chosen) canvas.rect({x, 0}, {72, 22}, gold, 7);
        const Color color = chosen ? ink : rounds == 0 ? paper.faded(0.35) : paper;
        const std::string name(weapons[static_cast<std::size_t>(i)].name);
        write(canvas, {x + 36, 11}, rounds < 0 ? name : name + " " + std::to_string(rounds), 11, color, Align::Center,
              64);
    }
}

/// The charge, and a mark at the charge of the gunner's last shot.
void drawPower(Canvas& canvas, const Hud& hud, double width) {
    const Gunner& gunner = hud.battle().gunner();
    drawPanel(canvas, {-4, 0}, {width + 8, 22}, 7);
    const double share = double(gunner.aim.charge) / fullCharge;
    if (hud.battle().charging() && share > 0) {
        const Color hot = mix(gold, crewColors[0], share);
        canvas.rect({0, 4}, {width * share, 14}, Paint::linear({0, 0}, gold, {width, 0}, hot), 4);
    }
    const double mark = width * gunner.mark / fullCharge;
    canvas.line({mark, 0}, {mark, 6}, paper, 2);
    canvas.polygon({{mark, 2}, {mark - 5, -6}, {mark + 5, -6}}, paper);
    if (!hud.battle().charging()) write(canvas, {width / 2, 11}, "power", 11, paper.faded(0.75));
}

/// The barrel's angle, and how far the gunner may still walk in this turn.
void drawAngleAndLegs(Canvas& canvas, const Hud& hud) {
    const std::string angle = std::to_string(static_cast<int>(std::lround(hud.battle().gunner().aim.elevation / 10.0)));
    drawPanel(canvas, {0, 0}, {48, 22}, 7);
    write(canvas, {24, 11}, angle + "°", 13, gold);
    drawPanel(canvas, {54, 0}, {74, 22}, 7);
    write(canvas, {74, 11}, "walk", 11, paper.faded(0.75), Align::Center, 28);
    canvas.rect({92, 8}, {30, 6}, ink, 3);
    const double legs = 30.0 * hud.battle().walkLeft() / walkTicks;
    if (legs > 1) canvas.rect({92, 8}, {legs, 6}, crewColors[1], std::min(3.0, legs / 2));
}

/// The controls, for new players, in one or two lines.
void drawHint(Canvas& canvas, const Hud& hud, bool narrow) {
    if (hud.battle().turn() > 4 || hud.battle().charging()) return;
    const std::string aiming = "up, down: barrel    left, right: walk";
    const std::string firing = "hold fire and let go    weapon: the next one";
    const Vec2 half = narrow ? Vec2(160, 17) : Vec2(215, 9);
    canvas.rect({-half.x(), 18 - 2 * half.y()}, 2 * half, panel, 9);
    const auto line = [&](double y, const std::string& text) { write(canvas, {0, y}, text, 11, paper.faded(0.85)); };
    if (!narrow) return line(9, aiming + "    " + firing);
    line(-7, aiming);
    line(9, firing);
}

/// What a person needs to aim.
void drawAimingDisplays(Canvas& canvas, const Hud& hud, const Arrangement& arrangement) {
    const double scale = arrangement.upright ? 1.65 : 1, bottom = arrangement.screen.upper.y();
    const auto place = [&](double x, double y) { return canvas.place({.position = {x, y}, .scale = {scale, scale}}); };
    {
        const auto there = arrangement.upright ? place(8, bottom - 94) : place(12, 330);
        drawWeapons(canvas, hud);
    }
    {
        const auto there = arrangement.upright ? place(14.6, bottom - 44) : place(250, 330);
        drawPower(canvas, hud, arrangement.upright ? 370 : 240);
    }
    {
        const auto there = arrangement.upright ? place(421, bottom - 94) : place(500, 330);
        drawAngleAndLegs(canvas, hud);
    }
    const auto there = arrangement.upright ? place(middle, bottom - 132) : place(middle, 303);
    drawHint(canvas, hud, arrangement.upright);
}

/// Where the displays at the top are. crew: the upper left corner of the left panel, and the same of the right one from
/// the right edge; wind, sign and opening: the middle; score: the left edge; tide: from the right edge.
struct TopPlaces {
    Place crew, wind, sign, opening, score, tide;
};

Place placed(double x, double y, double scale) {
    return {.position = {x, y}, .scale = {scale, scale}};
}

TopPlaces topPlacesOf(const Arrangement& arrangement) {
    if (!arrangement.upright)
        return {placed(8, 8, 1),       placed(middle, 8, 1), placed(middle, 49, 1),
                placed(middle, 96, 1), placed(8, 50, 1),     placed(8, 50, 1)};
    const double top = arrangement.screen.lower.y() + 8;
    return {placed(8, top, 1.92),         placed(116.5, top + 81, 1.75),
            placed(433, top + 81, 1.6),   placed(middle, arrangement.field.lower.y() + 24, 1.7),
            placed(254, top + 127, 1.53), placed(20, top + 127, 1.53)};
}

}  // namespace

void drawHud(Canvas& canvas, const Hud& hud, const Arrangement& arrangement) {
    canvas.screen();
    const TopPlaces places = topPlacesOf(arrangement);
    const auto at = [&](const Place& place, const auto& draw) {
        const auto there = canvas.place(place);
        draw(canvas, hud);
    };
    const auto atRight = [&](Place place, const auto& draw) {
        place.position = {screenWidth - place.position.x(), place.position.y()};
        at(place, draw);
    };
    at(places.crew, [](Canvas& left, const Hud& told) { drawCrew(left, told, 0); });
    atRight(places.crew, [](Canvas& right, const Hud& told) { drawCrew(right, told, 1); });
    at(places.wind, drawWind);
    at(places.score, drawScore);
    atRight(places.tide, drawTide);
    if (hud.match.isPersonsTurn() && hud.battle().phase() == Phase::Aim) drawAimingDisplays(canvas, hud, arrangement);
    if (canvas.behind() != Behind::Nothing) return;
    at(places.sign, drawSign);
    at(places.opening, drawOpening);
}

void drawBanner(Canvas& canvas, const std::string& title, const std::string& line, const Color& color, double seconds) {
    canvas.screen();
    const double grown = std::min(1.0, seconds * 4);
    const Aabb seen = canvas.visible();
    const double large = seen.upper.y() - seen.lower.y() > 1.5 * screenHeight ? 1.5 : 1, height = 74 * large * grown;
    canvas.rect({seen.lower.x(), 170 - height / 2}, {seen.upper.x() - seen.lower.x(), height}, ink.faded(0.82));
    for (const double side : {-1.0, 1.0})
        canvas.rect({seen.lower.x(), 170 + side * height / 2 - 2}, {seen.upper.x() - seen.lower.x(), 4}, color);
    write(canvas, {middle, 170 - 12 * large}, title, 32 * large * grown, lighter(color, 0.3), Align::Center, 600);
    write(canvas, {middle, 170 + 18 * large}, line, 14 * large * grown, paper, Align::Center, 600);
}

}  // namespace plumb::games::artillery
