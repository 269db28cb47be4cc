// SPDX-License-Identifier: MIT
// How does a game of three levels run, with lives and points?
#pragma once
#include <memory>
#include <vector>

#include <games/frame/game.h>
#include <games/frame/pose_trail.h>
#include <games/runner/effects.h>
#include <games/runner/stage.h>
#include <games/runner/view.h>

namespace plumb::games::runner {

class Runner final : public Game {
public:
    /// Throws std::invalid_argument when the level file is not a valid level.
    explicit Runner(const GameSetup& setup);

    void update(const Input& input) override;
    void draw(Canvas& canvas) const override;
    Progress progress() const override { return progress_; }
    std::uint64_t hash() const override;
    const World* world() const override { return &stage_->world(); }

    const Stage& stage() const { return *stage_; }
    bool isPlaying() const { return part_ == Part::Play; }
    int levelNumber() const { return static_cast<int>(number_); }  ///< from 0
    int lives() const { return lives_; }

private:
    /// The parts of a level, in this order.
    enum class Part { Intro, Play, Dying, Cleared };

    void enter(Part part);
    void beginLevel();
    void updatePlay(const Input& input);
    void hear(const Event& event);
    void takeCoins(int coins);
    void clear();
    void goOn();
    void drawCurtain(Canvas& canvas, const Vec2& hero) const;
    void drawCards(Canvas& canvas) const;

    GameSetup setup_;
    std::vector<std::shared_ptr<const Level>> levels_;
    std::size_t number_ = 0;
    std::unique_ptr<Stage> stage_;
    Part part_ = Part::Intro;
    int partTicks_ = 0;
    Progress progress_;
    int lives_ = 4;
    int coins_ = 0;
    std::vector<bool> suns_;       ///< of this level
    std::int64_t levelTicks_ = 0;  ///< played in this level
    int timeBonus_ = 0, sunBonus_ = 0;

    // Only for the picture.
    Effects effects_;
    View view_;
    PoseTrail trail_;
};

}  // namespace plumb::games::runner
