// SPDX-License-Identifier: MIT
#include <games/maze/art/scene.h>

#include <algorithm>
#include <cmath>

#include <games/maze/art/arrangement.h>
#include <games/maze/art/figures.h>
#include <games/maze/art/hedges.h>
#include <games/maze/art/palette.h>
#include <games/maze/lanes.h>
#include <games/maze/maze_game.h>

namespace plumb::games::maze {
namespace {

/// Shows 31 rows and a rim. It shakes when the mouse is caught. rows: the height of the safe area.
Camera cameraOf(const MazeGame& game, double rows) {
    Camera camera{.center = {14, 17.5}, .height = rows};
    if (game.phase() != Phase::Caught) return camera;
    const double time = game.phaseTicks(), force = 0.3 * std::max(0.0, 1 - time / 16);
    camera.center += force * Vec2(std::sin(2.1 * time), std::cos(2.9 * time));
    return camera;
}

/// The position between two ticks. After a move through the tunnel it does not cross the whole maze.
Vec2 seenAt(const Vec2& before, const Vec2& now, double between) {
    Vec2 from = before;
    if (from.x() - now.x() > columns / 2.0) from.x() -= columns;
    if (now.x() - from.x() > columns / 2.0) from.x() += columns;
    return from + between * (now - from);
}

/// Draws an animal in one end of the tunnel at the other end too.
template <typename Draw>
void atBothEnds(Canvas& canvas, const Vec2& at, const Draw& draw) {
    for (const double shift : {-1.0 * columns, 0.0, 1.0 * columns}) {
        const Vec2 place = at + Vec2(shift, 0);
        if (place.x() < -2 || place.x() > columns + 2) continue;
        const Canvas::Scope scope = canvas.place({.position = place});
        draw();
    }
}

double flashOf(const MazeGame& game) {
    if (game.phase() != Phase::Cleared || game.phaseTicks() < 40) return 0;
    return game.phaseTicks() / 14 % 2;
}

void drawDots(Canvas& canvas, const MazeGame& game) {
    const double pulse = 0.5 + 0.5 * std::sin(0.12 * static_cast<double>(game.ticks()));
    for (const Cell cell : lanes().cells()) {
        if (!game.chase().hasDot(cell)) continue;
        const Vec2 at = mazeMap().centerOf(cell);
        if (has(mazeMap().at(cell), powerTag))
            drawCheese(canvas, at, pulse);
        else
            drawCrumb(canvas, at);
    }
}

void drawFruitShown(Canvas& canvas, const MazeGame& game) {
    if (!game.chase().fruitShown()) return;
    const double hop = 0.1 * std::fabs(std::sin(0.1 * static_cast<double>(game.ticks())));
    const Canvas::Scope scope = canvas.place({.position = positionOf(fruitPlace) + Vec2(0, hop)});
    drawFruit(canvas, game.chase().rules().fruit.kind);
}

Mood moodOf(const MazeGame& game, const Hunter& hunter) {
    const Chase& chase = game.chase();
    if (hunter.where() == Where::Eyes || hunter.where() == Where::Entering) return Mood::Eyes;
    if (hunter.frightened()) return chase.rules().isFlash(chase.frightFrames()) ? Mood::Flashes : Mood::Frightened;
    if (hunter.who() == Who::Chaser && chase.haste() > 0) return Mood::Hastes;
    const bool rests = chase.mode() == HunterMode::Scatter || hunter.where() != Where::Lanes;
    return rests ? Mood::Rests : Mood::Hunts;
}

void drawHunters(Canvas& canvas, const MazeGame& game) {
    if (game.phase() == Phase::Dying || (game.phase() == Phase::Cleared && game.phaseTicks() > 40)) return;
    for (const Hunter& hunter : game.chase().hunters()) {
        if (game.chase().justCaught() == hunter.who()) continue;  // its points are shown there
        const Vec2 at = seenAt(game.trail().hunters[indexOf(hunter.who())], hunter.position(), canvas.between());
        const CatPose pose{moodOf(game, hunter), hunter.heading(), 0.06 * static_cast<double>(game.ticks())};
        atBothEnds(canvas, at, [&] { drawCat(canvas, hunter.who(), pose); });
    }
}

/// The direction of its motion, or its heading if it stands still.
double angleOfPlayer(const MazeGame& game) {
    const Vec2 now = game.chase().playerPosition(), before = game.trail().player;
    const Vec2 step = now - before;
    const bool jumped = std::fabs(step.x()) > 1;
    if (jumped || step.squaredNorm() == 0) return angleOf(game.chase().player().heading());
    return std::atan2(step.y(), step.x());
}

void drawPlayer(Canvas& canvas, const MazeGame& game) {
    const Chase& chase = game.chase();
    const Vec2 at = seenAt(game.trail().player, chase.playerPosition(), canvas.between());
    if (game.phase() == Phase::Dying) {
        const Canvas::Scope scope = canvas.place({.position = at});
        const double share = static_cast<double>(game.phaseTicks()) / MazeGame::ticksOf(Phase::Dying);
        return drawLostMouse(canvas, angleOf(chase.player().heading()), share);
    }
    const bool still = chase.player().stopped() || game.phase() != Phase::Play;
    const MousePose pose{.angle = angleOfPlayer(game),
                         .stride = at.x() + at.y() + (still ? 0.02 * static_cast<double>(game.ticks()) : 0),
                         .still = still,
                         .blinks = game.phase() == Phase::Caught || game.ticks() % 200 < 8};
    atBothEnds(canvas, at, [&] { drawMouse(canvas, pose); });
}

void drawSigns(Canvas& canvas, const MazeGame& game) {
    const Vec2 below = positionOf(fruitPlace);
    if (game.phase() == Phase::Intro || game.phase() == Phase::Ready) {
        const int half = MazeGame::ticksOf(game.phase()) / 2;
        const bool first = game.phaseTicks() < half;
        const double pop = 1 + 0.5 * std::max(0.0, 1 - game.phaseTicks() % half / 10.0);
        const std::string level = "Level " + std::to_string(game.level());
        drawLettering(canvas, first ? level : "Ready!", below, first ? paper : cheese, 1.6 * pop);
    }
    if (game.phase() == Phase::Dying) drawLettering(canvas, game.verdict() + "!", below, skin, 1.6);
    if (game.phase() == Phase::Cleared && game.phaseTicks() > 40)
        drawLettering(canvas, "All crumbs!", below, cheese, 1.6);
}

}  // namespace

void drawScene(Canvas& canvas, const MazeGame& game) {
    canvas.screen();
    canvas.clear(night);
    const Arrangement arrangement = arrangementIn(canvas.visible());
    drawHud(canvas, game, arrangement);
    canvas.look(cameraOf(game, arrangement.rows));
    drawGarden(canvas, gardenOf(game.level()), flashOf(game));
    {
        const Canvas::Scope scope = canvas.clip(gardenCorner, gardenSize);
        drawDots(canvas, game);
        drawFruitShown(canvas, game);
        drawPlayer(canvas, game);
        drawHunters(canvas, game);
    }
    for (const Trace& trace : game.traces()) drawTrace(canvas, trace);
    if (canvas.behind() == Behind::Nothing) drawSigns(canvas, game);
}

}  // namespace plumb::games::maze
