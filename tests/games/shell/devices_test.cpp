// SPDX-License-Identifier: MIT
#include <games/shell/desktop/devices.h>

#include "catch.h"

using namespace plumb::games;

namespace {

SDL_Event keyEvent(SDL_Scancode code, bool down, bool repeated = false) {
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.keysym.scancode = code;
    event.key.repeat = repeated ? 1 : 0;
    return event;
}

SDL_Event axisEvent(SDL_GameControllerAxis axis, Sint16 value) {
    SDL_Event event{};
    event.type = SDL_CONTROLLERAXISMOTION;
    event.caxis.axis = static_cast<Uint8>(axis);
    event.caxis.value = value;
    return event;
}

SDL_Event buttonEvent(SDL_GameControllerButton button, bool down) {
    SDL_Event event{};
    event.type = down ? SDL_CONTROLLERBUTTONDOWN : SDL_CONTROLLERBUTTONUP;
    event.cbutton.button = static_cast<Uint8>(button);
    return event;
}

const ActionList actions({{"left", {Key::Left, Key::A}, {Pad::Left}},
                          {"jump", {Key::Space}, {Pad::South}},
                          {"seven", {Key::Digit7}, {Pad::RightTrigger}},
                          {"zero", {Key::Digit0}, {Pad::Start}}});
constexpr Buttons leftButton = 1, jumpButton = 2, seven = 4, zero = 8;

/// The buttons of this number of ticks.
std::vector<Buttons> take(Devices& devices, int ticks) {
    std::vector<Buttons> taken;
    for (int i = 0; i < ticks; ++i) taken.push_back(devices.take(actions));
    return taken;
}

}  // namespace

TEST_CASE("a key is down from its tick until it is released, repeats by the keyboard are ignored", "[games]") {
    Devices devices;
    devices.handle(keyEvent(SDL_SCANCODE_LEFT, true));
    CHECK(take(devices, 2) == std::vector<Buttons>{leftButton, leftButton});
    devices.handle(keyEvent(SDL_SCANCODE_LEFT, true, true));
    devices.handle(keyEvent(SDL_SCANCODE_7, true));
    CHECK(take(devices, 1) == std::vector<Buttons>{leftButton | seven});
    devices.handle(keyEvent(SDL_SCANCODE_LEFT, false));
    CHECK(take(devices, 2) == std::vector<Buttons>{seven, seven});
}

TEST_CASE("a key pressed and released three times within a tick is down three times, for one tick each", "[games]") {
    Devices devices;
    for (int i = 0; i < 3; ++i) {
        devices.handle(keyEvent(SDL_SCANCODE_SPACE, true));
        devices.handle(keyEvent(SDL_SCANCODE_SPACE, false));
    }
    CHECK(take(devices, 7) == std::vector<Buttons>{jumpButton, 0, jumpButton, 0, jumpButton, 0, 0});
}

TEST_CASE("an action with two keys is down as long as one of them is down", "[games]") {
    Devices devices;
    devices.handle(keyEvent(SDL_SCANCODE_A, true));
    devices.handle(keyEvent(SDL_SCANCODE_LEFT, true));
    CHECK(devices.take(actions) == leftButton);
    devices.handle(keyEvent(SDL_SCANCODE_A, false));
    CHECK(devices.take(actions) == leftButton);
    devices.handle(keyEvent(SDL_SCANCODE_LEFT, false));
    CHECK(devices.take(actions) == 0);
}

TEST_CASE("letters and digits are the keys of the same names", "[games]") {
    const ActionList edges({{"a", {Key::A}}, {"z", {Key::Z}}, {"1", {Key::Digit1}}, {"9", {Key::Digit9}}});
    for (const auto& [code, bit] :
         {std::pair{SDL_SCANCODE_A, 1u}, {SDL_SCANCODE_Z, 2u}, {SDL_SCANCODE_1, 4u}, {SDL_SCANCODE_9, 8u}}) {
        Devices devices;
        devices.handle(keyEvent(code, true));
        CHECK(devices.take(edges) == bit);
    }
    Devices devices;
    devices.handle(keyEvent(SDL_SCANCODE_0, true));
    CHECK(devices.take(actions) == zero);
    devices.handle(keyEvent(SDL_SCANCODE_F12, true));  // no action has this key
    CHECK(devices.take(actions) == zero);
}

TEST_CASE("a stick beyond half of its range is a direction, a trigger is a button, and A of a gamepad is South",
          "[games]") {
    Devices devices;
    devices.handle(axisEvent(SDL_CONTROLLER_AXIS_LEFTX, -16000));
    CHECK(devices.take(actions) == 0);
    devices.handle(axisEvent(SDL_CONTROLLER_AXIS_LEFTX, -17000));
    devices.handle(axisEvent(SDL_CONTROLLER_AXIS_TRIGGERRIGHT, 30000));
    devices.handle(buttonEvent(SDL_CONTROLLER_BUTTON_A, true));
    CHECK(devices.take(actions) == (leftButton | seven | jumpButton));
    devices.handle(axisEvent(SDL_CONTROLLER_AXIS_LEFTX, 32767));
    devices.handle(buttonEvent(SDL_CONTROLLER_BUTTON_A, false));
    CHECK(devices.take(actions) == seven);
}

TEST_CASE("no key is down after a window has lost its focus", "[games]") {
    Devices devices;
    devices.handle(keyEvent(SDL_SCANCODE_LEFT, true));
    devices.handle(keyEvent(SDL_SCANCODE_SPACE, true));
    CHECK(devices.take(actions) == (leftButton | jumpButton));
    devices.releaseAll();
    CHECK(devices.take(actions) == 0);
    devices.handle(keyEvent(SDL_SCANCODE_SPACE, true));
    CHECK(devices.take(actions) == jumpButton);
}
