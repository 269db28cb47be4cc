// SPDX-License-Identifier: MIT
// Where do the eyes look, and how does the hero look just now? Nothing comes of it.
#pragma once
#include <games/frame/game.h>
#include <games/runner/stage.h>

namespace plumb::games::runner {

class View {
public:
    void reset(const Stage& stage);
    void hear(const Event& event);
    void update(const Stage& stage);  ///< one tick

    Camera camera(double between) const;
    double squash() const { return squash_; }  ///< of the hero: above 0 it is flat and wide, below tall and thin [-]
    double lean() const { return lean_; }      ///< of its flame, against where it goes [-]
    double stride() const { return stride_; }  ///< how far it walked [m]
    double pace() const { return pace_; }      ///< of it, along x; 0 while the stage stands still [m/s]
    /// That the stage has gone on; less than ticks() tells, for it stands still behind a card [s].
    double stageTime(double between) const;
    int ticks() const { return ticks_; }

private:
    Vec2 before_{0, 0}, center_{0, 0};
    double floor_ = 0;  ///< on which the eyes rest [m]
    double ahead_ = 0;
    double squash_ = 0, squashSpeed_ = 0;
    double lean_ = 0, stride_ = 0, shake_ = 0;
    double pace_ = 0;
    std::int64_t stageTicks_ = 0;
    bool moves_ = false;  ///< the stage, in the last tick
    int ticks_ = 0;
};

}  // namespace plumb::games::runner
