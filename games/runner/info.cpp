// SPDX-License-Identifier: MIT
// What the frame is told about this game.
#include <games/runner/buttons.h>
#include <games/runner/computer.h>
#include <games/runner/runner.h>

namespace plumb::games::runner {

GameInfo info() {
    GameInfo info;
    info.title = "Lantern Run";
    info.about = "A candle runs, jumps and stomps its way to three beacons, and lights them.";
    info.actions = actions();
    info.options = {
        {.name = "profile",
         .about = "How it moves: by the tables of 1985, or as today's games do",
         .value = "modern",
         .choices = {"modern", "1985"},
         .label = "Moves like"},
        {.name = "from", .about = "The first level", .value = "1", .choices = {"1", "2", "3"}, .label = "From level"},
        {.name = "level", .about = "A file with a level of your own, instead of the three"}};
    info.theme = {.background = Color::hex(0x1d1828),
                  .panel = Color::hex(0x352b45),
                  .text = Color::hex(0xfff6e6),
                  .quiet = Color::hex(0xcfc3d6),
                  .accent = Color::hex(0xffb84d)};
    info.fillsUpright = true;
    info.make = [](const GameSetup& setup) { return std::make_unique<Runner>(setup); };
    info.computer = computer;
    return info;
}

}  // namespace plumb::games::runner
