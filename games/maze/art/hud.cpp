// SPDX-License-Identifier: MIT
#include <games/maze/art/scene.h>

#include <algorithm>

#include <games/maze/art/figures.h>
#include <games/maze/art/palette.h>
#include <games/maze/maze_game.h>

namespace plumb::games::maze {
namespace {

constexpr double left = 20, right = 496, columnWidth = 126;

void label(Canvas& canvas, const Vec2& at, const std::string& text) {
    canvas.text(at, text, {.size = 11, .color = quiet, .weight = Weight::Bold});
}

void number(Canvas& canvas, const Vec2& at, const std::string& text, double size, const Color& color = paper) {
    canvas.text(at, text, {.size = size, .color = color, .weight = Weight::Heavy, .fitWidth = columnWidth});
}

void drawLives(Canvas& canvas, const MazeGame& game) {
    label(canvas, {left, 300}, "LIVES");
    const int spare = game.lives() - 1;
    if (spare == 0) canvas.text({left, 324}, "the last one", {.size = 12, .color = skin});
    for (int i = 0; i < std::min(spare, 4); ++i) {
        const Canvas::Scope scope = canvas.place({.position = {left + 18 + 34.0 * i, 320}, .scale = {12, 12}});
        drawMouse(canvas, {.still = true});
    }
    const int since = game.sinceExtraLife();
    if (since < 180 && since / 12 % 2 == 0) number(canvas, {left, 348}, "+1 life", 14, skin);
}

void drawFright(Canvas& canvas, const MazeGame& game) {
    const Chase& chase = game.chase();
    if (chase.frightFrames() == 0) return;
    const double share = static_cast<double>(chase.frightFrames()) / chase.rules().frightFrames;
    label(canvas, {left, 178}, "CATS ARE AFRAID");
    canvas.rect({left, 186}, {columnWidth - 10, 8}, groove, 4);
    const bool light = chase.rules().isFlash(chase.frightFrames());
    canvas.rect({left, 186}, {std::max(8.0, (columnWidth - 10) * share), 8}, light ? scaredLight : scared, 4);
}

void drawCats(Canvas& canvas, const MazeGame& game) {
    label(canvas, {right, 36}, "CATS");
    for (const Who who : everyone) {
        const double y = 62 + 40.0 * static_cast<double>(indexOf(who));
        const bool hastes = who == Who::Chaser && game.chase().haste() > 0;
        {
            const Canvas::Scope scope = canvas.place({.position = {right + 14, y}, .scale = {14, -14}});
            drawCat(canvas, who, {.mood = hastes ? Mood::Hastes : Mood::Hunts});
        }
        canvas.text({right + 38, y - 2}, lookOf(who).name,
                    {.size = 14, .color = lookOf(who).fur, .weight = Weight::Bold});
        canvas.text({right + 38, y + 12}, lookOf(who).habit, {.size = 10.5, .color = quiet, .fitWidth = 92});
    }
}

void drawEaten(Canvas& canvas, const MazeGame& game) {
    const std::vector<int>& eaten = game.fruitEaten();
    label(canvas, {right, 300}, "TREATS");
    const std::size_t shown = std::min<std::size_t>(eaten.size(), 5);
    for (std::size_t i = 0; i < shown; ++i) {
        const Vec2 at(right + 12 + 25.0 * static_cast<double>(i), 320);
        const Canvas::Scope scope = canvas.place({.position = at, .scale = {12, -12}});
        drawFruit(canvas, eaten[eaten.size() - shown + i]);
    }
    if (eaten.empty()) canvas.text({right, 324}, "none yet", {.size = 12, .color = quiet});
}

void drawBesideMaze(Canvas& canvas, const MazeGame& game) {
    label(canvas, {left, 36}, "SCORE");
    number(canvas, {left, 64}, std::to_string(game.score()), 30);
    label(canvas, {left, 100}, "LEVEL");
    number(canvas, {left, 124}, std::to_string(game.level()), 24, cheese);
    label(canvas, {left + 66, 100}, "CRUMBS");
    number(canvas, {left + 66, 124}, std::to_string(game.chase().dotsLeft()), 24, crumb);
    drawFright(canvas, game);
    drawLives(canvas, game);
    drawCats(canvas, game);
    drawEaten(canvas, game);
}

// In an upright window: a unit of the screen is small there, so these are larger.

/// A name and, below it, what it names. y: of the name's baseline.
void figure(Canvas& canvas, const Vec2& at, const std::string& name, const std::string& value, const Color& color,
            double width) {
    canvas.text(at, name, {.size = 17, .color = quiet, .weight = Weight::Bold});
    if (!value.empty())
        canvas.text(at + Vec2(0, 36), value, {.size = 36, .color = color, .weight = Weight::Heavy, .fitWidth = width});
}

void drawAboveMaze(Canvas& canvas, const MazeGame& game, double top) {
    const double y = top - 52;
    figure(canvas, {14, y}, "SCORE", std::to_string(game.score()), paper, 150);
    figure(canvas, {178, y}, "LEVEL", std::to_string(game.level()), cheese, 60);
    figure(canvas, {262, y}, "CRUMBS", std::to_string(game.chase().dotsLeft()), crumb, 90);
    const int since = game.sinceExtraLife();
    const bool gained = since < 180 && since / 12 % 2 == 0;
    figure(canvas, {376, y}, gained ? "+1 LIFE" : "LIVES", game.lives() == 1 ? "the last" : "", skin, 100);
    for (int i = 0; i < std::min(game.lives() - 1, 3); ++i) {
        const Canvas::Scope scope = canvas.place({.position = {392 + 38.0 * i, y + 24}, .scale = {14, 14}});
        drawMouse(canvas, {.still = true});
    }
    const std::vector<int>& eaten = game.fruitEaten();
    if (eaten.empty()) return;
    figure(canvas, {510, y}, "TREATS", "", paper, 0);
    const std::size_t shown = std::min<std::size_t>(eaten.size(), 4);
    for (std::size_t i = 0; i < shown; ++i) {
        const Vec2 at(524 + 30.0 * static_cast<double>(i), y + 24);
        const Canvas::Scope scope = canvas.place({.position = at, .scale = {14, -14}});
        drawFruit(canvas, eaten[eaten.size() - shown + i]);
    }
}

/// How long the cats are afraid, as a bar in the place of what they do.
void drawFrightBelow(Canvas& canvas, const Chase& chase, double y) {
    const double share = static_cast<double>(chase.frightFrames()) / chase.rules().frightFrames, width = 440;
    canvas.text({14, y + 6}, "CATS ARE AFRAID", {.size = 17, .color = quiet, .weight = Weight::Bold});
    canvas.rect({186, y - 6}, {width, 12}, groove, 6);
    const bool light = chase.rules().isFlash(chase.frightFrames());
    canvas.rect({186, y - 6}, {std::max(12.0, width * share), 12}, light ? scaredLight : scared, 6);
}

void drawBelowMaze(Canvas& canvas, const MazeGame& game, double bottom) {
    const Chase& chase = game.chase();
    const double y = bottom + 30, spacing = (screenWidth - 16) / 4;
    for (const Who who : everyone) {
        const double x = 14 + spacing * static_cast<double>(indexOf(who));
        const bool hastes = who == Who::Chaser && chase.haste() > 0;
        {
            const Canvas::Scope scope = canvas.place({.position = {x + 18, y}, .scale = {18, -18}});
            drawCat(canvas, who, {.mood = hastes ? Mood::Hastes : Mood::Hunts});
        }
        canvas.text({x + 44, y + 8}, lookOf(who).name,
                    {.size = 23, .color = lookOf(who).fur, .weight = Weight::Bold, .fitWidth = spacing - 52});
        if (chase.frightFrames() == 0)
            canvas.text({x, y + 42}, lookOf(who).habit, {.size = 18, .color = quiet, .fitWidth = spacing - 10});
    }
    if (chase.frightFrames() > 0) drawFrightBelow(canvas, chase, y + 36);
}

}  // namespace

void drawHud(Canvas& canvas, const MazeGame& game, const Arrangement& arrangement) {
    if (!arrangement.upright) return drawBesideMaze(canvas, game);
    drawAboveMaze(canvas, game, arrangement.top);
    drawBelowMaze(canvas, game, arrangement.bottom);
}

}  // namespace plumb::games::maze
