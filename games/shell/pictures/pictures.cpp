// SPDX-License-Identifier: MIT
#include <games/shell/pictures/pictures.h>

#include <fmt/format.h>

#include <array>
#include <filesystem>

#include <games/frame/source.h>
#include <games/shell/headless/screenshots.h>

namespace plumb::games {
namespace {

constexpr std::array sizes = {PixelSize{640, 360}, PixelSize{1280, 720}, PixelSize{1920, 1080}};
constexpr std::int64_t titleTicks = 300;  ///< until the game behind the title has been going on for a while [ticks]
constexpr std::int64_t longest = 5 * 60 * 60;  ///< of a round [ticks]

/// Goes through the screens of a session and writes pictures of them.
class Tour {
public:
    Tour(const GameInfo& info, const std::string& folder)
        : folder_(folder), session_(info, {.scores = {4200, 3150, 2700, 1200, 800}}) {
        if (info.computer) computer_ = computerSource(info);
    }

    std::vector<std::string> run() {
        for (int tick = 0; tick < titleTicks; ++tick) session_.update(0);
        look("title");
        tap("confirm");
        for (const int second : {1, 5, 20, 60}) playUntil(second);
        session_.showDebug(true);
        look("debug");
        session_.showDebug(false);
        if (session_.screen() == Screen::Play) pause();
        end();
        return std::move(files_);
    }

private:
    void look(const std::string& screen) {
        for (const PixelSize size : sizes) {
            files_.push_back(
                fmt::format("{}/{}-{}-{}x{}.png", folder_, session_.info().name, screen, size.width, size.height));
            writeScreenshot(session_, painter_, size, files_.back());
        }
    }

    void tap(const std::string& action) {
        session_.update(session_.actions().button(action));
        session_.update(0);
    }

    void update() { session_.update(computer_ ? computer_->next(session_).value_or(0) : 0); }

    void playUntil(int second) {
        const std::int64_t until = start_ + second * 60;
        while (session_.ticks() < until && session_.screen() == Screen::Play) update();
        if (session_.screen() == Screen::Play) look(fmt::format("play-{:02}s", second));
    }

    void pause() {
        tap("pause");
        look("pause");
        tap("pause");
    }

    /// Reaches the round's end by playing, or else by pressing nothing; then goes on to the best scores. If the round
    /// does not end, it goes there through the title.
    void end() {
        while (computer_ && session_.screen() == Screen::Play && session_.ticks() < longest) update();
        while (session_.screen() == Screen::Play && session_.ticks() < 2 * longest) session_.update(0);
        if (session_.screen() == Screen::Over) {
            for (int tick = 0; tick < 60; ++tick) session_.update(0);
            look("over");
            tap("down");
            tap("confirm");
        } else {
            for (const char* action : {"pause", "up", "confirm", "up", "up", "confirm"}) tap(action);
        }
        look("scores");
    }

    std::string folder_;
    Session session_;
    std::unique_ptr<Source> computer_;
    Painter painter_;
    std::int64_t start_ = titleTicks + 2;
    std::vector<std::string> files_;
};

}  // namespace

std::vector<std::string> writePictures(const GameInfo& info, const std::string& folder) {
    std::filesystem::create_directories(folder);
    return Tour(info, folder).run();
}

}  // namespace plumb::games
