// SPDX-License-Identifier: MIT
#include <games/shell/desktop/devices.h>

#include <algorithm>
#include <array>
#include <optional>

namespace plumb::games {
namespace {

struct KeyCode {
    SDL_Scancode code;
    Key key;
};

// A key is known by its position, not by its letter: the keys WASD lie together on any keyboard.
constexpr std::array keyCodes = {
    KeyCode{SDL_SCANCODE_LEFT, Key::Left},      KeyCode{SDL_SCANCODE_RIGHT, Key::Right},
    KeyCode{SDL_SCANCODE_UP, Key::Up},          KeyCode{SDL_SCANCODE_DOWN, Key::Down},
    KeyCode{SDL_SCANCODE_SPACE, Key::Space},    KeyCode{SDL_SCANCODE_RETURN, Key::Enter},
    KeyCode{SDL_SCANCODE_KP_ENTER, Key::Enter}, KeyCode{SDL_SCANCODE_ESCAPE, Key::Escape},
    KeyCode{SDL_SCANCODE_TAB, Key::Tab},        KeyCode{SDL_SCANCODE_BACKSPACE, Key::Backspace},
    KeyCode{SDL_SCANCODE_LSHIFT, Key::Shift},   KeyCode{SDL_SCANCODE_RSHIFT, Key::Shift},
    KeyCode{SDL_SCANCODE_LCTRL, Key::Control},  KeyCode{SDL_SCANCODE_RCTRL, Key::Control},
    KeyCode{SDL_SCANCODE_MINUS, Key::Minus},    KeyCode{SDL_SCANCODE_KP_MINUS, Key::Minus},
    KeyCode{SDL_SCANCODE_EQUALS, Key::Plus},    KeyCode{SDL_SCANCODE_KP_PLUS, Key::Plus},
    KeyCode{SDL_SCANCODE_COMMA, Key::Comma},    KeyCode{SDL_SCANCODE_PERIOD, Key::Period},
    KeyCode{SDL_SCANCODE_0, Key::Digit0},
};

/// Maps a range of keys that SDL and the frame have in the same order.
std::optional<Key> inRun(SDL_Scancode code, SDL_Scancode first, SDL_Scancode last, Key key) {
    if (code < first || code > last) return std::nullopt;
    return static_cast<Key>(static_cast<int>(key) + (code - first));
}

std::optional<Key> keyOf(SDL_Scancode code) {
    if (const auto letter = inRun(code, SDL_SCANCODE_A, SDL_SCANCODE_Z, Key::A)) return letter;
    if (const auto digit = inRun(code, SDL_SCANCODE_1, SDL_SCANCODE_9, Key::Digit1)) return digit;
    const auto found = std::ranges::find(keyCodes, code, &KeyCode::code);
    return found == keyCodes.end() ? std::nullopt : std::optional(found->key);
}

std::optional<Pad> padOf(int button) {
    switch (button) {
        case SDL_CONTROLLER_BUTTON_DPAD_LEFT: return Pad::Left;
        case SDL_CONTROLLER_BUTTON_DPAD_RIGHT: return Pad::Right;
        case SDL_CONTROLLER_BUTTON_DPAD_UP: return Pad::Up;
        case SDL_CONTROLLER_BUTTON_DPAD_DOWN: return Pad::Down;
        case SDL_CONTROLLER_BUTTON_A: return Pad::South;
        case SDL_CONTROLLER_BUTTON_B: return Pad::East;
        case SDL_CONTROLLER_BUTTON_X: return Pad::West;
        case SDL_CONTROLLER_BUTTON_Y: return Pad::North;
        case SDL_CONTROLLER_BUTTON_LEFTSHOULDER: return Pad::LeftShoulder;
        case SDL_CONTROLLER_BUTTON_RIGHTSHOULDER: return Pad::RightShoulder;
        case SDL_CONTROLLER_BUTTON_START: return Pad::Start;
        case SDL_CONTROLLER_BUTTON_BACK: return Pad::Back;
        default: return std::nullopt;
    }
}

}  // namespace

void Devices::change(std::size_t which, bool down) {
    if (told_[which] == down) return;
    told_[which] = down;
    waiting_.push_back({which, down});
}

void Devices::setKey(SDL_Scancode code, bool down) {
    if (const auto key = keyOf(code)) change(placeOf(*key), down);
}

void Devices::setPad(Pad pad, bool down) {
    change(placeOf(pad), down);
}

void Devices::setAxis(const SDL_ControllerAxisEvent& event) {
    constexpr int far = 16384;  // half of the range: a diagonal, at 0.7 of it on both axes, is both directions
    switch (event.axis) {
        case SDL_CONTROLLER_AXIS_LEFTX:
            setPad(Pad::Left, event.value < -far);
            setPad(Pad::Right, event.value > far);
            break;
        case SDL_CONTROLLER_AXIS_LEFTY:
            setPad(Pad::Up, event.value < -far);
            setPad(Pad::Down, event.value > far);
            break;
        case SDL_CONTROLLER_AXIS_TRIGGERLEFT: setPad(Pad::LeftTrigger, event.value > far); break;
        case SDL_CONTROLLER_AXIS_TRIGGERRIGHT: setPad(Pad::RightTrigger, event.value > far); break;
        default: break;
    }
}

void Devices::handle(const SDL_Event& event) {
    switch (event.type) {
        case SDL_KEYDOWN:
            if (event.key.repeat == 0) setKey(event.key.keysym.scancode, true);
            break;
        case SDL_KEYUP: setKey(event.key.keysym.scancode, false); break;
        case SDL_CONTROLLERBUTTONDOWN:
        case SDL_CONTROLLERBUTTONUP:
            if (const auto pad = padOf(event.cbutton.button)) setPad(*pad, event.type == SDL_CONTROLLERBUTTONDOWN);
            break;
        case SDL_CONTROLLERAXISMOTION: setAxis(event.caxis); break;
        case SDL_CONTROLLERDEVICEADDED:
            if (SDL_GameController* pad = SDL_GameControllerOpen(event.cdevice.which))
                open_[SDL_JoystickInstanceID(SDL_GameControllerGetJoystick(pad))].reset(pad);
            break;
        case SDL_CONTROLLERDEVICEREMOVED:
            open_.erase(event.cdevice.which);
            for (std::size_t pad = 0; pad < padCount; ++pad) setPad(static_cast<Pad>(pad), false);
            break;
        default: break;
    }
}

bool Devices::isDown(const Action& action) const {
    const auto down = [this](auto button) { return down_.test(placeOf(button)); };
    return std::ranges::any_of(action.keys, down) || std::ranges::any_of(action.pads, down);
}

Buttons Devices::take(const ActionList& actions) {
    Set changed;
    while (!waiting_.empty() && !changed[waiting_.front().which]) {
        const Change next = waiting_.front();
        waiting_.pop_front();
        changed[next.which] = true;
        down_[next.which] = next.down;
    }
    Buttons buttons = 0;
    for (int i = 0; i < actions.size(); ++i)
        if (isDown(actions[i])) buttons |= Buttons{1} << i;
    return buttons;
}

void Devices::releaseAll() {
    for (std::size_t which = 0; which < told_.size(); ++which) change(which, false);
}

}  // namespace plumb::games
