// SPDX-License-Identifier: MIT
// What is each lab?
#pragma once
#include <compare/lab/lab.h>

namespace plumb::compare {

Lab frameRate();        // frame_rate.cpp
Lab integrators();      // integrators.cpp
Lab broadPhases();      // broad_phases.cpp
Lab bulletAndWindow();  // bullet_and_window.cpp
Lab forecasts();        // forecast.cpp

}  // namespace plumb::compare
