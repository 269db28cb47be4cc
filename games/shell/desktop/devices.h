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

/// Keyboard and gamepads, told of by SDL's events. Nothing is lost: what is pressed and let go within a tick is down
/// for one, and what goes down twice, twice.
class Devices {
public:
    void handle(const SDL_Event& event);
    Buttons take(const ActionList& actions);  ///< of the next tick
    void releaseAll();                        ///< the window lost its focus, and will not be told of what is let go

private:
    static constexpr std::size_t keyCount = static_cast<std::size_t>(Key::Digit9) + 1;
    static constexpr std::size_t padCount = static_cast<std::size_t>(Pad::Back) + 1;
    struct Closer {
        void operator()(SDL_GameController* pad) const { SDL_GameControllerClose(pad); }
    };

    /// A key or button: the keys come first, the gamepads' buttons behind them.
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

    Set down_;                    ///< as of the last tick
    Set told_;                    ///< as of the last event
    std::deque<Change> waiting_;  ///< from the one to the other
    std::map<SDL_JoystickID, std::unique_ptr<SDL_GameController, Closer>> open_;
};

}  // namespace plumb::games
