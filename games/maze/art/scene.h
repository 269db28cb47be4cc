// SPDX-License-Identifier: MIT
// How is the whole game drawn: garden, displays, recent events, plans for the debug view, and the show of the title?
#pragma once
#include <string>

#include <games/frame/canvas.h>
#include <games/maze/art/arrangement.h>
#include <games/maze/chase.h>

namespace plumb::games::maze {

class MazeGame;
struct Trace;

void drawScene(Canvas& canvas, const MazeGame& game);

/// In the screen's units: score, level, fright and lives on the left, the cats and the treats eaten on the right. In an
/// upright window the cats and the fright are below the maze, and the rest is above it.
void drawHud(Canvas& canvas, const MazeGame& game, const Arrangement& arrangement);

/// Text with its middle at this place and a dark edge around it; size in tiles. color may be faded.
void drawLettering(Canvas& canvas, const std::string& text, const Vec2& at, const Color& color, double size);

/// Draws flying crumbs, rings of light, stars and rising points, or nothing for events without an effect. In tiles.
void drawTrace(Canvas& canvas, const Trace& trace);

/// For the debug view: the cells of the mouse and of the cats in the lanes, and a line from each hunting cat to its
/// target cell. Cats that are frightened, caught or at home have no target.
void drawPlans(Canvas& canvas, const Chase& chase);

/// A garden at night, this many seconds after the title appeared: four cats chase a mouse, then the mouse chases four
/// cats.
void drawTitleShow(Canvas& canvas, double seconds);

}  // namespace plumb::games::maze
