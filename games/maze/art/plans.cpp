// SPDX-License-Identifier: MIT
#include <games/maze/art/scene.h>

#include <algorithm>
#include <cmath>

#include <games/maze/art/hedges.h>
#include <games/maze/art/palette.h>

namespace plumb::games::maze {
namespace {

Vec2 middleOf(Cell cell) {
    return {cell.column + 0.5, cell.row + 0.5};
}

/// The nearest cell of the maze. The corners in which hunters rest are outside it, where nothing is drawn.
Cell insideMaze(Cell cell) {
    const Vec2 last = gardenCorner + gardenSize - Vec2(1, 1);
    const auto within = [](int index, double lowest, double highest) {
        return std::clamp(index, static_cast<int>(std::ceil(lowest + 0.5)),
                          static_cast<int>(std::floor(highest - 0.5)));
    };
    return {within(cell.column, gardenCorner.x(), last.x()), within(cell.row, gardenCorner.y(), last.y())};
}

void frame(Canvas& canvas, Cell cell, const Color& color, double width) {
    canvas.box(middleOf(cell), {0.5, 0.5}, stroke(color, width));
}

void drawPlan(Canvas& canvas, const Chase& chase, const Hunter& hunter) {
    const Color color = lookOf(hunter.who()).fur;
    frame(canvas, hunter.cell(), color.faded(0.7), 0.08);
    if (hunter.where() != Where::Lanes || hunter.frightened()) return;
    const Cell target = insideMaze(chase.targetOf(hunter.who()));
    canvas.line(hunter.position(), middleOf(target), color.faded(0.8), 0.12);
    frame(canvas, target, color, 0.2);
}

}  // namespace

void drawPlans(Canvas& canvas, const Chase& chase) {
    const Canvas::Scope scope = canvas.clip(gardenCorner, gardenSize);
    frame(canvas, chase.player().cell(), paper.faded(0.7), 0.08);
    for (const Hunter& hunter : chase.hunters())
        if (hunter.isInLanes()) drawPlan(canvas, chase, hunter);
}

}  // namespace plumb::games::maze
