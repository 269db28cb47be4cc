// SPDX-License-Identifier: MIT
// What does a display show whose frames are not the steps of the run?
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <compare/engine/engine.h>
#include <plumb/math/random.h>
#include <plumb/stepping/clock.h>

namespace plumb::compare {

/// How long the frames of a display are, one after the other.
struct FrameSettings {
    double framesPerSecond = 60;  ///< > 0, in the mean [1/s]
    double unevenness = 0;        ///< 0: all are equally long; u: from 1 - u to 1 + u times the mean; below 1 [-]
    double interval = 0;          ///< of the fixed clock; 0: no clock, a step is as long as its frame [s]
    bool isInterpolated = true;   ///< with a clock: what is shown lies between the last two ticks
};

/// Moves by one step of a length [s], and the states of its bodies.
struct Stepped {
    std::function<void(double)> step;
    std::function<std::vector<BodyState>()> states;
};

/// The loop of a game: it runs frame by frame, with a step as long as the frame, or with a clock that says how many
/// ticks are due.
class FramedLoop {
public:
    /// clock: without one, a step is as long as its frame.
    explicit FramedLoop(Stepped stepped, const std::optional<ClockSettings>& clock = std::nullopt,
                        bool isInterpolated = true);

    /// A frame of this length [s].
    void frame(double length);
    const std::vector<BodyState>& shown() const { return shown_; }
    std::int64_t ticks() const { return clock_ ? clock_->tick() : frames_; }

private:
    Stepped stepped_;
    std::optional<FixedClock> clock_{};
    bool isInterpolated_;
    std::vector<BodyState> before_{}, shown_{};
    std::int64_t frames_ = 0;
};

/// The same engine, run frame by frame: at each tick of the scene it shows what the display shows then. The card is the
/// new engine's; defaults are its numbers where a scene says nothing: framesPerSecond, unevenness and, if there is a
/// clock, interval and interpolated.
Engine framed(const Engine& inner, EngineCard card, const FrameSettings& defaults);

}  // namespace plumb::compare
