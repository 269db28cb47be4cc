// SPDX-License-Identifier: MIT
#include <games/shell/desktop/desktop.h>

#include <SDL.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

#include <games/shell/desktop/scores_file.h>

#include "catch.h"
#include "games/counting_game.h"

using namespace plumb;
using namespace plumb::games;

namespace {

/// Chooses SDL's dummy drivers for window and sound, and a folder of the test for the scores.
void pretendDevices() {
    const std::filesystem::path scores = std::filesystem::temp_directory_path() / "scores";
    std::filesystem::create_directories(scores);
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    setenv("SDL_AUDIODRIVER", "dummy", 1);
    setenv("XDG_DATA_HOME", scores.c_str(), 1);
}

void pushKey(SDL_Scancode code, SDL_Keycode symbol, bool down) {
    SDL_Event event{};
    event.type = down ? SDL_KEYDOWN : SDL_KEYUP;
    event.key.keysym.scancode = code;
    event.key.keysym.sym = symbol;
    SDL_PushEvent(&event);
}

void tapKey(SDL_Scancode code, SDL_Keycode symbol) {
    pushKey(code, symbol, true);
    pushKey(code, symbol, false);
}

void push(Uint32 type, Uint8 windowEvent = 0) {
    SDL_Event event{};
    event.type = type;
    if (type == SDL_WINDOWEVENT) event.window.event = windowEvent;
    SDL_PushEvent(&event);
}

/// Plays in a window for a number of ticks. Keys pressed before the window opens are handled after that, in order.
Record playedFor(std::int64_t ticks) {
    std::ostringstream out;
    ProgramOptions options;
    options.size = {320, 180};
    options.ticks = ticks;
    return runDesktop(test::countingGame(), {}, nullptr, options, out);
}

/// Starts SDL before the window, so that there can be events before it. Each object is for one window.
struct Events {
    Events() {
        pretendDevices();
        SDL_Init(SDL_INIT_VIDEO);
    }
    ~Events() { SDL_Quit(); }
};

/// A record, replayed without a window.
struct Replayed {
    Session session{test::countingGame(), {}};
    std::vector<Screen> screens{Screen::Title};

    explicit Replayed(const Record& record) {
        const auto source = recordSource(record);
        while (const auto buttons = source->next(session)) {
            session.update(*buttons);
            if (session.screen() != screens.back()) screens.push_back(session.screen());
        }
    }
};

}  // namespace

TEST_CASE("a click on Play begins a round, and one beside the menu does nothing", "[games]") {
    for (const int x : {160, 5}) {
        const Events events;
        SDL_Event event{};
        event.type = SDL_MOUSEBUTTONDOWN;
        event.button.button = SDL_BUTTON_LEFT;
        event.button.x = x;
        event.button.y = 80;  // where the title's first entry is in a window of 320 x 180
        SDL_PushEvent(&event);
        const Replayed replayed(playedFor(20));
        CHECK(replayed.screens.back() == (x == 160 ? Screen::Play : Screen::Title));
    }
}

TEST_CASE("keys in a window, from the title to a won round, give the same hash when replayed without a window",
          "[games]") {
    const Events events;
    tapKey(SDL_SCANCODE_RETURN, SDLK_RETURN);
    for (int hit = 0; hit < 10; ++hit) tapKey(SDL_SCANCODE_SPACE, SDLK_SPACE);
    const Record record = playedFor(60);
    const Replayed replayed(record);
    CHECK(record.ticks() == 60);
    CHECK(replayed.session.hash() == record.hash);
    CHECK(replayed.screens == std::vector{Screen::Title, Screen::Play, Screen::Over});
    CHECK(replayed.session.progress().score == 100);
}

TEST_CASE("a window that loses its focus pauses the round, and the record contains the pause", "[games]") {
    const Events events;
    tapKey(SDL_SCANCODE_RETURN, SDLK_RETURN);
    std::thread hand([] {
        std::this_thread::sleep_for(std::chrono::seconds(1));  // long after the round began
        push(SDL_WINDOWEVENT, SDL_WINDOWEVENT_FOCUS_LOST);
    });
    const Record record = playedFor(150);
    hand.join();
    const Replayed replayed(record);
    CHECK(replayed.session.hash() == record.hash);
    CHECK(replayed.screens == std::vector{Screen::Title, Screen::Play, Screen::Pause});
}

TEST_CASE("a window that loses its focus in the title stays there", "[games]") {
    const Events events;
    push(SDL_WINDOWEVENT, SDL_WINDOWEVENT_FOCUS_LOST);
    CHECK(playedFor(20).runs == std::vector<Run>{{20, 0}});
}

TEST_CASE("quit in the title's menu closes the window", "[games]") {
    const Events events;
    tapKey(SDL_SCANCODE_UP, SDLK_UP);
    tapKey(SDL_SCANCODE_RETURN, SDLK_RETURN);
    const Record record = playedFor(600);
    CHECK(record.ticks() < 10);
    CHECK(Replayed(record).session.ended());
}

TEST_CASE("a quit event of the desktop ends the program", "[games]") {
    const Events events;
    push(SDL_QUIT);
    CHECK(playedFor(600).ticks() < 10);
}

TEST_CASE("the keys F1, F2, F4 and F11 press no button of the game", "[games]") {
    const Events events;
    for (const auto& [code, symbol] : {std::pair{SDL_SCANCODE_F1, SDLK_F1},
                                       {SDL_SCANCODE_F2, SDLK_F2},
                                       {SDL_SCANCODE_F4, SDLK_F4},
                                       {SDL_SCANCODE_F11, SDLK_F11}})
        tapKey(code, symbol);
    CHECK(playedFor(30).runs == std::vector<Run>{{30, 0}});
}

TEST_CASE("best scores are kept from one run of the program to the next", "[games]") {
    const Events events;
    const std::string file = scoresFileOf("counting");
    writeScores(file, {300, 20});
    CHECK(readScores(file) == std::vector<std::int64_t>{300, 20});
    tapKey(SDL_SCANCODE_RETURN, SDLK_RETURN);
    for (int hit = 0; hit < 10; ++hit) tapKey(SDL_SCANCODE_SPACE, SDLK_SPACE);
    playedFor(60);
    CHECK(readScores(file) == std::vector<std::int64_t>{300, 100, 20});
    std::ofstream(file) << "12\nnonsense\n\n7\n";
    CHECK(readScores(file) == std::vector<std::int64_t>{12, 7});
    CHECK(readScores("/no/such/file").empty());
}
