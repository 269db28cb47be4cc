// SPDX-License-Identifier: MIT
// Which closed worlds do random bodies start in?
#pragma once
#include <string>
#include <vector>

#include <compare/scene/random/draw.h>
#include <compare/scene/random/rows.h>
#include <compare/scene/random/style.h>
#include <compare/scene/scene.h>

namespace plumb::compare {

/// Height of the free space above the highest start, up to the lid [m].
inline constexpr double headroom = 10;

/// What a world is filled with.
struct Filling {
    std::vector<Item> items{};
    Style style{};
};

/// Adds the items and the walls around them. Returns where they are: "in a bin". Nothing can leave any of these worlds.
std::string fillBin(Scene& scene, Draw& draw, const Filling& filling);
std::string fillHills(Scene& scene, Draw& draw, const Filling& filling);
std::string fillTiles(Scene& scene, Draw& draw, const Filling& filling);
std::string fillDrum(Scene& scene, Draw& draw, const Filling& filling);
std::string fillGasBox(Scene& scene, Draw& draw, const Filling& filling);

/// Adds this many bodies: most are laid at rest, the others are shot at them.
std::string layAtRest(Scene& scene, Draw& draw, const Style& style, int count);

/// The walls at both sides of a static body and its lid, around the space from bottom to top; 2 m thick.
std::vector<ShapeDef> wallsAround(const Extent& extent, double bottom, double top, const Material& material);

/// The top of the floor is at y; the floor reaches under the walls.
ShapeDef floorAt(const Extent& extent, double y, const Material& material);

/// Gives these shapes to the first body of the scene, the static one named worldName.
void setWorld(Scene& scene, std::vector<ShapeDef> shapes);

/// Where items start in rows of this width.
std::vector<Vec2> placeOver(const std::vector<Item>& items, const Extent& extent, double bottom, Draw& draw,
                            double gap = 0.05);

}  // namespace plumb::compare
