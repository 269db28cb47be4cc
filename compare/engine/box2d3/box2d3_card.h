// SPDX-License-Identifier: MIT
// What is known of Box2D 3, even if this build does not have it?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// The card without a version.
inline EngineCard box2d3Card() {
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
