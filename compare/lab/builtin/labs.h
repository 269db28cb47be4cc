// SPDX-License-Identifier: MIT
// What is each lab? What it puts to the test can be exchanged, to see that a wrong one does not pass.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include <compare/lab/builtin/methods.h>
#include <compare/lab/builtin/parts.h>
#include <compare/lab/lab.h>
#include <plumb/broad/broad_phase.h>
#include <plumb/collide/sweep.h>
#include <plumb/record/forecast.h>
#include <plumb/stepping/clock.h>

namespace plumb::compare {

/// What a first game steps by: v += a dt, x += v dt.
Method textbookMethod();

/// frame_rate.cpp; the lecture's interval.
Lab frameRate(const ClockSettings& clock = {.interval = 0.02}, const Method& textbook = textbookMethod());

/// integrators.cpp
Lab integrators(const std::vector<Method>& methods = knownMethods());

/// convergence.cpp; every engine is made into another by oneStep.
Lab convergence(const std::function<Engine(const Engine&)>& oneStep = withOneSubStep);

/// broad_phases.cpp
using PairFinder = std::function<PairSearch(BroadPhase sweep, std::span<const Aabb> boxes)>;
Lab broadPhases(const PairFinder& find = findPairs);

/// Is the bullet, which goes its way through one frame, seen to touch the window, which stands?
using FrameTest = std::function<bool(const Shape& bullet, const Sweep& sweep, const Shape& window)>;
struct FrameTests {
    FrameTest overlapAtEnd, bisection, swept;
};
FrameTests lectureTests();

/// bullet_and_window.cpp
Lab bulletAndWindow(const FrameTests& tests = lectureTests());

/// flush_tiles.cpp
Lab flushTiles();

/// As the kit does it.
Forecast foretold(const World& world, const BodyDef& shot, int ticks, double dt);

/// forecast.cpp
using Forecaster = std::function<Forecast(const World& world, const BodyDef& shot, int ticks, double dt)>;
Lab forecasts(const Forecaster& foretell = foretold);

}  // namespace plumb::compare
