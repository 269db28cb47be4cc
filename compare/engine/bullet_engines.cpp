// SPDX-License-Identifier: MIT
#include <compare/engine/bullet_engines.h>

#include <compare/engine/box2d24/box2d24_engine.h>
#include <compare/engine/box2d3/box2d3_engine.h>

namespace plumb::compare {

std::optional<Engine> withBullets(const Engine& engine) {
    if (engine.name == "box2d-2.4") return box2d24Engine(true);
    if (engine.name == "box2d-3") return box2d3Engine(true);
    return std::nullopt;
}

}  // namespace plumb::compare
