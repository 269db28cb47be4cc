// SPDX-License-Identifier: MIT
#include <games/maze/art/palette.h>
#include <games/maze/art/scene.h>
#include <games/maze/computer.h>
#include <games/maze/maze_game.h>

namespace plumb::games::maze {

GameInfo info() {
    return {.title = "Midnight Crumbs",
            .about = "One mouse, four cats, and all the crumbs of a moonlit garden.",
            .actions = {{"up", {Key::Up, Key::W}, {Pad::Up}, "steer"},
                        {"left", {Key::Left, Key::A}, {Pad::Left}, "steer"},
                        {"down", {Key::Down, Key::S}, {Pad::Down}, "steer"},
                        {"right", {Key::Right, Key::D}, {Pad::Right}, "steer"}},
            .options = {{.name = "level",
                         .about = "The first level",
                         .value = "1",
                         .choices = {"1", "2", "5", "9", "13", "21"},
                         .label = "First level"},
                        {.name = "levels",
                         .about = "How many levels you must clear to win; 0: the game goes on until all lives are lost",
                         .value = "0"}},
            .theme = theme(),
            .fillsUpright = true,
            .make = [](const GameSetup& setup) { return std::make_unique<MazeGame>(setup); },
            .computer = [](const GameSetup&) { return computerPlayer(); },
            .drawTitle = drawTitleShow};
}

}  // namespace plumb::games::maze
