// SPDX-License-Identifier: MIT
// How many ticks of a fixed interval are due, independent of the display rate?
#pragma once
#include <concepts>
#include <cstdint>

#include <plumb/math/overload.h>

namespace plumb {

struct ClockSettings {
    double interval = 1.0 / 60;  ///< between two ticks, from 1e-6 to 1e6 [s]
    /// The longest real time that one call accepts; more is lost, so that a stall does not cause a burst of ticks that
    /// stalls again [s]. Source: Fiedler, "Fix your timestep!", 2004.
    double longestElapsed = 0.25;
    double timeScale = 1;  ///< time scale, below 1 for slow motion, >= 0 [-]
};

struct Ticks {
    int due = 0;          ///< steps to make now
    double fraction = 0;  ///< elapsed fraction of the interval after the last of them, from 0 to below 1 [-]
    double lost = 0;      ///< real time left out because it was more than longestElapsed [s]
};

/// A clock that counts ticks. T is the accumulated time: each elapsed time, limited to longestElapsed, times the time
/// scale, and nothing while the clock is paused [s]; tick n is due as soon as
///   T + 1 ns >= n interval
/// Elapsed times of 1/60 s, rounded to doubles, add up to slightly too little: the nanosecond keeps them from delaying
/// an exact tick, until the error is larger, after 50 days at the earliest. T itself is stored with twice a double's
/// precision, so rounding does not accumulate. Test: "0.02 s is due 150 times in exactly 3 s at 24, 25, 60, 75, 144 and
/// 240 Hz"
class FixedClock {
public:
    /// Throws std::invalid_argument that names the field; more than a million ticks at once are refused as well.
    explicit FixedClock(const ClockSettings& settings = {});
    explicit FixedClock(detail::EmptyBraces) : FixedClock() {}
    template <std::floating_point Number>
    explicit FixedClock(Number) {
        static_assert(detail::never<Number>, "name the interval: write FixedClock({.interval = 1.0 / 60})");
    }

    /// Adds the real time since the last call [s]. Throws std::invalid_argument, and changes nothing, when it is
    /// negative or not finite.
    Ticks advance(double elapsed);

    void pause() { paused_ = true; }
    void resume() { paused_ = false; }
    bool paused() const { return paused_; }
    /// One more tick is due at the next call of advance; on a paused clock, only that one.
    void singleStep() { ++singleSteps_; }
    void setTimeScale(double timeScale);  ///< throws as the constructor [-]

    double interval() const { return settings_.interval; }                           ///< to step a world by [s]
    double timeScale() const { return settings_.timeScale; }                         ///< [-]
    std::int64_t tick() const { return tick_; }                                      ///< ticks due so far
    double time() const { return static_cast<double>(tick_) * settings_.interval; }  ///< of them: rounded once [s]

private:
    ClockSettings settings_;
    double since_ = 0, sinceLow_ = 0;  ///< since the last tick, as a sum of two; from -1 ns [s]
    std::int64_t tick_ = 0;
    int singleSteps_ = 0;
    bool paused_ = false;
};

}  // namespace plumb
