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

/// A setting of a game: --name VALUE on the command line. An option with choices accepts no other value, and it is an
/// entry of the title too.
struct Option {
    std::string name;     ///< small letters, digits and -
    std::string about{};  ///< for --help
    std::string value{};  ///< the default
    std::vector<std::string> choices{};
    std::string label{};  ///< its text in the title; empty: its name
    bool inTitle = true;  ///< false: it is only on the command line
};

struct GameSetup {
    std::uint64_t seed = 1;
    std::map<std::string, std::string> options{};  ///< one value for each of GameInfo.options

    /// Throws std::invalid_argument when the game has no such option.
    const std::string& option(const std::string& name) const;
};

/// One round, from its start until it is won or lost. The same setup and inputs must give the same bits: a game uses no
/// clock and no random numbers except from the setup's seed, and draw() has no effect on it.
class Game {
public:
    virtual ~Game() = default;

    virtual void update(const Input& input) = 0;        ///< one tick
    virtual void draw(Canvas& canvas) const = 0;        ///< the whole picture, with the information for players
    virtual Progress progress() const = 0;              ///< there are no more updates when the outcome is not Running
    virtual std::string verdict() const { return {}; }  ///< text at the round's end; empty: "You won" or "Game over"
    virtual std::uint64_t hash() const = 0;             ///< of everything that can change what happens next
    /// The world that the debug view shows, with the last camera of draw(); null: none.
    virtual const World* world() const { return nullptr; }
    virtual void drawDebug(Canvas&) const {}  ///< what the debug view shows besides: plans, targets
    virtual std::vector<std::string> debugFigures() const { return {}; }  ///< below the debug view, each a column

    /// The cues played since the last call.
    std::vector<Cue> takeCues() { return std::exchange(cues_, {}); }

protected:
    void play(const Cue& cue) { cues_.push_back(cue); }

private:
    std::vector<Cue> cues_;
};

/// The computer as a player. The same games, seen in the same order, give the same buttons.
class Player {
public:
    virtual ~Player() = default;
    /// The buttons of the game's next tick: bit i for action i of GameInfo.actions. The game was made by the GameInfo
    /// that made the player, so it may be cast to its own class.
    virtual Buttons decide(const Game& game) = 0;
};

/// The colours of a game's menus.
struct Theme {
    Color background = Color::hex(0x14161f);
    Color panel = Color::hex(0x232738);
    Color text = Color::hex(0xf2f2ee);
    Color quiet = Color::hex(0x9aa0b5);   ///< of less important text
    Color accent = Color::hex(0xffc940);  ///< of the chosen entry
};

struct GameInfo {
    std::string name{};  ///< the name of the game's folder; set where the games are listed
    std::string title{};
    std::string about{};  ///< one line
    std::vector<Action> actions{};
    std::vector<Option> options{};
    Theme theme{};
    bool fillsUpright = false;  ///< is as large in an upright window as in a wide one
    std::function<std::unique_ptr<Game>(const GameSetup&)> make{};
    std::function<std::unique_ptr<Player>(const GameSetup&)> computer{};  ///< empty: only people can play it
    /// Draws behind the title, this number of seconds after the title appeared. Empty: the computer plays the game
    /// there.
    std::function<void(Canvas&, double)> drawTitle{};
};

}  // namespace plumb::games
