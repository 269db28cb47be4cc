// SPDX-License-Identifier: MIT
// How does a whole game run, through all its levels and lives?
#pragma once
#include <array>
#include <vector>

#include <games/frame/game.h>
#include <games/maze/chase.h>
#include <games/maze/steering.h>

namespace plumb::games::maze {

/// The current part of the game. The mouse and the cats move only in Play.
enum class Phase : std::uint8_t { Intro, Ready, Play, Caught, Dying, Cleared };

/// An event of the last second that is still drawn.
struct Trace {
    ChaseEvent event;
    int age = 0;  ///< [ticks]

    static constexpr int longest = 60;  ///< [ticks]
};

/// The positions one tick before, for smooth drawing. They are not part of the rules.
struct Trail {
    Vec2 player{0, 0};
    std::array<Vec2, 4> hunters;
};

class MazeGame final : public Game {
public:
    explicit MazeGame(const GameSetup& setup);

    void update(const Input& input) override;
    void draw(Canvas& canvas) const override;
    void drawDebug(Canvas& canvas) const override;
    std::vector<std::string> debugFigures() const override;
    Progress progress() const override { return progress_; }
    std::string verdict() const override;  ///< who caught the mouse
    std::uint64_t hash() const override;

    const Chase& chase() const { return chase_; }
    Phase phase() const { return phase_; }
    int phaseTicks() const { return phaseTicks_; }  ///< since it began
    std::int64_t ticks() const { return ticks_; }
    int level() const { return level_; }
    int lives() const { return lives_; }  ///< including the current one
    std::int64_t score() const { return progress_.score; }
    const std::vector<Trace>& traces() const { return traces_; }
    const Trail& trail() const { return trail_; }
    int sinceExtraLife() const { return sinceExtraLife_; }              ///< [ticks]; large if there was none
    const std::vector<int>& fruitEaten() const { return fruitEaten_; }  ///< kinds, in the order eaten

    static int ticksOf(Phase phase);

private:
    void begin(Phase phase);
    void endPhase();
    void nextLevel();
    void nextLife();
    void runChase(std::optional<Direction> wanted);
    void take(const ChaseEvent& event);
    void win(const ChaseEvent& event);
    void keepTrail();
    void hum();

    std::uint64_t seed_;
    int levelsToWin_;  ///< 0: no limit
    int cleared_ = 0;
    int level_;
    int lives_ = 3;
    Chase chase_;
    Steering steering_;
    Phase phase_ = Phase::Intro;
    int phaseTicks_ = 0;
    std::int64_t ticks_ = 0;
    Progress progress_;
    std::vector<Trace> traces_;
    std::vector<int> fruitEaten_;
    Trail trail_;
    int sinceExtraLife_ = 1'000'000;
    int dotsHeard_ = 0;
    int humRest_ = 0;  ///< until the next beat [ticks]
};

GameInfo info();

}  // namespace plumb::games::maze
