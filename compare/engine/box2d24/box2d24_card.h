// SPDX-License-Identifier: MIT
// What is known of Box2D 2.4, even if this build does not have it?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// The card without a version.
inline EngineCard box2d24Card() {
    EngineCard card;
    card.name = "box2d-2.4";
    card.label = "Box2D 2.4";
    card.product = "Box2D";
    card.role = Role::Peer;
    card.look = {"#d55e00", "#f58a3c", {}, 1.6};
    card.oneSidedChains = true;
    return card;
}

}  // namespace plumb::compare
