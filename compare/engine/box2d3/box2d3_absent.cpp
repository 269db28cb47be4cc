// SPDX-License-Identifier: MIT
// This is compiled instead of the engine if no Box2D 3 is installed.
#include <compare/engine/box2d3/box2d3_card.h>
#include <compare/engine/engines.h>

namespace plumb::compare {

Engine box2d3Engine(bool, int) {
    return {box2d3Card(), {}, {}};
}

}  // namespace plumb::compare
