// SPDX-License-Identifier: MIT
#include <games/runner/buttons.h>

namespace plumb::games::runner {

std::vector<Action> actions() {
    return {{"left", {Key::Left, Key::A}, {Pad::Left}, "go"},
            {"right", {Key::Right, Key::D}, {Pad::Right}, "go"},
            {"jump", {Key::Space, Key::Z, Key::K}, {Pad::South}, "jump, higher when held"},
            {"run", {Key::Shift, Key::X, Key::J}, {Pad::West, Pad::RightShoulder}, "run"},
            {"down", {Key::Down, Key::S}, {Pad::Down}, "with jump: through a ledge"}};
}

PlatformInput platformInput(Buttons buttons) {
    const auto held = [buttons](Buttons button) { return (buttons & button) != 0; };
    return {.move = static_cast<double>(held(rightButton)) - static_cast<double>(held(leftButton)),
            .run = held(runButton),
            .jump = held(jumpButton),
            .down = held(downButton)};
}

}  // namespace plumb::games::runner
