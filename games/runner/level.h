// SPDX-License-Identifier: MIT
// What does a level contain?
#pragma once
#include <string>
#include <vector>

#include <plumb/movers/path_mover.h>
#include <plumb/shapes/tile_map.h>

namespace plumb::games::runner {

/// What kind of tile it is in this game; stored in Tile::tag.
enum Tag : std::uint32_t { Ground, Brick, Lamp, SpentLamp };

enum class ThingKind {
    Coin,
    Sun,      ///< a big coin; a level has three in hard places
    Oil,      ///< a drop that makes the flame tall again
    Crate,    ///< a body of the world
    Spring,   ///< throws the hero up
    Snuffer,  ///< walks to and fro; can be stomped
    Burr,     ///< walks to and fro; its thorns hurt a hero on top
    Moth,     ///< flies to and fro
    Lantern,  ///< a checkpoint
    Beacon,   ///< the end
};

struct Thing {
    ThingKind kind = ThingKind::Coin;
    Vec2 at{0, 0};  ///< the centre of its cell [m]
};

/// A one-way floor whose middle moves along a path.
struct Platform {
    double width = 3;  ///< [m]
    MotionPath path;
    PathRepeat repeat = PathRepeat::BackAndForth;
};

enum class Sky { Dawn, Noon, Night };

/// A cell is 1 m wide, which is 16 pixels of 1985.
struct Level {
    std::string name;
    Sky sky = Sky::Dawn;
    double par = 60;  ///< a faster finish gives points [s]
    TileMap tiles;
    Vec2 start{0, 0};  ///< the centre of its cell [m]
    Vec2 beacon{0, 0};
    std::vector<Thing> things;  ///< column by column, each from bottom to top
    std::vector<Platform> platforms;
};

}  // namespace plumb::games::runner
