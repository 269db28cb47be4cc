// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include <compare/scene/random/worlds.h>

namespace plumb::compare {

std::string fillGasBox(Scene& scene, Draw& draw, const Filling& filling) {
    const double gap = draw.uniform(0.5, 2), speed = draw.logUniform(2, 20);
    const double restitution = draw.chance(0.5) ? 1 : draw.uniform(0.7, 1);
    const bool manySleep = scene.sleeping && draw.chance(0.4);
    scene.gravity = {0, 0};
    std::vector<Item> items = filling.items;
    for (Item& item : items) {
        BodyDef& def = item.bodies.front().def;
        const double pace = speed * draw.uniform(0.2, 1);
        def.velocity = pace * draw.direction();
        if (manySleep && draw.chance(0.8)) {
            def.velocity = {0, 0};
            def.angularVelocity = 0;
            def.awake = false;
        }
        for (ShapeDef& shape : def.shapes) {
            shape.material.restitution = restitution;
            shape.material.friction *= 0.2;
        }
    }
    const double width = std::sqrt(areaOf(items)) * (1 + gap);
    const double half = std::max(width, 2 * (1 + gap) * widestOf(items)) / 2;
    const double top = addItems(scene, items, placeOver(items, {-half, half}, 0, draw, gap));
    const Material smooth{.friction = 0, .restitution = restitution};
    std::vector<ShapeDef> shapes = wallsAround({-half, half}, 0, top + 0.1, smooth);
    shapes.push_back(floorAt({-half, half}, 0, smooth));
    setWorld(scene, shapes);
    return manySleep ? "without weight in a box, most of them asleep" : "as a thin gas in a box";
}

}  // namespace plumb::compare
