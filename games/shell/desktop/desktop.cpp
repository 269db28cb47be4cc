// SPDX-License-Identifier: MIT
#include <games/shell/desktop/desktop.h>

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <iostream>
#include <thread>

#include <games/shell/cairo/kept_painter.h>
#include <games/shell/desktop/devices.h>
#include <games/shell/desktop/frame_times.h>
#include <games/shell/desktop/scores_file.h>
#include <games/shell/desktop/sound.h>
#include <games/shell/desktop/window.h>
#include <games/shell/headless/screenshots.h>
#include <plumb/stepping/clock.h>

namespace plumb::games {
namespace {

using Time = std::chrono::steady_clock;

double secondsBetween(Time::time_point from, Time::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

int paintingThreads() {
    constexpr unsigned most = 4;  // each thread goes through all marks
    return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, most));
}

/// One run of the program, from opening the window to closing it.
class Desktop {
public:
    Desktop(const GameInfo& info, const SessionSetup& setup, Source* source, const ProgramOptions& options)
        : options_(options),
          source_(source),
          session_(info, setup),
          record_{info.name, setup.seed, setup.options},
          window_(info.title, options.size),
          screenshots_(options.screenshots, options.size) {
        session_.showDebug(options.debug);
    }

    Record run() {
        Time::time_point before = Time::now();
        while (!over_) {
            handleEvents();
            const Time::time_point now = Time::now();
            const Ticks ticks = clock_.advance(secondsBetween(before, now));
            for (int i = 0; i < ticks.due && !over_; ++i) update();
            if (!window_.hidden()) paint(ticks.fraction);
            times_.addFrame(secondsBetween(now, Time::now()), secondsBetween(before, now));
            before = now;
            if (!window_.waits() || window_.hidden()) waitForDisplay(now);
            window_.show();
        }
        record_.hash = session_.hash();
        return record_;
    }

    const FrameTimes& times() const { return times_; }
    const Session& session() const { return session_; }

private:
    void handleEvents() {
        SDL_Event event;
        while (SDL_PollEvent(&event) != 0) {
            devices_.handle(event);
            if (event.type == SDL_QUIT) over_ = true;
            if (event.type == SDL_KEYDOWN && event.key.repeat == 0) handleKey(event.key.keysym);
            if (event.type == SDL_MOUSEBUTTONDOWN && event.button.button == SDL_BUTTON_LEFT) click(event.button);
            if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_FOCUS_LOST) loseFocus();
        }
    }

    void handleKey(const SDL_Keysym& key) {
        switch (key.sym) {
            case SDLK_F1: session_.showDebug(!session_.debugShown()); break;
            case SDLK_F2: timesShown_ = !timesShown_; break;
            case SDLK_F3: writePicture(); break;
            case SDLK_F4: sound_.toggleMute(); break;
            case SDLK_F11: window_.toggleFullscreen(); break;
            default: break;
        }
    }

    /// In a menu it presses what chooses the entry, one button a tick.
    void click(const SDL_MouseButtonEvent& at) {
        if (source_ != nullptr || !clicks_.empty()) return;
        for (const Buttons press : session_.pressesAt(window_.pixelAt(at.x, at.y), window_.size(), footer()))
            clicks_.push_back(press);
    }

    void loseFocus() {
        devices_.releaseAll();
        pauses_ = source_ == nullptr;
    }

    void writePicture() {
        const std::string file = fmt::format("plumb-{}-{}.png", session_.info().name, session_.ticks());
        writeScreenshot(session_, painter_, window_.size(), file);
        std::cerr << "plumb-" << session_.info().name << ": wrote " << file << '\n';
    }

    std::optional<Buttons> buttons() {
        if (source_ != nullptr) return source_->next(session_);
        Buttons now = devices_.take(session_.actions());
        if (!clicks_.empty()) {
            now = clicks_.front();
            clicks_.pop_front();
        }
        // As a button, so that the record contains it.
        if (std::exchange(pauses_, false) && session_.screen() == Screen::Play)
            now |= session_.actions().button("pause");
        return now;
    }

    void update() {
        screenshots_.take(session_);
        const std::optional<Buttons> now = buttons();
        over_ = !now || (options_.ticks && session_.ticks() >= *options_.ticks);
        if (over_) return;
        const Time::time_point before = Time::now();
        session_.update(*now);
        times_.addTick(secondsBetween(before, Time::now()));
        record_.add(*now);
        for (const Cue& cue : session_.takeCues()) sound_.play(cue);
        if (session_.ended()) over_ = true;
    }

    void paint(double between) {
        Canvas canvas(window_.size(), between);
        session_.draw(canvas, footer());
        window_.paint([&](const PixelView& pixels) { windowPainter_.paint(canvas.drawing(), pixels); });
    }

    std::vector<FooterLine> footer() const {
        if (!timesShown_) return {};
        return {times_.figures()};
    }

    /// Waits until the next picture is due. Used only if show() does not wait for the display.
    void waitForDisplay(Time::time_point now) {
        const auto interval =
            std::chrono::duration_cast<Time::duration>(std::chrono::duration<double>(1 / window_.displayRate()));
        // Counted from the last due time, so that late wake-ups do not add up.
        due_ += interval;
        if (due_ < now) due_ = now;
        std::this_thread::sleep_until(due_);
    }

    const ProgramOptions& options_;
    Source* source_;
    Sdl sdl_;
    Session session_;
    Record record_;
    Window window_;
    Devices devices_;
    std::deque<Buttons> clicks_;  ///< what the mouse has chosen in a menu, to be pressed
    Sound sound_;
    Painter painter_;
    KeptPainter windowPainter_{{.threads = paintingThreads(), .quick = true}};
    Screenshots screenshots_;
    FixedClock clock_{{.interval = tickSeconds}};
    FrameTimes times_;
    Time::time_point due_;
    bool over_ = false, timesShown_ = false, pauses_ = false;
};

}  // namespace

Record runDesktop(const GameInfo& info, const SessionSetup& setup, Source* source, const ProgramOptions& options,
                  std::ostream& out) {
    // Only scores of people are kept.
    const std::string scores = source == nullptr ? scoresFileOf(info.name) : std::string();
    SessionSetup withScores = setup;
    withScores.scores = readScores(scores);
    Desktop desktop(info, withScores, source, options);
    Record record = desktop.run();
    if (desktop.session().rounds() > 0) writeScores(scores, desktop.session().scores());
    if (options.times) out << desktop.times().summary() << '\n';
    return record;
}

}  // namespace plumb::games
