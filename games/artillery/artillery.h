// SPDX-License-Identifier: MIT
// How does the frame run a battle of two crews on a hilly island?
#pragma once
#include <games/artillery/draw.h>
#include <games/artillery/effects.h>
#include <games/artillery/eye.h>
#include <games/artillery/hud.h>
#include <games/artillery/match.h>
#include <games/frame/pose_trail.h>
#include <plumb/math/random.h>

namespace plumb::games::artillery {

class Artillery final : public Game {
public:
    /// Throws std::invalid_argument when the option rival has an unknown value.
    explicit Artillery(const GameSetup& setup);

    void update(const Input& input) override;
    void draw(Canvas& canvas) const override;
    Progress progress() const override { return match_.progress(); }
    std::string verdict() const override;
    std::uint64_t hash() const override;
    const World* world() const override { return &match_.battle().world(); }

    const Match& match() const { return match_; }

private:
    void notice(const std::vector<Happening>& happenings);
    void drawWriting(Canvas& canvas, const Arrangement& arrangement, const Figures& figures) const;
    void drawEnd(Canvas& canvas) const;

    void celebrate();

    Match match_;
    int line_;       ///< length of the aim line [ticks]
    int still_ = 0;  ///< remaining pause after a blast; the pause makes the blast feel heavy [ticks]
    // Only for the picture:
    PoseTrail trail_;
    Eye eye_;
    Effects effects_;
    Traces traces_;
    Answer answer_;
    std::int64_t ticks_ = 0;
    double recoil_ = 0, drift_ = 0;  ///< drift: how far the wind has blown [m]
    Random sparks_{3};
};

GameInfo info();

}  // namespace plumb::games::artillery
