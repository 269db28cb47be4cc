// SPDX-License-Identifier: MIT
// Which keys and gamepad buttons are down?
#pragma once
#include <SDL.h>

#include <games/frame/action.h>
#include <bitset>
#include <deque>
#include <map>
#include <memory>

namespace plumb::games {

/// Keyboard and gamepads, from SDL's events. No press is lost: a button pressed and released within a tick is down for
/// one tick, and a button pressed twice is down twice.
class Devices {
public:
    void handle(const SDL_Event& event);
    Buttons take(const ActionList& actions);  ///< the buttons of the next tick
    void releaseAll();                        ///< for a window without focus: it gets no events of releases

private:
    static constexpr std::size_t keyCount = static_cast<std::size_t>(Key::Digit9) + 1;
    static constexpr std::size_t padCount = static_cast<std::size_t>(Pad::Back) + 1;
    struct Closer {
        void operator()(SDL_GameController* pad) const { SDL_GameControllerClose(pad); }
    };

    /// Of a key or a button; which counts the keys first, then the gamepads' buttons.
    struct Change {
        std::size_t which;
        bool down;
    };
    using Set = std::bitset<keyCount + padCount>;

    static std::size_t placeOf(Key key) { return static_cast<std::size_t>(key); }
    static std::size_t placeOf(Pad pad) { return keyCount + static_cast<std::size_t>(pad); }
    void change(std::size_t which, bool down);
    void setKey(SDL_Scancode code, bool down);
    void setPad(Pad pad, bool down);
    void setAxis(const SDL_ControllerAxisEvent& event);
    bool isDown(const Action& action) const;

    Set down_;                    ///< after the last tick
    Set told_;                    ///< after the last event
    std::deque<Change> waiting_;  ///< the changes from down_ to told_, in order
    std::map<SDL_JoystickID, std::unique_ptr<SDL_GameController, Closer>> open_;
};

}  // namespace plumb::games
