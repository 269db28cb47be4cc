// SPDX-License-Identifier: MIT
// How does one get from the title into a game, through pauses to its end, and into the next?
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
    std::uint64_t seed = 1;                        ///< of the first round; those of the others follow from it
    std::map<std::string, std::string> options{};  ///< the game's, where they are not to be as GameInfo has them
    std::vector<std::int64_t> scores{};            ///< the best of before
};

/// All that happens between a program's start and its end, by ticks and buttons alone: the same setup and buttons give
/// the same bits, through all of its screens and rounds.
class Session {
public:
    /// Throws std::invalid_argument on an option that the game does not have, or a value that it cannot have.
    Session(const GameInfo& info, const SessionSetup& setup);
    ~Session();

    void update(Buttons buttons);  ///< one tick
    /// The footer's lines are told below the picture; those on the world, where showDebug() shows it, come first.
    void draw(Canvas& canvas, std::vector<FooterLine> footer = {}) const;
    std::vector<Cue> takeCues();

    /// What to press, tick by tick, so that a menu's entry at a point of the window is chosen; an option's left half
    /// changes it to the value before. Empty where there is no entry. pixel: of a window that has no footer.
    std::vector<Buttons> pressesAt(const Vec2& pixel, PixelSize size) const;

    Screen screen() const;
    const ActionList& actions() const;  ///< what the buttons' bits are
    const GameInfo& info() const;
    std::int64_t ticks() const;  ///< updates so far
    bool ended() const;          ///< the player left by the title's menu

    int rounds() const;                  ///< begun so far
    const GameSetup& gameSetup() const;  ///< of the last of them, or of the first; its options as chosen since
    const Game* game() const;            ///< the last of them; null before the first
    Progress progress() const;           ///< of it
    std::uint64_t hash() const;          ///< of it, and of where the session stands
    /// The best of all rounds, those of before with them, the best first; ten at most.
    const std::vector<std::int64_t>& scores() const;

    /// The keys that the title lists for the game's action of that index, where a player has chosen others.
    void listKeys(int action, std::vector<Key> keys);
    void showDebug(bool shown);  ///< the kit's view of the world over the game's; no part of what is recorded
    bool debugShown() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace plumb::games
