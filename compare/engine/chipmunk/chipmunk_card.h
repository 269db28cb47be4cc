// SPDX-License-Identifier: MIT
// What is known of Chipmunk, even if this build does not have it?
#pragma once
#include <compare/engine/engine.h>

namespace plumb::compare {

/// The card without a version.
inline EngineCard chipmunkCard() {
    EngineCard card;
    card.name = "chipmunk";
    card.label = "Chipmunk 7";
    card.product = "Chipmunk";
    card.role = Role::Guest;
    card.look = {"#cc79a7", "#e39ac3", {6, 3, 1, 3}, 2};
    return card;
}

}  // namespace plumb::compare
