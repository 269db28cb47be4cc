// SPDX-License-Identifier: MIT
// How does a player get from the title into a round, through pauses to its end, and into the next round?
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <games/frame/footer.h>
#include <games/frame/game.h>

namespace plumb::games {

enum class Screen { Title, Play, Pause, Over, Scores };

struct SessionSetup {
    std::uint64_t seed = 1;                        ///< of the first round; the seeds of later rounds follow from it
    std::map<std::string, std::string> options{};  ///< values that differ from those in GameInfo
    std::vector<std::int64_t> scores{};            ///< the best scores of earlier sessions
};

/// Runs a program from its start to its end, by ticks and buttons alone. The same setup and buttons give the same bits,
/// through all screens and rounds.
class Session {
public:
    /// Throws std::invalid_argument on an option that the game does not have, or a value that it cannot have.
    Session(const GameInfo& info, const SessionSetup& setup);
    ~Session();

    void update(Buttons buttons);  ///< one tick
    /// The lines of the footer stand below the picture. The debug view puts lines of its own before them.
    void draw(Canvas& canvas, std::vector<FooterLine> footer = {}) const;
    std::vector<Cue> takeCues();

    /// The buttons that choose the menu's entry at a point of the window, tick by tick. The left half of an option
    /// takes the value before, the right half the next one. Empty where there is no entry. footer: as draw()
    /// had it.
    std::vector<Buttons> pressesAt(const Vec2& pixel, PixelSize size, std::vector<FooterLine> footer = {}) const;

    Screen screen() const;
    const ActionList& actions() const;  ///< the meaning of each bit of the buttons
    const GameInfo& info() const;
    std::int64_t ticks() const;  ///< updates so far
    bool ended() const;          ///< the player chose Quit in the title

    int rounds() const;                  ///< that have begun
    const GameSetup& gameSetup() const;  ///< of the last round, or of the first; with the options chosen since then
    const Game* game() const;            ///< the last round; null before the first
    Progress progress() const;           ///< of the last round
    std::uint64_t hash() const;          ///< of the last round, and of the session itself
    /// The best scores of all rounds and of earlier sessions, the best first; ten at most.
    const std::vector<std::int64_t>& scores() const;

    /// Sets the keys that the title lists for one of the game's actions, after a player has chosen others.
    void listKeys(int action, std::vector<Key> keys);
    void showDebug(bool shown);  ///< draws what the kit sees over the game; not in a record
    bool debugShown() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace plumb::games
