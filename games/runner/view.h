// SPDX-License-Identifier: MIT
// Where does the camera look, and in which pose is the hero drawn?
#pragma once
#include <games/frame/camera.h>
#include <games/frame/game.h>
#include <games/runner/stage.h>

namespace plumb::games::runner {

class View {
public:
    void reset(const Stage& stage);
    void hear(const Event& event);
    void update(const Stage& stage);  ///< one tick

    Camera camera(double between) const;
    /// The same, but closer in an upright window. screen: the visible part, in units of the screen.
    Camera cameraIn(const Aabb& screen, double between) const;
    double squash() const { return squash_; }  ///< of the hero: above 0 flat and wide, below 0 tall and thin [-]
    double lean() const { return lean_; }      ///< of its flame, away from the direction of motion [-]
    double stride() const { return stride_; }  ///< distance it has walked [m]
    double pace() const { return pace_; }      ///< its velocity along x; 0 while the stage stands still [m/s]
    /// Time that the stage has run; less than ticks() gives, because the stage stands still behind a card [s].
    double stageTime(double between) const;
    int ticks() const { return ticks_; }

private:
    Vec2 shaken(const Vec2& center) const;

    Vec2 before_{0, 0}, center_{0, 0};
    Vec2 uprightBefore_{0, 0}, upright_{0, 0};  ///< the same for an upright window
    double rows_ = 0;                           ///< height of the map [m]
    double floor_ = 0;                          ///< height that the camera follows [m]
    double ahead_ = 0;
    double squash_ = 0, squashSpeed_ = 0;
    double lean_ = 0, stride_ = 0, shake_ = 0;
    double pace_ = 0;
    std::int64_t stageTicks_ = 0;
    bool moves_ = false;  ///< did the stage advance in the last tick?
    int ticks_ = 0;
};

// Is the window upright, so that the camera comes closer and the displays are larger?

inline constexpr double uprightBand =
    104;  ///< what the displays cover at an upright window's top [units of the screen]

/// screen: the visible part, in units of the screen.
inline bool isUpright(const Aabb& screen) {
    constexpr double least = 580;  ///< height of an upright window [units of the screen]
    return screen.upper.y() - screen.lower.y() >= least;
}

}  // namespace plumb::games::runner
