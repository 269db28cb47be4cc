// SPDX-License-Identifier: MIT
// How does a game get a window on the desktop?
#pragma once
#include <SDL.h>

#include <games/shell/cairo/picture.h>
#include <functional>
#include <memory>
#include <string>

namespace plumb::games {

/// Starts SDL, and ends it in the destructor. Throws std::runtime_error when there is no display.
class Sdl {
public:
    Sdl();
    ~Sdl() { SDL_Quit(); }
    Sdl(const Sdl&) = delete;
    Sdl& operator=(const Sdl&) = delete;
};

/// A window that can be resized, with pixels that fill it.
class Window {
public:
    /// Throws std::runtime_error when SDL cannot make it.
    Window(const std::string& title, PixelSize size);

    PixelSize size() const;            ///< the current size, in pixels of the display
    Vec2 pixelAt(int x, int y) const;  ///< of a point that SDL tells, which may count in larger units
    /// Calls the function, which must set all pixels; their values are undefined before that.
    void paint(const std::function<void(const PixelView&)>& paint);
    void show();                           ///< shows the painted pixels
    bool waits() const { return waits_; }  ///< does show() wait for the display?
    double displayRate() const;            ///< pictures per second of the display; 60 if unknown
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
