// SPDX-License-Identifier: MIT
// What is each lab? What a lab tests can be replaced: so it can be shown that a wrong version fails.
#pragma once
#include <functional>
#include <span>
#include <vector>

#include <compare/lab/builtin/methods.h>
#include <compare/lab/builtin/parts.h>
#include <compare/lab/lab.h>
#include <plumb/broad/broad_phase.h>
#include <plumb/record/forecast.h>
#include <plumb/stepping/clock.h>

namespace plumb::compare {

/// The method of a beginner's game: v += a dt, x += v dt.
Method textbookMethod();

/// frame_rate.cpp; the default interval is the lecture's.
Lab frameRate(const ClockSettings& clock = {.interval = 0.02}, const Method& textbook = textbookMethod());

/// integrators.cpp
Lab integrators(const std::vector<Method>& methods = knownMethods());

/// convergence.cpp; oneStep turns each engine into the one that is run.
Lab convergence(const std::function<Engine(const Engine&)>& oneStep = withOneSubStep);

/// broad_phases.cpp
using PairFinder = std::function<PairSearch(BroadPhase sweep, std::span<const Aabb> boxes)>;
Lab broadPhases(const PairFinder& find = findPairs);

/// Is the bullet seen to touch the window in one of so many frames? The scene has the window, which is fixed, and the
/// bullet.
using FrameTest = std::function<bool(const Scene& scene, int frames)>;
struct FrameTests {
    FrameTest overlapAtEnd, bisection, swept;
};
FrameTests lectureTests();

/// bullet_and_window.cpp
Lab bulletAndWindow(const FrameTests& tests = lectureTests());

/// flush_tiles.cpp
Lab flushTiles();

/// The forecast as the kit makes it.
Forecast foretold(const World& world, const BodyDef& shot, int ticks, double dt);

/// forecast.cpp
using Forecaster = std::function<Forecast(const World& world, const BodyDef& shot, int ticks, double dt)>;
Lab forecasts(const Forecaster& foretell = foretold);

}  // namespace plumb::compare
