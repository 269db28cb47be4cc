// SPDX-License-Identifier: MIT
// What is a game?
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <games/frame/action.h>
#include <games/frame/canvas.h>
#include <games/frame/cue.h>
#include <games/frame/input.h>
#include <games/frame/player.h>

namespace plumb {
class World;
}

namespace plumb::games {

inline constexpr double tickSeconds = 1.0 / 60;  ///< between two updates

enum class Outcome { Running, Won, Lost };

struct Progress {
    Outcome outcome = Outcome::Running;
    std::int64_t score = 0;
};

/// What a game can be told as it begins: --name VALUE on the command line; with choices, no other value is taken, and
/// it is an entry of the title too.
struct Option {
    std::string name;     ///< small letters, digits and -
    std::string about{};  ///< for --help
    std::string value{};  ///< unless another is given
    std::vector<std::string> choices{};
    std::string label{};  ///< in the title; empty: its name
    bool inTitle = true;  ///< false: only the command line has it
};

struct GameSetup {
    std::uint64_t seed = 1;
    std::map<std::string, std::string> options{};  ///< each of GameInfo.options has its value here

    /// Throws std::invalid_argument when the game has no such option.
    const std::string& option(const std::string& name) const;
};

/// One round, from its start to won or lost. The same setup and inputs give the same bits: no clock, no other source of
/// chance than the setup's seed, and nothing that draw() does counts.
class Game {
public:
    virtual ~Game() = default;

    virtual void update(const Input& input) = 0;        ///< one tick
    virtual void draw(Canvas& canvas) const = 0;        ///< all of it, what is known by the players with it
    virtual Progress progress() const = 0;              ///< updates end when the outcome is no longer Running
    virtual std::string verdict() const { return {}; }  ///< at the round's end; empty: "You won" or "Game over"
    virtual std::uint64_t hash() const = 0;             ///< of all that what comes depends on
    /// For the debug view, which is drawn over draw()'s last look.
    virtual const World* world() const { return nullptr; }
    virtual void drawDebug(Canvas&) const {}  ///< what else it shows: plans, targets

    /// The cues played since the last call.
    std::vector<Cue> takeCues() { return std::exchange(cues_, {}); }

protected:
    void play(const Cue& cue) { cues_.push_back(cue); }

private:
    std::vector<Cue> cues_;
};

/// The colours of a game's menus.
struct Theme {
    Color background = Color::hex(0x14161f);
    Color panel = Color::hex(0x232738);
    Color text = Color::hex(0xf2f2ee);
    Color quiet = Color::hex(0x9aa0b5);   ///< of what is said aside
    Color accent = Color::hex(0xffc940);  ///< of what is chosen
};

struct GameInfo {
    std::string name{};  ///< the folder's; set by whoever lists the games
    std::string title{};
    std::string about{};  ///< one line
    std::vector<Action> actions{};
    std::vector<Option> options{};
    Theme theme{};
    std::function<std::unique_ptr<Game>(const GameSetup&)> make{};
    std::function<std::unique_ptr<Player>(const GameSetup&)> computer{};  ///< empty: nobody but people can play it
    /// Behind the title, so many seconds after it came up; empty: the game itself, played by the computer.
    std::function<void(Canvas&, double)> drawTitle{};
};

}  // namespace plumb::games
