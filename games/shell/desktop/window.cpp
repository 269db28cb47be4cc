// SPDX-License-Identifier: MIT
#include <games/shell/desktop/window.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace plumb::games {
namespace {

[[noreturn]] void fail(const std::string& what) {
    throw std::runtime_error(what + ": " + SDL_GetError());
}

bool isOpenGl(SDL_Renderer* renderer) {
    SDL_RendererInfo info;
    return SDL_GetRendererInfo(renderer, &info) == 0 && std::string_view(info.name).starts_with("opengl");
}

bool waitsForDisplay(SDL_Renderer* renderer) {
    SDL_RendererInfo info;
    if (SDL_GetRendererInfo(renderer, &info) != 0) return false;
    if ((info.flags & SDL_RENDERER_SOFTWARE) != 0 || (info.flags & SDL_RENDERER_PRESENTVSYNC) == 0) return false;
    return !isOpenGl(renderer) || SDL_GL_GetSwapInterval() != 0;
}

/// Is OpenGL drawn by software, as Mesa does without a graphics card? 0x1F01 is OpenGL's GL_RENDERER.
bool isCardMissing(SDL_Renderer* renderer) {
    if (!isOpenGl(renderer)) return false;
    using GetString = const unsigned char* (*)(unsigned);
    const auto get = reinterpret_cast<GetString>(SDL_GL_GetProcAddress("glGetString"));
    const unsigned char* name = get == nullptr ? nullptr : get(0x1F01);
    if (name == nullptr) return false;
    const std::string_view text(reinterpret_cast<const char*>(name));
    return text.starts_with("llvmpipe") || text.starts_with("softpipe");
}

/// A renderer that waits for the display and copies on the graphics card, if there is a card. Without one, copying the
/// pixels straight into the window takes half the time of OpenGL that is drawn by software.
SDL_Renderer* rendererOf(SDL_Window* window) {
    SDL_Renderer* renderer = SDL_CreateRenderer(window, -1, SDL_RENDERER_PRESENTVSYNC);
    if (renderer != nullptr && !isCardMissing(renderer)) return renderer;
    if (renderer != nullptr) SDL_DestroyRenderer(renderer);
    SDL_SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
    return SDL_CreateRenderer(window, -1, SDL_RENDERER_SOFTWARE);
}

}  // namespace

Sdl::Sdl() {
    if (SDL_Init(SDL_INIT_VIDEO) != 0) fail("no display (--headless needs none)");
    // Without a display, SDL may use a driver that shows nothing. That is wanted only if SDL_VIDEODRIVER is set.
    const std::string_view driver = SDL_GetCurrentVideoDriver();
    if ((driver == "offscreen" || driver == "dummy") && SDL_getenv("SDL_VIDEODRIVER") == nullptr) {
        SDL_Quit();
        throw std::runtime_error("no display (--headless needs none)");
    }
    // Its failure is ignored: a game can be played without gamepads.
    SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER);
}

Window::Window(const std::string& title, PixelSize size) {
    constexpr Uint32 flags = SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI;
    window_.reset(SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.width,
                                   size.height, flags));
    if (!window_) fail("no window");
    SDL_SetWindowMinimumSize(window_.get(), 320, 180);
    renderer_.reset(rendererOf(window_.get()));
    if (!renderer_) fail("no renderer");
    // If the driver cannot wait for the display, SDL sleeps for whole milliseconds, which do not add up to 1/60 s.
    waits_ = waitsForDisplay(renderer_.get());
    if (!waits_) SDL_RenderSetVSync(renderer_.get(), 0);
}

PixelSize Window::size() const {
    PixelSize size;
    SDL_GetRendererOutputSize(renderer_.get(), &size.width, &size.height);
    return {std::max(size.width, 1), std::max(size.height, 1)};
}

Vec2 Window::pixelAt(int x, int y) const {
    int width = 1, height = 1;
    SDL_GetWindowSize(window_.get(), &width, &height);
    const PixelSize pixels = size();
    return {(x + 0.5) * pixels.width / std::max(width, 1), (y + 0.5) * pixels.height / std::max(height, 1)};
}

double Window::displayRate() const {
    SDL_DisplayMode mode;
    const int display = SDL_GetWindowDisplayIndex(window_.get());
    if (display < 0 || SDL_GetCurrentDisplayMode(display, &mode) != 0 || mode.refresh_rate <= 0) return 60;
    return mode.refresh_rate;
}

bool Window::hidden() const {
    return (SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_MINIMIZED) != 0;
}

void Window::toggleFullscreen() {
    const bool full = (SDL_GetWindowFlags(window_.get()) & SDL_WINDOW_FULLSCREEN_DESKTOP) != 0;
    SDL_SetWindowFullscreen(window_.get(), full ? 0 : SDL_WINDOW_FULLSCREEN_DESKTOP);
}

void Window::fitTexture(PixelSize size) {
    if (size == textureSize_) return;
    texture_.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STREAMING, size.width,
                                     size.height));
    if (!texture_) fail("no texture");
    SDL_SetTextureBlendMode(texture_.get(), SDL_BLENDMODE_NONE);
    textureSize_ = size;
}

void Window::paint(const std::function<void(const PixelView&)>& paint) {
    fitTexture(size());
    void* pixels = nullptr;
    int stride = 0;
    if (SDL_LockTexture(texture_.get(), nullptr, &pixels, &stride) != 0) fail("cannot lock the window's pixels");
    paint({static_cast<std::uint32_t*>(pixels), textureSize_, stride});
    SDL_UnlockTexture(texture_.get());
    SDL_RenderCopy(renderer_.get(), texture_.get(), nullptr, nullptr);
}

void Window::show() {
    SDL_RenderPresent(renderer_.get());
}

}  // namespace plumb::games
