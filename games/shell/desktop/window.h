// SPDX-License-Identifier: MIT
// Where on the desktop is a game seen?
#pragma once
#include <SDL.h>

#include <games/shell/cairo/picture.h>
#include <functional>
#include <memory>
#include <string>

namespace plumb::games {

/// SDL, from its beginning to its end. Throws std::runtime_error when there is no display.
class Sdl {
public:
    Sdl();
    ~Sdl() { SDL_Quit(); }
    Sdl(const Sdl&) = delete;
    Sdl& operator=(const Sdl&) = delete;
};

/// A window that can be resized, and pixels that fill it.
class Window {
public:
    /// Throws std::runtime_error when SDL cannot make it.
    Window(const std::string& title, PixelSize size);

    PixelSize size() const;  ///< as it is now, in pixels of the display
    /// Lets it fill all of the pixels; what they hold before is not said.
    void paint(const std::function<void(const PixelView&)>& paint);
    void show();                           ///< what was painted
    bool waits() const { return waits_; }  ///< does show() wait for the display?
    double displayRate() const;            ///< pictures a second that the display shows; 60 where it does not say
    bool hidden() const;                   ///< minimised
    void toggleFullscreen();

private:
    template <auto destroy>
    struct Destroyer {
        template <class T>
        void operator()(T* thing) const {
            destroy(thing);
        }
    };
    void fitTexture(PixelSize size);

    std::unique_ptr<SDL_Window, Destroyer<SDL_DestroyWindow>> window_;
    std::unique_ptr<SDL_Renderer, Destroyer<SDL_DestroyRenderer>> renderer_;
    std::unique_ptr<SDL_Texture, Destroyer<SDL_DestroyTexture>> texture_;
    PixelSize textureSize_{0, 0};
    bool waits_ = false;
};

}  // namespace plumb::games
