// SPDX-License-Identifier: MIT
// Which buttons control the hero?
#pragma once
#include <vector>

#include <games/frame/action.h>
#include <plumb/movers/platform_mover.h>

namespace plumb::games::runner {

/// Bits of Buttons, in the order of actions().
inline constexpr Buttons leftButton = 1, rightButton = 2, jumpButton = 4, runButton = 8, downButton = 16;

inline std::vector<Action> actions() {
    return {{"left", {Key::Left, Key::A}, {Pad::Left}, "go"},
            {"right", {Key::Right, Key::D}, {Pad::Right}, "go"},
            {"jump", {Key::Space, Key::Z, Key::K}, {Pad::South}, "jump, higher when held"},
            {"run", {Key::Shift, Key::X, Key::J}, {Pad::West, Pad::RightShoulder}, "run"},
            {"down", {Key::Down, Key::S}, {Pad::Down}, "with jump: through a ledge"}};
}

/// The same buttons as input of the kit's mover.
inline PlatformInput platformInput(Buttons buttons) {
    const auto held = [buttons](Buttons button) { return (buttons & button) != 0; };
    return {.move = static_cast<double>(held(rightButton)) - static_cast<double>(held(leftButton)),
            .run = held(runButton),
            .jump = held(jumpButton),
            .down = held(downButton)};
}

}  // namespace plumb::games::runner
