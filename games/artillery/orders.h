// SPDX-License-Identifier: MIT
// What can a crew be told to do in a tick?
#pragma once
#include <games/frame/action.h>

namespace plumb::games::artillery {

/// Held or not; the battle sees by itself what was pressed anew.
struct Orders {
    bool left = false, right = false;  ///< face there, or walk there
    bool up = false, down = false;     ///< the barrel
    bool fire = false;                 ///< held it charges; let go, it fires
    bool weapon = false;               ///< the next one
    friend bool operator==(const Orders&, const Orders&) = default;
};

/// The bits of the game's actions, which stand in this order.
inline Buttons buttonsOf(const Orders& orders) {
    Buttons buttons = 0;
    int bit = 0;
    for (const bool held : {orders.left, orders.right, orders.up, orders.down, orders.fire, orders.weapon})
        buttons |= Buttons{held} << bit++;
    return buttons;
}
inline Orders ordersOf(Buttons buttons) {
    const auto held = [buttons](int bit) { return ((buttons >> bit) & 1) != 0; };
    return {held(0), held(1), held(2), held(3), held(4), held(5)};
}

}  // namespace plumb::games::artillery
