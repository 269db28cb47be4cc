// SPDX-License-Identifier: MIT
#include <compare/engine/box2d3/box2d3_card.h>

namespace plumb::compare {

EngineCard box2d3Card() {
    EngineCard card;
    card.name = "box2d-3";
    card.label = "Box2D 3";
    card.product = "Box2D";
    card.role = Role::Peer;
    card.look = {"#008a66", "#2fc79c", {9, 5}, 2};
    card.isRival = true;
    card.missing = "set PLUMB_BOX2D3_DIR to where it is installed, or PLUMB_BOX2D3_GIT to where it can be fetched from";
    card.oneSidedChains = true;
    return card;
}

}  // namespace plumb::compare
