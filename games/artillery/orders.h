// SPDX-License-Identifier: MIT
// Which orders can a crew get in a tick?
#pragma once
#include <games/frame/action.h>

namespace plumb::games::artillery {

/// Which buttons are held; the battle itself detects new presses.
struct Orders {
    bool left = false, right = false;  ///< face or walk in this direction
    bool up = false, down = false;     ///< turns the barrel
    bool fire = false;                 ///< charges while held, fires on release
    bool weapon = false;               ///< switches to the next weapon
    friend bool operator==(const Orders&, const Orders&) = default;
};

/// The bits of the game's actions, in this order.
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
