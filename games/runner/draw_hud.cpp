// SPDX-License-Identifier: MIT
#include <cmath>
#include <string>

#include <games/runner/draw.h>
#include <games/runner/view.h>

namespace plumb::games::runner {
namespace {

const Color panel = Color::hex(0x1d1828), plain = Color::hex(0xfff6e6), gold = Color::hex(0xffd24a);

void label(Canvas& canvas, const Vec2& at, const std::string& text, double size, const Color& color,
           Align align = Align::Left) {
    canvas.text(at, text,
                {.size = size, .color = color, .align = align, .baseline = Baseline::Middle, .weight = Weight::Bold});
}

std::string padded(std::int64_t number, std::size_t digits) {
    const std::string text = std::to_string(number);
    return text.size() < digits ? std::string(digits - text.size(), '0') + text : text;
}

void drawLives(Canvas& canvas, const Vec2& at, int lives) {
    canvas.rect(at + Vec2(-5, -3), {10, 12}, plain, 3);
    canvas.rect(at + Vec2(-5, 3), {10, 3}, Color::hex(0xd9414e), 1);
    canvas.polygon({at + Vec2(-3.4, -4), at + Vec2(0, -11), at + Vec2(3.4, -4)}, Color::hex(0xffa03a));
    canvas.circle(at + Vec2(0, -4), 3.4, Color::hex(0xffa03a));
    label(canvas, at + Vec2(12, 0), "x " + std::to_string(lives), 14, plain);
}

void drawCoins(Canvas& canvas, const Vec2& at, int coins) {
    canvas.ellipse(at, {6, 8}, gold);
    canvas.ellipse(at, {3.6, 5.4}, stroke(Color::hex(0xb88a1e), 1.2));
    label(canvas, at + Vec2(12, 0), "x " + padded(coins, 2), 14, plain);
}

void drawSuns(Canvas& canvas, const Vec2& at, const std::vector<bool>& suns) {
    for (std::size_t i = 0; i < suns.size() && i < 5; ++i) {
        const Vec2 center = at + Vec2(20.0 * static_cast<double>(i), 0);
        if (!suns[i]) {
            canvas.circle(center, 5.5, stroke(plain.faded(0.45), 1.5));
            continue;
        }
        for (int ray = 0; ray < 8; ++ray) {
            const double angle = ray * 0.785398;
            canvas.line(center, center + 8.5 * Vec2(std::cos(angle), std::sin(angle)), gold, 1.6);
        }
        canvas.circle(center, 5.5, gold);
    }
}

void drawWideHud(Canvas& canvas, const Hud& hud) {
    canvas.rect({8, 8}, {624, 28}, panel.faded(0.62), 14);
    drawLives(canvas, {26, 23}, hud.lives);
    drawCoins(canvas, {88, 22}, hud.coins);
    drawSuns(canvas, {164, 22}, hud.suns);
    label(canvas, {320, 22}, padded(hud.score, 6), 18, gold, Align::Center);
    label(canvas, {438, 22}, "Level " + std::to_string(hud.level), 14, plain, Align::Center);
    label(canvas, {546, 22}, std::string(hud.profile), 13, plain.faded(0.75), Align::Right);
    label(canvas, {618, 22}, std::to_string(static_cast<int>(hud.seconds)) + " s", 14, plain, Align::Right);
}

/// The same in two lines, and larger. top: the upper edge of the screen.
void drawUprightHud(Canvas& canvas, const Hud& hud, double top) {
    constexpr double large = 1.7;
    canvas.rect({8, top + 8}, {624, uprightBand - 16}, panel.faded(0.62), 16);
    const auto there = canvas.place({.position = {0, top}, .scale = {large, large}});
    drawLives(canvas, {21, 19.5}, hud.lives);
    drawCoins(canvas, {93, 18.5}, hud.coins);
    label(canvas, {364, 18.5}, padded(hud.score, 6), 20, gold, Align::Right);
    drawSuns(canvas, {23, 43.5}, hud.suns);
    label(canvas, {148, 43.5}, "Level " + std::to_string(hud.level), 13, plain);
    label(canvas, {246, 43.5}, std::string(hud.profile), 12, plain.faded(0.75));
    label(canvas, {364, 43.5}, std::to_string(static_cast<int>(hud.seconds)) + " s", 14, plain, Align::Right);
}

}  // namespace

void drawHud(Canvas& canvas, const Hud& hud) {
    canvas.screen();
    const Aabb screen = canvas.visible();
    if (isUpright(screen)) return drawUprightHud(canvas, hud, screen.lower.y());
    drawWideHud(canvas, hud);
}

void drawCard(Canvas& canvas, const Card& card, double share) {
    if (share <= 0) return;
    canvas.screen();
    const Aabb seen = canvas.visible();
    const bool upright = isUpright(seen);
    const double large = upright ? 1.5 : 1, top = upright ? seen.lower.y() + uprightBand + 8 : 44;
    const double height = large * (50 + 19 * static_cast<double>(card.lines.size()));
    const double width = (seen.upper.x() - seen.lower.x()) * share;
    canvas.rect({seen.lower.x(), top}, {width, height}, panel.faded(0.86));
    for (const double edge : {top, top + height - 3}) canvas.rect({seen.lower.x(), edge}, {width, 3}, gold);
    if (share < 1) return;
    TextStyle style{.size = 30 * large,
                    .color = plain,
                    .align = Align::Center,
                    .baseline = Baseline::Middle,
                    .weight = Weight::Heavy,
                    .fitWidth = 560};
    canvas.text({screenWidth / 2, top + 26 * large}, card.title, style);
    style.size = 15 * large;
    style.color = gold;
    style.weight = Weight::Bold;
    double y = top + 52 * large;
    for (const std::string& line : card.lines) {
        canvas.text({screenWidth / 2, y}, line, style);
        y += 19 * large;
    }
}

void drawIris(Canvas& canvas, const Vec2& at, double open) {
    if (open >= 1) return;
    const double radius = 16 * open * open, outer = 40;
    if (radius < 0.05) return canvas.clear(Color::hex(0x0b0912));
    canvas.circle(at, radius + outer, stroke(Color::hex(0x0b0912), 2 * outer));
}

}  // namespace plumb::games::runner
