// SPDX-License-Identifier: MIT
// What does a level hold?
#pragma once
#include <string>
#include <vector>

#include <plumb/movers/path_mover.h>
#include <plumb/shapes/tile_map.h>

namespace plumb::games::runner {

/// What a tile is beside its form: Tile::tag.
enum Tag : std::uint32_t { Ground, Brick, Lamp, SpentLamp };

enum class ThingKind {
    Coin,
    Sun,      ///< a big coin; a level has three that are hard to come by
    Oil,      ///< a drop that makes the flame tall again
    Crate,    ///< a body of the world
    Spring,   ///< throws up whoever lands on it
    Snuffer,  ///< walks to and fro, to be stomped
    Burr,     ///< the same with thorns on: not to be stomped
    Moth,     ///< flies to and fro
    Lantern,  ///< a checkpoint
    Beacon,   ///< the end
};

struct Thing {
    ThingKind kind = ThingKind::Coin;
    Vec2 at{0, 0};  ///< the centre of its cell [m]
};

/// A one-way floor that goes along a path; its middle is on it.
struct Platform {
    double width = 3;  ///< [m]
    MotionPath path;
    PathRepeat repeat = PathRepeat::BackAndForth;
};

enum class Sky { Dawn, Noon, Night };

/// A cell is a metre, and 16 of the pixels of 1985.
struct Level {
    std::string name;
    Sky sky = Sky::Dawn;
    double par = 60;  ///< who is faster gets points for it [s]
    TileMap tiles;
    Vec2 start{0, 0};  ///< the centre of its cell [m]
    Vec2 beacon{0, 0};
    std::vector<Thing> things;  ///< column by column, each from below
    std::vector<Platform> platforms;
};

}  // namespace plumb::games::runner
