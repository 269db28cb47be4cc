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

/// Air above the highest start, up to the lid [m].
inline constexpr double headroom = 10;

/// What a world is filled with.
struct Filling {
    std::vector<Item> items{};
    Style style{};
};

/// Adds the items and what keeps them in; says where they are: "in a bin". Nothing has a way out of any of these.
std::string fillBin(Scene& scene, Draw& draw, const Filling& filling);
std::string fillHills(Scene& scene, Draw& draw, const Filling& filling);
std::string fillTiles(Scene& scene, Draw& draw, const Filling& filling);
std::string fillDrum(Scene& scene, Draw& draw, const Filling& filling);
std::string fillGasBox(Scene& scene, Draw& draw, const Filling& filling);

/// Adds so many bodies laid at rest, and among them those shot at them.
std::string layAtRest(Scene& scene, Draw& draw, const Style& style, int count);

/// The walls at both sides of a static body, and its lid, around what is from bottom to top; 2 m thick.
std::vector<ShapeDef> wallsAround(const Extent& extent, double bottom, double top, const Material& material);

/// The top of the floor is at y; it reaches under the walls.
ShapeDef floorAt(const Extent& extent, double y, const Material& material);

/// The static body at the head of the scene, named worldName, has these shapes.
void setWorld(Scene& scene, std::vector<ShapeDef> shapes);

/// Where items start that lie in rows of such a width.
std::vector<Vec2> placeOver(const std::vector<Item>& items, const Extent& extent, double bottom, Draw& draw,
                            double gap = 0.05);

}  // namespace plumb::compare
